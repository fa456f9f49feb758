#pragma once

#include <quell/resolve/resolve.hpp>
#include <quell/resolve/spline_interpolation.hpp>

#include <array>
#include <cstddef>

/// The two passes of a Resolve, and what they read and write.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What a Resolve keeps of a frame, as views.
template <class Colour, class Vectors, class Depths> struct ResolvedFrame {
    Colour colour;
    Vectors motion; ///< of the nearest surface in the 3x3 around, in pixels
    Depths depth;
    Extent size{};
    glm::vec2 jitter{0.f};
};
template <class Colour, class Vectors, class Depths>
ResolvedFrame(Colour, Vectors, Depths, Extent, glm::vec2) -> ResolvedFrame<Colour, Vectors, Depths>;

/// Ranges around each pixel of this frame, as views.
template <class Colour, class Depths> struct RangesAround {
    Colour low, high; ///< of the colours, in the axes of the clamp
    Depths depths;    ///< the nearest, and the farthest
};
template <class Colour, class Depths> RangesAround(Colour, Colour, Depths) -> RangesAround<Colour, Depths>;

/// One pixel of the input: what is kept of it, and the ranges around it.
template <class Policies, class Conversion, class Picture, class HostDepth, class HostMotion, class Kept, class Ranges>
struct PrepareResolve {
    static constexpr auto name = "prepare resolve";
    Policies policies;
    Conversion vectors; ///< what the host's motion means
    Picture picture;    ///< what the pipeline made
    HostDepth depth;
    HostMotion motion;
    Kept kept;
    Ranges around;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        using V = Value<Picture::components, Real>;
        using Axes = std::remove_const_t<decltype(policies.axes)>;
        TapsAround<Real> const taps(kept.size, Real(static_cast<float>(x)) + lanes<Real>(), Real(static_cast<float>(y)));
        V const centre = taps.at(picture, 0, 0);
        typename decltype(policies.range)::template Gatherer<V> range(Axes::from(centre));
        Real const own = taps.at(depth, 0, 0);
        Real nearest = own, farthest = own;
        vec2<Real> vector = taps.at(motion, 0, 0);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                range.add(Axes::from(V(taps.at(picture, dx, dy))), Real(1.f), dx, dy);
                Real const its_depth = taps.at(depth, dx, dy);
                auto const nearer = its_depth < nearest;
                if (any(nearer)) vector = select(nearer, vec2<Real>(taps.at(motion, dx, dy)), vector);
                nearest = select(nearer, its_depth, nearest);
                farthest = max(farthest, its_depth);
            }
        range.finish(policies.range);
        store_pixels<Real>(kept.colour, x, y, centre, count);
        store_pixels<Real>(kept.motion, x, y, vec2<Real>(vectors(vector)), count);
        store_pixels<Real>(kept.depth, x, y, own, count);
        store_pixels<Real>(around.low, x, y, range.low, count);
        store_pixels<Real>(around.high, x, y, range.high, count);
        store_pixels<Real>(around.depths, x, y, vec2<Real>{nearest, farthest}, count);
    }
};
template <class Policies, class Conversion, class Picture, class HostDepth, class HostMotion, class Kept, class Ranges>
PrepareResolve(Policies, Conversion, Picture, HostDepth, HostMotion, Kept, Ranges)
    -> PrepareResolve<Policies, Conversion, Picture, HostDepth, HostMotion, Kept, Ranges>;

/// One output pixel of a Resolve.
template <class Policies, class Kept, class Ranges, class Target> struct ResolveJob {
    static constexpr auto name = "resolve";
    Policies policies;
    std::array<Kept, Policies::past_frames + 1> frames; ///< this frame, and those before it
    int frame_count;
    Ranges around;
    Target target;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        using V = Value<Target::components, Real>;
        using Axes = std::remove_const_t<decltype(policies.axes)>;
        auto const& now = frames[0];
        vec2<Real> place{Real(static_cast<float>(x) + 0.5f) + lanes<Real>(), Real(static_cast<float>(y) + 0.5f)};
        auto where = in_frame(now, place);
        V const seen = interpolate<Real>(now.colour, now.size, where);
        Real best = sample_weight(now, where), total = best;
        V sum = scale(seen, total);
        auto const here = nearest_sample(now, where);
        V const low(here.at(around.low, 0, 0)), high(here.at(around.high, 0, 0));
        vec2<Real> const depths = here.at(around.depths, 0, 0);
        Real const nearest = depths.x * (1.f - policies.depth_tolerance), farthest = depths.y * (1.f + policies.depth_tolerance);
        vec2<Real> vector = here.at(now.motion, 0, 0);
        auto known = Real(0.f) == Real(0.f);
        for (int i = 1; i < frame_count; ++i) {
            auto const& then = frames[static_cast<std::size_t>(i)];
            auto const ratio = ratio_of(frames[static_cast<std::size_t>(i - 1)]);
            vec2<Real> const moved{fma(vector.x, Real(ratio.x), place.x), fma(vector.y, Real(ratio.y), place.y)};
            known = both(known, inside(moved));
            if (!any(known)) break;
            place = select(known, moved, place);
            where = in_frame(then, place);
            auto const there = nearest_sample(then, where);
            Real const its_depth = there.at(then.depth, 0, 0);
            Real const weight = masked(both(known, its_depth >= nearest, its_depth <= farthest), sample_weight(then, where));
            auto const colour = Axes::from(V(there.at(then.colour, 0, 0)));
            auto const clamped = map([](auto a, auto l, auto h) QUELL_INLINED { return clamp(a, l, h); }, colour, low, high);
            sum = add_scaled(sum, V(Axes::to(clamped)), weight);
            total = total + weight;
            best = max(best, weight);
            vector = vec2<Real>(there.at(then.motion, 0, 0));
        }
        // Where no sample of any frame lies near, the spline of this frame knows as much.
        V const mean = scale(sum, 1.f / max(total, Real(1e-12f)));
        V const value = map([&](auto a, auto b) QUELL_INLINED { return fma(b - a, best, a); }, seen, mean);
        store_pixels<Real>(target, x, y, value, count);
    }

private:
    [[nodiscard]] QUELL_KERNEL glm::vec2 ratio_of(Kept const& frame) const {
        return {static_cast<float>(target.size.width) / static_cast<float>(frame.size.width),
                static_cast<float>(target.size.height) / static_cast<float>(frame.size.height)};
    }
    /// A place of the output, among the samples of a frame: that of pixel (x, y) is at (x + .5, y + .5).
    template <class Real> QUELL_KERNEL vec2<Real> in_frame(Kept const& frame, vec2<Real> const& place) const {
        auto const ratio = ratio_of(frame);
        return {place.x * (1.f / ratio.x) - frame.jitter.x, place.y * (1.f / ratio.y) - frame.jitter.y};
    }
    template <class Real> QUELL_KERNEL static TapsAround<Real> nearest_sample(Kept const& frame, vec2<Real> const& where) {
        return {frame.size, clamp(floor(where.x), Real(0.f), Real(static_cast<float>(frame.size.width - 1))),
                clamp(floor(where.y), Real(0.f), Real(static_cast<float>(frame.size.height - 1)))};
    }
    template <class Real> QUELL_KERNEL Real sample_weight(Kept const& frame, vec2<Real> const& where) const {
        auto const ratio = ratio_of(frame);
        auto const across = (where.x - floor(where.x) - 0.5f) * ratio.x, down = (where.y - floor(where.y) - 0.5f) * ratio.y;
        return policies.kernel.weight(across * across + down * down);
    }
    template <class Real> QUELL_KERNEL auto inside(vec2<Real> const& place) const {
        return both(is_finite(place.x), is_finite(place.y), place.x >= Real(0.f), place.x <= Real(static_cast<float>(target.size.width)),
                    place.y >= Real(0.f), place.y <= Real(static_cast<float>(target.size.height)));
    }
};
template <class Policies, class Kept, std::size_t n, class Ranges, class Target>
ResolveJob(Policies, std::array<Kept, n>, int, Ranges, Target) -> ResolveJob<Policies, Kept, Ranges, Target>;

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
