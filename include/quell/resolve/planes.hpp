#pragma once

#include <quell/execute/executor.hpp>
#include <quell/image/planar.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// An image of so many numbers a pixel. What lies around it in memory, up to 16 pixels to each side of a row, is zero.
template <int count> using Planes = Planar<>::Image<count>;
/// A view of that image.
template <int count> using PlanesView = typename Planes<count>::View;

/// A job of a function: f(AtOnce<Real>, x, y, count).
template <class F> struct PixelJob {
    static constexpr auto name = "pixels";
    F f;

    template <class Real> QUELL_FLATTENED constexpr void operator()(AtOnce<Real> at, int x, int y, int count) const { f(at, x, y, count); }
};
/// Runs a function for all pixels of an image.
template <Executor E, class F> void for_all_pixels(E const& executor, Extent size, F const& f) {
    executor.for_each_pixel({0, 0, size.width, size.height}, PixelJob<F>{f});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
