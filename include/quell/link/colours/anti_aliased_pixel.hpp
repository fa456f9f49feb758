#pragma once

#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/link/colours/seen_surface.hpp>

#include <limits>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The factor of a squared distance in the exponent of the Gaussian.
QUELL_KERNEL float falloff_of(auto const& policy) { return -0.5f / (policy.deviation * policy.deviation); }

/// What AntiAliased makes of a pixel.
template <class Real> struct AntiAliasedValue {
    vec3<Real> value; ///< the picture
    vec3<Real> told;  ///< the colour that frames around tell, without the frame itself: not finite where that is nothing
};

/// The steps of AntiAliased for one pixel, or a pack.
/// @tparam Policy      AntiAliased
/// @tparam Source      what the pixel sees: size(), position(), own_weight(dx, dy), plain(), light(), depth(); at(dx, dy) with inside(),
/// any_row_inside(), depth(), colour(), motion(), to_next(), light(); `has_after`, and each_frame(is_before, visit) for the frames to a
/// side, the nearest first. Of each of these: jitter, knows_toward, is_last, depth(place, dx, dy), colour(...), onward(...), toward(...)
/// @tparam tells_others whether the value's `told` is wanted
template <class Policy, class Source, bool tells_others> class AntiAliasedPixel {
    using Real = typename Source::Real;
    using Surface = SeenSurface<Real>;
    Policy const& policy;
    Source const& source;

public:
    QUELL_KERNEL AntiAliasedPixel(Policy const& p, Source const& s) : policy(p), source(s) {}

    QUELL_KERNEL AntiAliasedValue<Real> made() const {
        Real nearest(1e38f), farthest(0.f);
        each_neighbour([&](auto const& tap, auto) QUELL_INLINED {
            auto const inside = tap.inside();
            auto const d = distance(tap.depth());
            nearest = select(inside, min(nearest, d), nearest), farthest = select(inside, max(farthest, d), farthest);
        });
        auto const is_two = farthest > nearest * (1.f + policy.range);
        auto const plain = source.plain();
        Real const none(std::numeric_limits<float>::quiet_NaN());
        AntiAliasedValue<Real> made{plain, {none, none, none}};
        Real weights(0.f);
        if (any(is_two))
            two_surfaces(2.f * nearest / (1.f + nearest / farthest), is_two, made, weights);
        else
            one_surface(made, weights);
        auto& value = made.value;
        if (!policy.by_surface) value = scale(add_scaled(scale(value, weights), plain, Real(policy.own)), 1.f / (weights + policy.own));
        value = select(both(all_finite(value), weights > Real(0.f)), value, plain);
        return made;
    }

private:
    /// A depth, very large where nothing is seen.
    QUELL_KERNEL static Real distance(Real depth) { return max(min(depth, Real(1e30f)), Real(1e-20f)); }
    QUELL_KERNEL void each_neighbour(auto&& visit) const {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                auto const tap = source.at(dx, dy);
                if (!tap.any_row_inside()) continue;
                visit(tap, source.own_weight(dx, dy));
            }
    }

    /// Most pixels show one surface, whose light is theirs. Where its colours are all alike there is nothing to smooth.
    QUELL_KERNEL void one_surface(AntiAliasedValue<Real>& made, Real& weights) const {
        Surface surface;
        each_neighbour([&](auto const& tap, auto weight)
                           QUELL_INLINED { surface.add_own(tap.inside(), distance(tap.depth()), tap.colour(), Real(weight)); });
        auto const varies = surface.varies();
        if (!any(varies)) return;
        take_motion(surface, surface.is_seen(), source.at(0, 0));
        auto const own = surface;
        if (!policy.by_surface || tells_others) surface.drop_own();
        Real whole(0.f);
        follow_both<false>(surface, whole);
        if constexpr (tells_others) {
            made.told = select(both(varies, surface.weights > Real(0.f)), surface.colour(), made.told);
            if (policy.by_surface) surface.add_sums(own);
        }
        made.value = surface.colour() * source.light();
        weights = masked(varies, surface.weights);
    }

    /// What the surface in front leaves of the pixel is the other's.
    /// @param middle distance between both
    /// @param is_two whether there are two; else it does as one_surface() does
    QUELL_KERNEL void two_surfaces(Real middle, auto is_two, AntiAliasedValue<Real>& made, Real& weights) const {
        auto const is_one = invert(is_two);
        Surface front, back;
        Real whole(0.f), nearest(1e38f), farthest(0.f);
        each_neighbour([&](auto const& tap, auto own_weight) QUELL_INLINED {
            auto const inside = tap.inside();
            Real const weight(own_weight);
            auto const d = distance(tap.depth());
            auto const nearer = both(inside, d < nearest), farther = both(inside, d > farthest);
            nearest = select(nearer, d, nearest), farthest = select(farther, d, farthest);
            if (any(nearer)) take_motion(front, nearer, tap);
            if (any(farther)) take_motion(back, farther, tap);
            vec3<Real> const c = tap.colour(), l = tap.light();
            auto const counts = both(inside, either(is_one, all_finite(l)));
            auto const of_front = both(counts, either(is_one, d < middle)), of_back = both(counts, is_two, d >= middle);
            front.add_own(of_front, d, c, weight), back.add_own(of_back, d, c, weight);
            front.add_light(of_front, l, weight), back.add_light(of_back, l, weight);
            whole = whole + masked(inside, weight);
        });
        take_motion(front, is_one, source.at(0, 0));
        auto const smooths = either(is_two, front.varies());
        auto const own_front = front, own_back = back;
        auto const own_whole = whole;
        if (!policy.by_surface || tells_others) front.drop_own(), back.drop_own(), whole = Real(0.f);
        front.behind = back.nearest * (1.f / (1.f + policy.range));
        Real of_back(0.f);
        follow_both<true>(front, whole);
        follow_both<true>(back, of_back);
        auto const cover = [&] { return select(back.weights > Real(0.f), front.weights / max(whole, Real(1e-20f)), Real(1.f)); };
        if constexpr (tells_others) {
            made.told = select(both(smooths, whole > Real(0.f)), mix(back.colour(), front.colour(), min(cover(), Real(1.f))), made.told);
            if (policy.by_surface) front.add_sums(own_front), back.add_sums(own_back), whole = whole + own_whole;
        }
        // The surface that the pixel shows has the light that the pixel has.
        vec3<Real> const own_light = source.light();
        auto const is_front = either(is_one, distance(source.depth()) < middle);
        auto const shown = [&](Surface const& surface, auto is_here) QUELL_INLINED {
            return surface.colour() * (policy.by_surface ? select(is_here, own_light, surface.light()) : own_light);
        };
        auto const covered = cover();
        made.value = mix(shown(back, invert(is_front)), shown(front, is_front), min(covered, Real(1.f)));
        weights = masked(smooths, whole);
    }
    QUELL_KERNEL void take_motion(Surface& surface, auto mask, auto const& tap) const {
        surface.motion = select(mask, tap.motion(), surface.motion);
        if constexpr (Source::has_after)
            if (source.count_after() > 0) surface.motion_next = select(mask, tap.to_next(), surface.motion_next);
    }

    template <bool measures_whole> QUELL_KERNEL void follow_both(Surface& surface, Real& whole) const {
        auto const is_seen = surface.is_seen();
        if (!any(is_seen)) return;
        surface.nearest = surface.nearest * (1.f / (1.f + policy.range)),
        surface.farthest = surface.farthest * (1.f / (1.f - policy.range));
        follow<measures_whole, true>(surface, is_seen, surface.motion, whole);
        if constexpr (Source::has_after) follow<measures_whole, false>(surface, is_seen, surface.motion_next, whole);
    }
    /// Adds the samples of a surface in the frames to one side: of each, the nine around the place where the pixel's centre was.
    /// @param whole the sum of weights if the surface covered the pixel
    template <bool measures_whole, bool is_before>
    QUELL_KERNEL void follow(Surface& surface, auto alive, vec2<Real> const& first, Real& whole) const {
        auto const size = source.size();
        auto const width = Real(to_real(size.width)), height = Real(to_real(size.height));
        auto const from = source.position();
        auto step = first;
        auto where = from + first;
        alive = both(alive, all_finite(where));
        source.template each_frame<is_before>([&](auto const& frame) QUELL_INLINED {
            alive = both(alive, where.x >= Real(0.f), where.y >= Real(0.f), where.x < width, where.y < height);
            if (!any(alive)) return false;
            vec2<Real> const at{select(alive, where.x, from.x) - frame.jitter.x, select(alive, where.y, from.y) - frame.jitter.y};
            auto const place = nearest_place(source, at);
            auto const across = three_weights(place.column, at.x, width), down = three_weights(place.row, at.y, height);
            auto const allowed = fma(fma(step.x, step.x, step.y * step.y), Real(0.0025f), Real(0.16f));
            Real const sign(frame.knows_toward ? 1.f : -1.f);
            Real best(0.f), weights(0.f), of_whole(0.f);
            auto sum = zero<vec3<Real>>();
            auto onward = zero<vec2<Real>>();
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    auto const d = distance(frame.depth(place, dx, dy));
                    vec3<Real> const c = frame.colour(place, dx, dy);
                    // Things of one depth that move differently are different.
                    vec2<Real> const its = frame.toward(place, dx, dy);
                    auto const amiss_x = fma(its.x, sign, step.x), amiss_y = fma(its.y, sign, step.y);
                    auto const amiss = fma(amiss_x, amiss_x, amiss_y * amiss_y);
                    auto const goes_there = either(invert(is_finite(amiss)), amiss <= allowed);
                    auto const found = both(goes_there, is_finite(Surface::mark_of(c)), d >= surface.nearest, d <= surface.farthest);
                    auto const any_weight = across.at[dx + 1] * down.at[dy + 1];
                    // The other surface is a gap in this one. What hides both, lies between them or goes elsewhere says nothing.
                    if constexpr (measures_whole) of_whole = of_whole + masked(either(found, d >= surface.behind), any_weight);
                    auto const w = masked(found, any_weight);
                    sum = add_scaled(sum, select(found, c, zero<vec3<Real>>()), w);
                    weights = weights + w;
                    if (frame.is_last) continue;
                    auto const closer = w > best;
                    best = select(closer, w, best);
                    onward = select(closer, frame.onward(place, dx, dy), onward);
                }
            alive = both(alive, weights > Real(0.f));
            auto const counts = both(alive, is_unchanged(surface, sum, weights));
            surface.colours = add_scaled(surface.colours, sum, masked(counts, Real(1.f)));
            surface.weights = surface.weights + masked(counts, weights);
            if constexpr (measures_whole) whole = whole + masked(counts, of_whole);
            where = where + onward, step = onward;
            alive = both(alive, all_finite(where));
            return true;
        });
    }
    struct ThreeWeights {
        Real at[3];
    };
    /// Of the samples at a column and those beside it, or rows; 0 outside.
    QUELL_KERNEL ThreeWeights three_weights(Real column, Real at, Real size) const {
        auto const weight = [&](Real off) QUELL_INLINED { return quell::exp(off * off * falloff_of(policy)); };
        auto const off = column + 0.5f - at;
        return {masked(column > Real(0.f), weight(off - 1.f)), weight(off), masked(column < size - 1.f, weight(off + 1.f))};
    }
    /// Whether the mean colour lies among those of the surface now, as far as policy.change says.
    QUELL_KERNEL auto is_unchanged(Surface const& surface, vec3<Real> const& sum, Real weights) const {
        if (!(policy.change > 0.f)) return weights >= Real(0.f);
        auto const mark = Surface::mark_of(sum);
        float const less = 1.f - policy.change, more = 1.f + policy.change;
        return both(mark * more >= surface.least * weights * less, mark * less <= surface.most * weights * more);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
