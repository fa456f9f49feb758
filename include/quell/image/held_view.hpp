#pragma once

#include <quell/image/image_storage.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// An image that shows another one, and owns nothing. It is of a frame that is made of views of others' images.
/// @tparam View an ImageView
template <ImageView View> struct HeldView {
    View held{}; ///< what it shows

    explicit HeldView(Extent) {}                        ///< nothing yet
    explicit HeldView(View const& view) : held(view) {} ///< this image
    [[nodiscard]] View view() const { return held; }    ///< that kernels use
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
