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
/// which pass it is; `job.most_lanes`, if there is one, how many lanes it has a use for.
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
namespace detail {
/// The pack that a job is computed in: P, unless the job has no use for that many lanes (`most_lanes`) and there are narrower packs.
template <class P, class Job> struct PackFor { using type = P; };
template <class P, class Job>
    requires(Job::most_lanes < width_of<P> && !std::is_void_v<xsimd::make_sized_batch_t<float, std::size_t{Job::most_lanes}>>)
struct PackFor<P, Job> {
    using type = xsimd::make_sized_batch_t<float, std::size_t{Job::most_lanes}>;
};
} // namespace detail

/// A pack of pixels after the other, on this thread.
/// @tparam P the pack, so that what is compiled for another instruction set has another name for the linker (but for jobs that are computed
/// in a narrower one, which another set may have as well)
template <class P = Pack> struct SimdOf {
    template <class Job> void for_each_pixel(Region r, Job const& job) const {
        using Real = typename detail::PackFor<P, Job>::type;
        constexpr int width = width_of<Real>;
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; x += width) job(at_once<Real>, x, y, r.x1 - x < width ? r.x1 - x : width);
    }
};
using Simd = SimdOf<>;
#else
/// nvcc knows no packs: its host code runs pixel after pixel.
using Simd = Serial;
#endif

} // namespace quell
