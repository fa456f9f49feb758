#pragma once

#include <quell/image/strided.hpp>

namespace quell {

/// One plane per component: neighbouring pixels are neighbours in memory, so a pack is one load. The fast storage.
/// @tparam Format Float32 or Float16
template <class Format = Float32> struct Planar {
    using Exact = Planar<Float32>;
    static constexpr auto name = "planar";
    using format = Format;
    template <int N> using Image = detail::StridedImage<Format, N, false>;
};

} // namespace quell
