#pragma once

#include <quell/core/real.hpp>
#include <quell/image/extent.hpp>

namespace quell {

/// Tells a job how many pixels to compute at once: `job(at_once<Pack>, x, y, count)`.
template <class Real> struct AtOnce { using real = Real; };
template <class Real> inline constexpr AtOnce<Real> at_once;

/// Pixels from (x0, y0) up to but not including (x1, y1).
struct Region {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

namespace detail {
struct AnyJob {
    static constexpr auto name = "any";
    template <class Real> void operator()(AtOnce<Real>, int, int, int) const {}
};
} // namespace detail

/// Runs a job once for every pixel of a region, in any order, on anything:
///     void for_each_pixel(Region region, auto const& job) const
/// A job computes `count` pixels from (x, y) to the right, at most as many as a Real has lanes, and writes nothing else. `job.name` says
/// which pass it is.
template <class E>
concept Executor = requires(E const e, Region region, detail::AnyJob job) {
    e.for_each_pixel(region, job);
};

/// One pixel after the other, on this thread: the reference.
struct Serial {
    void for_each_pixel(Region r, auto const& job) const {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) job(at_once<float>, x, y, 1);
    }
};

#if !defined(__CUDACC__)
/// A pack of pixels after the other, on this thread.
/// @tparam P the pack, so that what is compiled for another instruction set has another name for the linker
template <class P = Pack> struct SimdOf {
    void for_each_pixel(Region r, auto const& job) const {
        constexpr int width = width_of<P>;
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; x += width) job(at_once<P>, x, y, r.x1 - x < width ? r.x1 - x : width);
    }
};
using Simd = SimdOf<>;
#else
/// nvcc knows no packs: its host code runs pixel after pixel.
using Simd = Serial;
#endif

} // namespace quell
