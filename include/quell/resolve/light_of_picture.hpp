#pragma once

#include <quell/frame/cursor/past_pixel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Like load_pixels, which takes a view's own padding before a row. A view without has its border repeated.
template <class Real, class View> QUELL_KERNEL auto load_beside(View const& view, int x, int y) {
    if constexpr (requires { view.template load<Real>(x, y); })
        return view.template load<Real>(x, y);
    else
        return fetch_repeated<Real>(view, vec2<Real>{Real(static_cast<float>(x)) + lanes<Real>(), Real(static_cast<float>(y))});
}

/// The light of a picture, as a view: what colours leave of it.
template <class Picture, class Colour> struct LightOfPicture {
    Picture picture;
    Colour colour; ///< above 0

    template <class Real> QUELL_KERNEL vec3<Real> load(int x, int y) const {
        return map([](auto p, auto c) QUELL_INLINED { return p / c; }, vec3<Real>(load_beside<Real>(picture, x, y)),
                   vec3<Real>(load_beside<Real>(colour, x, y)));
    }
};
template <class Picture, class Colour> LightOfPicture(Picture, Colour) -> LightOfPicture<Picture, Colour>;

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
