#pragma once

#include "preset_code.hpp"

#include <quell/execute/outlined.hpp>

#include <algorithm>

namespace quell_library {

/// Calls function(y0, y1) for strips of so many rows, side by side, by whatever threads there are.
template <class F> void for_each_strip(Parallel const& parallel, int rows, F const& function) {
    struct Context {
        int rows, height;
        F const& function;
    };
    constexpr int most = 16, strips_per_thread = 4;
    int const height = std::clamp(rows / (strips_per_thread * std::max(parallel.threads, 1)), 1, most);
    Context const context{rows, height, function};
    auto const strip = [](void* from, std::int32_t index) {
        auto const& all = *static_cast<Context const*>(from);
        int const y = index * all.height;
        all.function(y, std::min(y + all.height, all.rows));
    };
    parallel.run(parallel.user, (rows + height - 1) / height, strip, const_cast<Context*>(&context));
}

/// The executor of compiled presets.
struct Strips {
    Parallel parallel;

    template <class Job> void for_each_pixel(quell::Region region, Job const& job) const {
        for_each_strip(parallel, region.y1 - region.y0, [&](int y0, int y1) {
            quell::Outlined<>{}.for_each_pixel({region.x0, region.y0 + y0, region.x1, region.y0 + y1}, job);
        });
        if (parallel.pass_done != nullptr) parallel.pass_done(parallel.user);
    }
};

} // namespace quell_library
