#pragma once

#include <quell/image/strided.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Image storage with a pixel's components side by side (RGBRGB...), as in most hosts. Slower than Planar on a CPU, since packs are
/// gathered.
/// @tparam Format Float32 or Float16; channels with `full_precision` use Float32 anyway
template <class Format = Float32> struct Interleaved {
    static_assert(ComponentFormat<Format>,
                  "Interleaved<Format>: `Format` must be Float32, Float16 or another format, see quell/image/format.hpp");
    using Half = Interleaved<Float16>;          ///< storage of channels with `always_half`
    using Exact = Interleaved<Float32>;         ///< storage of channels that need 32 bits
    static constexpr auto name = "interleaved"; ///< for messages
    using format = Format;                      ///< how a component is stored
    /// An image of N components.
    template <int N> using Image = detail::StridedImage<Format, N, true>;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
