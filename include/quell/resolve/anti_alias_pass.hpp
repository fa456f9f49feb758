#pragma once

#include <quell/execute/queue_executor.hpp>
#include <quell/resolve/around_frame.hpp>
#include <quell/resolve/light_of_picture.hpp>
#include <quell/resolve/seen_surface.hpp>

#include <array>
#include <limits>
#include <type_traits>

/// The pass of AntiAliased, and what it reads.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The factor of a squared distance in the exponent of the Gaussian.
QUELL_KERNEL float falloff_of(AntiAliased const& policy) { return -0.5f / (policy.deviation * policy.deviation); }
/// Weights of the 3x3 around a pixel.
inline std::array<float, 9> own_weights_of(AntiAliased const& policy, glm::vec2 jitter) {
    std::array<float, 9> weights;
    for (int i = 0; i < 9; ++i) {
        float const x = static_cast<float>(i % 3 - 1) + jitter.x, y = static_cast<float>(i / 3 - 1) + jitter.y;
        weights[static_cast<std::size_t>(i)] = quell::exp((x * x + y * y) * falloff_of(policy));
    }
    return weights;
}

/// In place of a view: nobody asks what frames around tell by themselves.
struct NoOthers {};

/// The pass of AntiAliased.
/// @tparam Others a view that takes what frames around tell of the colour, without the frame itself: not finite where that is nothing
template <class Storage, class Light, class Target, class Others = NoOthers> struct AntiAliasJob {
    static constexpr auto name = "anti-alias";
    static constexpr bool tells_others = !std::is_same_v<Others, NoOthers>;
    AntiAliased policy;
    ColouredFrame<Storage> here;
    Light light;
    Target to;
    std::array<float, 9> own_weights; ///< of the 3x3
    std::array<AroundFrame<Storage>, AntiAliased::most_frames> before{}, after{};
    int count_before = 0, count_after = 0;
    [[no_unique_address]] Others others{};

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        Real nearest(1e38f), farthest(0.f);
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, float) QUELL_INLINED {
            auto const d = distance<Real>(load_beside<Real>(here.depth, column, row));
            nearest = select(inside, min(nearest, d), nearest), farthest = select(inside, max(farthest, d), farthest);
        });
        auto const is_two = farthest > nearest * (1.f + policy.range);
        auto const plain = shown_plain<Real>(x, y);
        vec3<Real> value = plain, told = unknown<Real>();
        Real weights(0.f);
        if (any(is_two))
            two_surfaces<Real>(x, y, 2.f * nearest / (1.f + nearest / farthest), is_two, value, weights, told);
        else
            one_surface<Real>(x, y, value, weights, told);
        if constexpr (tells_others) store_pixels<Real>(others, x, y, told, count);
        if (!policy.by_surface) value = scale(add_scaled(scale(value, weights), plain, Real(policy.own)), 1.f / (weights + policy.own));
        store_pixels<Real>(to, x, y, select(both(all_finite(value), weights > Real(0.f)), value, plain), count);
    }

private:
    /// A depth, very large where nothing is seen.
    template <class Real> QUELL_KERNEL static Real distance(Real depth) { return max(min(depth, Real(1e30f)), Real(1e-20f)); }
    template <class Real> QUELL_KERNEL static vec2<Real> centre(int x, int y) {
        return {Real(static_cast<float>(x) + 0.5f) + lanes<Real>(), Real(static_cast<float>(y) + 0.5f)};
    }
    template <class Real> QUELL_KERNEL static vec3<Real> unknown() {
        Real const none(std::numeric_limits<float>::quiet_NaN());
        return {none, none, none};
    }
    /// The pixel without anti-aliasing.
    template <class Real> QUELL_KERNEL vec3<Real> shown_plain(int x, int y) const {
        if constexpr (requires { light.picture; })
            return load_pixels<Real>(light.picture, x, y);
        else
            return vec3<Real>(load_pixels<Real>(here.colour, x, y)) * vec3<Real>(load_pixels<Real>(light, x, y));
    }
    template <class Real> QUELL_KERNEL void each_neighbour(int x, int y, auto&& visit) const {
        auto const columns = Real(static_cast<float>(x)) + lanes<Real>();
        Real const width(static_cast<float>(here.depth.size.width));
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (y + dy < 0 || y + dy >= here.depth.size.height) continue;
                auto const column = columns + static_cast<float>(dx);
                visit(both(column >= Real(0.f), column < width), x + dx, y + dy, own_weights[static_cast<std::size_t>(dy * 3 + dx + 4)]);
            }
    }

    /// Most pixels show one surface, whose light is theirs. Where its colours are all alike there is nothing to smooth.
    template <class Real> QUELL_KERNEL void one_surface(int x, int y, vec3<Real>& value, Real& weights, vec3<Real>& told) const {
        SeenSurface<Real> surface;
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, float weight) QUELL_INLINED {
            surface.add_own(inside, distance<Real>(load_beside<Real>(here.depth, column, row)),
                            vec3<Real>(load_beside<Real>(here.colour, column, row)), Real(weight));
        });
        auto const varies = surface.varies();
        if (!any(varies)) return;
        take_motion(surface, surface.is_seen(), x, y);
        auto const own = surface;
        if (!policy.by_surface || tells_others) surface.drop_own();
        Real whole(0.f);
        follow_both<Real, false>(surface, centre<Real>(x, y), whole);
        if constexpr (tells_others) {
            told = select(both(varies, surface.weights > Real(0.f)), surface.colour(), told);
            if (policy.by_surface) surface.add_sums(own);
        }
        value = surface.colour() * vec3<Real>(load_beside<Real>(light, x, y));
        weights = masked(varies, surface.weights);
    }

    /// What the surface in front leaves of the pixel is the other's.
    /// @param middle distance between both
    /// @param is_two whether there are two; else it does as one_surface() does
    template <class Real>
    QUELL_KERNEL void two_surfaces(int x, int y, Real middle, auto is_two, vec3<Real>& value, Real& weights, vec3<Real>& told) const {
        auto const is_one = invert(is_two);
        SeenSurface<Real> front, back;
        Real whole(0.f), nearest(1e38f), farthest(0.f);
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, float weight) QUELL_INLINED {
            auto const d = distance<Real>(load_beside<Real>(here.depth, column, row));
            auto const nearer = both(inside, d < nearest), farther = both(inside, d > farthest);
            nearest = select(nearer, d, nearest), farthest = select(farther, d, farthest);
            if (any(nearer)) take_motion(front, nearer, column, row);
            if (any(farther)) take_motion(back, farther, column, row);
            vec3<Real> const c = load_beside<Real>(here.colour, column, row), l = load_beside<Real>(light, column, row);
            auto const counts = both(inside, either(is_one, all_finite(l)));
            auto const of_front = both(counts, either(is_one, d < middle)), of_back = both(counts, is_two, d >= middle);
            front.add_own(of_front, d, c, Real(weight)), back.add_own(of_back, d, c, Real(weight));
            front.add_light(of_front, l, Real(weight)), back.add_light(of_back, l, Real(weight));
            whole = whole + masked(inside, Real(weight));
        });
        take_motion(front, is_one, x, y);
        auto const smooths = either(is_two, front.varies());
        auto const own_front = front, own_back = back;
        auto const own_whole = whole;
        if (!policy.by_surface || tells_others) front.drop_own(), back.drop_own(), whole = Real(0.f);
        front.behind = back.nearest * (1.f / (1.f + policy.range));
        Real of_back(0.f);
        follow_both<Real, true>(front, centre<Real>(x, y), whole);
        follow_both<Real, true>(back, centre<Real>(x, y), of_back);
        auto const cover = [&] { return select(back.weights > Real(0.f), front.weights / max(whole, Real(1e-20f)), Real(1.f)); };
        if constexpr (tells_others) {
            told = select(both(smooths, whole > Real(0.f)), mix(back.colour(), front.colour(), min(cover(), Real(1.f))), told);
            if (policy.by_surface) front.add_sums(own_front), back.add_sums(own_back), whole = whole + own_whole;
        }
        // The surface that the pixel shows has the light that the pixel has.
        vec3<Real> const own_light = load_beside<Real>(light, x, y);
        auto const is_front = either(is_one, distance<Real>(load_pixels<Real>(here.depth, x, y)) < middle);
        auto const shown = [&](SeenSurface<Real> const& surface, auto is_here) QUELL_INLINED {
            return surface.colour() * (policy.by_surface ? select(is_here, own_light, surface.light()) : own_light);
        };
        auto const covered = cover();
        value = mix(shown(back, invert(is_front)), shown(front, is_front), min(covered, Real(1.f)));
        weights = masked(smooths, whole);
    }
    template <class Real> QUELL_KERNEL void take_motion(SeenSurface<Real>& surface, auto mask, int column, int row) const {
        surface.motion = select(mask, vec2<Real>(load_beside<Real>(here.motion, column, row)), surface.motion);
        if (count_after > 0)
            surface.motion_next = select(mask, vec2<Real>(load_beside<Real>(here.to_next, column, row)), surface.motion_next);
    }

    template <class Real, bool measures_whole>
    QUELL_KERNEL void follow_both(SeenSurface<Real>& surface, vec2<Real> const& from, Real& whole) const {
        auto const is_seen = surface.is_seen();
        if (!any(is_seen)) return;
        surface.nearest = surface.nearest * (1.f / (1.f + policy.range)),
        surface.farthest = surface.farthest * (1.f / (1.f - policy.range));
        follow<Real, measures_whole>(surface, is_seen, from, surface.motion, before, count_before, whole);
        follow<Real, measures_whole>(surface, is_seen, from, surface.motion_next, after, count_after, whole);
    }
    /// Adds the samples of a surface in the frames to one side: of each, the nine around the place where the pixel's centre was.
    /// @param whole the sum of weights if the surface covered the pixel
    template <class Real, bool measures_whole>
    QUELL_KERNEL void follow(SeenSurface<Real>& surface, auto alive, vec2<Real> const& from, vec2<Real> const& first,
                             std::array<AroundFrame<Storage>, AntiAliased::most_frames> const& frames, int count, Real& whole) const {
        Extent const size = here.depth.size;
        auto step = first;
        auto where = from + first;
        alive = both(alive, all_finite(where));
        for (int k = 0; k < count; ++k) {
            auto const& frame = frames[static_cast<std::size_t>(k)];
            alive = both(alive, where.x >= Real(0.f), where.y >= Real(0.f), where.x < Real(static_cast<float>(size.width)),
                         where.y < Real(static_cast<float>(size.height)));
            if (!any(alive)) return;
            vec2<Real> const at{select(alive, where.x, from.x) - frame.jitter.x, select(alive, where.y, from.y) - frame.jitter.y};
            auto const place = nearest_inside(size, vec2<Real>{floor(at.x), floor(at.y)});
            auto const across = three_weights(place.column, at.x, size.width), down = three_weights(place.row, at.y, size.height);
            auto const allowed = fma(fma(step.x, step.x, step.y * step.y), Real(0.0025f), Real(0.16f));
            Real const sign(frame.knows_toward ? 1.f : -1.f);
            Real best(0.f), weights(0.f), of_whole(0.f);
            auto sum = zero<vec3<Real>>();
            auto onward = zero<vec2<Real>>();
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    auto const d = distance<Real>(fetch<Real>(frame.depth, size, place, dx, dy));
                    vec3<Real> const c = fetch<Real>(frame.colour, size, place, dx, dy);
                    // Things of one depth that move differently are different.
                    vec2<Real> const its = fetch<Real>(frame.knows_toward ? frame.toward : frame.onward, size, place, dx, dy);
                    auto const amiss_x = fma(its.x, sign, step.x), amiss_y = fma(its.y, sign, step.y);
                    auto const amiss = fma(amiss_x, amiss_x, amiss_y * amiss_y);
                    auto const goes_there = either(invert(is_finite(amiss)), amiss <= allowed);
                    auto const found =
                        both(goes_there, is_finite(SeenSurface<Real>::mark_of(c)), d >= surface.nearest, d <= surface.farthest);
                    auto const any_weight = across.at[dx + 1] * down.at[dy + 1];
                    // The other surface is a gap in this one. What hides both, lies between them or goes elsewhere says nothing.
                    if constexpr (measures_whole) of_whole = of_whole + masked(either(found, d >= surface.behind), any_weight);
                    auto const w = masked(found, any_weight);
                    sum = add_scaled(sum, select(found, c, zero<vec3<Real>>()), w);
                    weights = weights + w;
                    if (k + 1 == count) continue;
                    auto const closer = w > best;
                    best = select(closer, w, best);
                    onward = select(closer, vec2<Real>(fetch<Real>(frame.onward, size, place, dx, dy)), onward);
                }
            alive = both(alive, weights > Real(0.f));
            auto const counts = both(alive, is_unchanged(surface, sum, weights));
            surface.colours = add_scaled(surface.colours, sum, masked(counts, Real(1.f)));
            surface.weights = surface.weights + masked(counts, weights);
            if constexpr (measures_whole) whole = whole + masked(counts, of_whole);
            where = where + onward, step = onward;
            alive = both(alive, all_finite(where));
        }
    }
    template <class Real> struct ThreeWeights { Real at[3]; };
    /// Of the samples at a column and those beside it, or rows; 0 outside.
    template <class Real> QUELL_KERNEL ThreeWeights<Real> three_weights(Real column, Real at, int size) const {
        auto const weight = [&](Real off) QUELL_INLINED { return quell::exp(off * off * falloff_of(policy)); };
        auto const off = column + 0.5f - at;
        return {masked(column > Real(0.f), weight(off - 1.f)), weight(off),
                masked(column < Real(static_cast<float>(size - 1)), weight(off + 1.f))};
    }
    /// Whether the mean colour lies among those of the surface now, as far as policy.change says.
    template <class Real> QUELL_KERNEL auto is_unchanged(SeenSurface<Real> const& surface, vec3<Real> const& sum, Real weights) const {
        if (!(policy.change > 0.f)) return weights >= Real(0.f);
        auto const mark = SeenSurface<Real>::mark_of(sum);
        float const less = 1.f - policy.change, more = 1.f + policy.change;
        return both(mark * more >= surface.least * weights * less, mark * less <= surface.most * weights * more);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
