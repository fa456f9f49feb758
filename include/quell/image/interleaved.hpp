#pragma once

#include <quell/image/strided.hpp>

namespace quell {

/// The components of a pixel side by side (RGBRGB...), as most hosts keep images. Packs are gathered, so it is slower than Planar on a CPU.
/// @tparam Format Float32 or Float16
template <class Format = Float32> struct Interleaved {
    using Exact = Interleaved<Float32>;
    static constexpr auto name = "interleaved";
    using format = Format;
    template <int N> using Image = detail::StridedImage<Format, N, true>;
};

} // namespace quell
