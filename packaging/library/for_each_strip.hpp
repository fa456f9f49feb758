#pragma once

#include "preset_code.hpp"

#include <algorithm>

namespace quell_library {

/// Few, so that what a pass reads of a strip stays in the cache, and many beside the rows above and below that it looks at.
inline constexpr int most_rows_of_strip = 16;

/// Calls function(y0, y1) for strips of so many rows, side by side, by whatever threads there are.
template <class F> void for_each_strip(Parallel const& parallel, int rows, F const& function) {
    struct Context {
        int rows, height;
        F const& function;
    };
    constexpr int strips_per_thread = 4;
    int const height = std::clamp(rows / (strips_per_thread * std::max(parallel.threads, 1)), 1, most_rows_of_strip);
    Context const context{rows, height, function};
    auto const strip = [](void* from, std::int32_t index) {
        auto const& all = *static_cast<Context const*>(from);
        int const y = index * all.height;
        all.function(y, std::min(y + all.height, all.rows));
    };
    parallel.run(parallel.user, (rows + height - 1) / height, strip, const_cast<Context*>(&context));
}

} // namespace quell_library
