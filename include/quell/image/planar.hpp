#pragma once

#include <quell/image/strided.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Image storage of one plane per component. The fastest on a CPU: a pack of pixels is one load per component.
/// @tparam Format Float32 or Float16; channels with `full_precision` use Float32 anyway
template <class Format = Float32> struct Planar {
    static_assert(ComponentFormat<Format>,
                  "Planar<Format>: `Format` must be Float32, Float16 or another format, see quell/image/format.hpp");
    using Half = Planar<Float16>;          ///< storage of channels with `always_half`
    using Exact = Planar<Float32>;         ///< storage of channels that need 32 bits
    static constexpr auto name = "planar"; ///< for messages
    using format = Format;                 ///< how a component is stored
    /// An image of N components.
    template <int N> using Image = detail::StridedImage<Format, N, false>;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
