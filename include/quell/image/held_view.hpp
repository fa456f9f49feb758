#pragma once

#include <quell/image/image_storage.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// An image that shows another one, and owns nothing. It is of a frame that is made of views of others' images.
/// @tparam View an ImageView
template <ImageView View> struct HeldView {
    static constexpr int components = View::components; ///< per pixel

    View held{}; ///< what it shows

    HeldView() = default;                                                                             ///< nothing yet
    explicit HeldView(Extent) {}                                                                      ///< nothing yet
    explicit HeldView(View const& view) : held(view) {}                                               ///< this image
    [[nodiscard]] Extent size() const { return held.size; }                                           ///< pixels
    [[nodiscard]] std::size_t bytes() const { return 0; }                                             ///< it owns no memory
    [[nodiscard]] View view() const { return held; }                                                  ///< that kernels use
    [[nodiscard]] static HeldView of_copy(auto const& copy) { return HeldView(View::of_copy(copy)); } ///< shows a copy that stands in
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
