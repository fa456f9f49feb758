#pragma once

#include "composition.hpp"

namespace quell::bench {

/// What a header says beside the pipeline itself.
struct Origin {
    std::string sequence; ///< as in "scene fence"
    Extent size;
    int threads = 0;
    Bounds bounds;
    std::vector<long long> scored;
    std::string memory;                ///< a sentence on its precision
    std::vector<std::string> left_out; ///< a sentence for each effect that has no pipeline of its own
};

/// The channels that a host fills for a composition, in the order in which files list them.
[[nodiscard]] std::vector<std::string> channels_of(Composition const& composition);

/// A C++ header: namespace `fit` with the constexpr `pipeline`, the `Storage` of its memory, the names of its `channels`, and the figures
/// that were `promised`.
[[nodiscard]] std::string header_text(Composition const& composition, Origin const& origin);

} // namespace quell::bench
