#pragma once

#include <quell/core/half_pack.hpp>
#include <quell/image/extent.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A tag that tells a job how many pixels to compute at once: `job(at_once<Pack>, x, y, count)`.
/// @tparam rows 1, or 2 where each half of the pack is pixels of a row of its own
template <class Real, int rows = 1> struct AtOnce {
    using real = Real; ///< float or a pack
};
/// The value of the tag.
template <class Real> inline constexpr AtOnce<Real> at_once;

/// The pixels of x0 <= x < x1 and y0 <= y < y1.
struct Region {
    int x0 = 0, ///< first column
        y0 = 0, ///< first row
        x1 = 0, ///< column after the last
        y1 = 0; ///< row after the last
};

namespace detail {
struct AnyJob {
    static constexpr auto name = "any";
    template <class Real> void operator()(AtOnce<Real>, int, int, int) const {}
};
} // namespace detail

/// Runs a job once for every pixel of a region, in any order, and returns when all are done:
///
///     void for_each_pixel(Region region, auto const& job) const
///
/// job(at_once<Real>, x, y, count) computes the `count` pixels from (x, y) to the right and writes no others; count <= width_of<Real>.
/// `job.name` is the name of the pass. `job.max_lanes`, if there is one, is the largest useful SIMD width. Where `job.two_rows` is true,
/// job(AtOnce<Real, 2>{}, x, y, count) computes those of an even row y and of the next one, in the halves of packs that are twice as wide.
/// Models: Serial, SimdOf, Threads, Cuda.
template <class E>
concept Executor = requires(E const e, Region region, detail::AnyJob job) {
    e.for_each_pixel(region, job);
};

/// Runs one pixel at a time on the calling thread. It is the reference that other executors are tested against.
struct Serial {
    /// See Executor.
    QUELL_FLATTENED void for_each_pixel(Region r, auto const& job) const {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) job(at_once<float>, x, y, 1);
    }
};

#if !defined(__CUDACC__)
namespace detail {
/// The pack for a job: P, or a narrower one where the job's `max_lanes` is less and the instruction set has such packs.
template <class P, class Job> struct PackFor { using type = P; };
template <class P, class Job>
    requires(Job::max_lanes < width_of<P> && !std::is_void_v<xsimd::make_sized_batch_t<float, std::size_t{Job::max_lanes}>>)
struct PackFor<P, Job> {
    using type = xsimd::make_sized_batch_t<float, std::size_t{Job::max_lanes}>;
};
/// Whether a job takes an even row and the next one at once: its packs are half as wide as P.
template <class P, class Job> inline constexpr bool pairs_rows = false;
template <class P, class Job>
    requires(Job::two_rows&& HalfPack<P>::joins&& std::is_same_v<typename PackFor<P, Job>::type, typename HalfPack<P>::type>)
inline constexpr bool pairs_rows<P, Job> = true;
} // namespace detail

/// Runs one pack of pixels at a time on the calling thread.
/// @tparam P the pack. As a template argument it gives code for different instruction sets different linker symbols. The exception are jobs
/// with `max_lanes`: two instruction sets may share a narrower pack.
template <class P = Pack> struct SimdOf {
    /// See Executor.
    template <class Job> QUELL_FLATTENED void for_each_pixel(Region r, Job const& job) const {
        using Real = typename detail::PackFor<P, Job>::type;
        constexpr int width = width_of<Real>;
        auto const along_row = [&](auto pack, int y) QUELL_INLINED {
            for (int x = r.x0; x < r.x1; x += width) job(pack, x, y, r.x1 - x < width ? r.x1 - x : width);
        };
        for (int y = r.y0; y < r.y1; ++y)
            if constexpr (detail::pairs_rows<P, Job>) {
                if (y % 2 == 0 && y + 1 < r.y1)
                    along_row(AtOnce<P, 2>{}, y++);
                else
                    along_row(at_once<Real>, y);
            } else
                along_row(at_once<Real>, y);
    }
};
/// Packs of the instruction set that the translation unit is compiled for.
using Simd = SimdOf<>;
#else
/// nvcc cannot compile packs: its host code runs one pixel at a time.
using Simd = Serial;
#endif

} // namespace quell::inline QUELL_INSTRUCTION_SET
