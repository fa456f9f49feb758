#pragma once

#include <quell/execute/queue_executor.hpp>
#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/resolve/anti_aliased.hpp>
#include <quell/resolve/nearness.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// What is read of a frame around.
template <class Storage> struct AroundFrame {
    ViewOf<Storage, Albedo> colour{};
    ViewOf<Storage, Depth> depth{};
    ViewOf<Storage, Motion> onward{}; ///< from there to the next frame farther away
    ViewOf<Storage, Motion> toward{}; ///< from there to the next frame nearer by; not finite: not known
    glm::vec2 jitter{0.f};
    bool knows_toward = true; ///< whether there is `toward`
};

/// The pass of AntiAliased.
template <class Storage, class Light, class Target> struct AntiAliasJob {
    static constexpr auto name = "anti-alias";
    AntiAliased policy;
    ColouredFrame<Storage> here;
    Light light;
    std::array<AroundFrame<Storage>, AntiAliased::most_frames> before, after;
    int count_before, count_after;
    Target to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        auto const size = here.depth.size;
        vec2<Real> const centre{Real(static_cast<float>(x) + 0.5f) + lanes<Real>(), Real(static_cast<float>(y) + 0.5f)};
        Surface<Real> front, back;
        front.nearness = Real(-1.f), back.nearness = Real(1e38f);
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, int, int) QUELL_INLINED {
            auto const d = masked(inside, nearness(load_beside<Real>(here.depth, column, row)));
            auto const nearer = both(inside, d > front.nearness), farther = both(inside, d < back.nearness);
            if (any(nearer)) front.take(nearer, d, column, row, *this);
            if (any(farther)) back.take(farther, d, column, row, *this);
        });
        auto const middle = (front.nearness + back.nearness) * 0.5f;
        auto const is_two = front.nearness > back.nearness * (1.f + policy.range) + Real(1e-20f);
        auto const own_depth = nearness(load_pixels<Real>(here.depth, x, y));
        front.is_here = either(invert(is_two), own_depth > middle), back.is_here = both(is_two, own_depth <= middle);
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, int dx, int dy) QUELL_INLINED {
            auto const d = nearness(load_beside<Real>(here.depth, column, row));
            auto const of_front = both(inside, either(invert(is_two), d > middle)), of_back = both(inside, is_two, d <= middle);
            auto const c = load_beside<Real>(here.colour, column, row), l = load_beside<Real>(light, column, row);
            Real const w(weight_at(static_cast<float>(dx) + here.jitter.x, static_cast<float>(dy) + here.jitter.y));
            front.add_own(of_front, d, c, l, w), back.add_own(of_back, d, c, l, w);
            front.whole = front.whole + masked(inside, w);
        });
        if (!policy.by_surface) front.drop_own(), back.drop_own();
        // The surface that the pixel shows has the light that the pixel has.
        auto const own_light = load_pixels<Real>(light, x, y);
        front.finish_own(own_light, policy), back.finish_own(own_light, policy);
        front.behind = back.high;
        auto const visit = [&](Surface<Real>& surface) QUELL_INLINED {
            if (!any(surface.pixels > Real(0.f))) return;
            follow(surface, centre, surface.motion, before, count_before, size);
            follow(surface, centre, surface.motion_next, after, count_after, size);
        };
        visit(front), visit(back);
        // What the surface in front leaves of the pixel is the other's.
        auto const covered = select(back.weights > Real(0.f), front.weights / max(front.whole, Real(1e-20f)), Real(1.f));
        auto const around = mix(shown(back), shown(front), min(covered, Real(1.f)));
        auto const others = front.whole;
        auto const value =
            policy.by_surface ? around
                              : scale(add_scaled(scale(around, others), load_pixels<Real>(here.colour, x, y) * own_light, Real(policy.own)),
                                      1.f / (others + policy.own));
        auto const plain = load_pixels<Real>(here.colour, x, y) * own_light;
        store_pixels<Real>(to, x, y, select(both(all_finite(value), others > Real(0.f)), value, plain), count);
    }

private:
    /// Like load_pixels, which takes a view's own padding before a row. A view without has its border repeated.
    template <class Real, class View> QUELL_KERNEL static auto load_beside(View const& view, int x, int y) {
        if constexpr (requires { view.template load<Real>(x, y); })
            return view.template load<Real>(x, y);
        else
            return fetch<Real>(
                view, view.size,
                nearest_inside(view.size, vec2<Real>{Real(static_cast<float>(x)) + lanes<Real>(), Real(static_cast<float>(y))}), 0, 0);
    }
    template <class Real> struct Surface {
        Real nearness = Real(0.f); ///< of the pixel that it starts from
        vec2<Real> motion = zero<vec2<Real>>(), motion_next = zero<vec2<Real>>();
        Real low = Real(1e38f), high = Real(-1.f); ///< nearness, over the pixels of the 3x3
        vec3<Real> colours = zero<vec3<Real>>(), lights = zero<vec3<Real>>(), plain = zero<vec3<Real>>();
        Real behind = Real(-1.f); ///< nearness, up to which a sample is of the other surface
        Real light_weights = Real(0.f);
        Real weights = Real(0.f); ///< of the colours
        Real whole = Real(0.f);   ///< what they would be if it covered the pixel
        Real pixels = Real(0.f);  ///< of the 3x3
        decltype(Real(0.f) > Real(0.f)) is_here = Real(0.f) > Real(0.f);

        QUELL_KERNEL void take(auto mask, Real d, int column, int row, AntiAliasJob const& job) {
            nearness = select(mask, d, nearness);
            motion = select(mask, load_beside<Real>(job.here.motion, column, row), motion);
            if (job.count_after > 0) motion_next = select(mask, load_beside<Real>(job.here.to_next, column, row), motion_next);
        }
        QUELL_KERNEL void add_own(auto mask, Real d, vec3<Real> const& c, vec3<Real> const& l, Real w) {
            low = select(mask, min(low, d), low), high = select(mask, max(high, d), high);
            auto const known = both(mask, all_finite(c), all_finite(l));
            auto const weight = masked(known, w);
            auto const safe = select(known, c, zero<vec3<Real>>());
            colours = add_scaled(colours, safe, weight);
            lights = add_scaled(lights, select(known, l, zero<vec3<Real>>()), weight);
            plain = plain + safe;
            light_weights = weights = weights + weight, pixels = pixels + masked(known, Real(1.f));
        }
        QUELL_KERNEL void drop_own() { colours = zero<vec3<Real>>(), weights = whole = Real(0.f); }
        QUELL_KERNEL void finish_own(vec3<Real> const& own_light, AntiAliased const& policy) {
            lights = policy.by_surface ? select(is_here, own_light, scale(lights, 1.f / max(light_weights, Real(1e-20f)))) : own_light;
            plain = scale(plain, 1.f / max(pixels, Real(1.f)));
            low = low * (1.f - policy.range), high = high * (1.f + policy.range);
        }
    };
    template <class Real> QUELL_KERNEL static vec3<Real> shown(Surface<Real> const& s) {
        return scale(s.colours, 1.f / max(s.weights, Real(1e-20f))) * s.lights;
    }
    QUELL_KERNEL float weight_at(float dx, float dy) const {
        return quell::exp(-(dx * dx + dy * dy) * (0.5f / (policy.deviation * policy.deviation)));
    }
    template <class Real> QUELL_KERNEL void each_neighbour(int x, int y, auto&& visit) const {
        auto const columns = Real(static_cast<float>(x)) + lanes<Real>();
        Real const width(static_cast<float>(here.depth.size.width));
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (y + dy < 0 || y + dy >= here.depth.size.height) continue;
                auto const column = columns + static_cast<float>(dx);
                visit(both(column >= Real(0.f), column < width), x + dx, y + dy, dx, dy);
            }
    }
    /// Adds the samples of a surface in the frames to one side.
    template <class Real, std::size_t n>
    QUELL_KERNEL void follow(Surface<Real>& surface, vec2<Real> const& centre, vec2<Real> const& first,
                             std::array<AroundFrame<Storage>, n> const& frames, int count, Extent size) const {
        auto step = first;
        auto where = centre + first;
        auto alive = both(all_finite(where), surface.pixels > Real(0.f));
        for (int k = 0; k < count; ++k) {
            auto const& frame = frames[static_cast<std::size_t>(k)];
            alive = both(alive, where.x >= Real(0.f), where.y >= Real(0.f), where.x < Real(static_cast<float>(size.width)),
                         where.y < Real(static_cast<float>(size.height)));
            if (!any(alive)) return;
            auto const safe = select(alive, where, centre);
            auto const place = nearest_inside(size, vec2<Real>{floor(safe.x - frame.jitter.x), floor(safe.y - frame.jitter.y)});
            auto const allowed = fma(fma(step.x, step.x, step.y * step.y), Real(0.0025f), Real(0.16f));
            Real best(0.f), weights(0.f), whole(0.f), plain_count(0.f);
            auto sum = zero<vec3<Real>>(), plain = zero<vec3<Real>>();
            auto onward = zero<vec2<Real>>();
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    auto const column = place.column + static_cast<float>(dx), row = place.row + static_cast<float>(dy);
                    auto const d = nearness(fetch<Real>(frame.depth, size, place, dx, dy));
                    auto const c = fetch<Real>(frame.colour, size, place, dx, dy);
                    auto const inside = both(alive, column >= Real(0.f), row >= Real(0.f), column < Real(static_cast<float>(size.width)),
                                             row < Real(static_cast<float>(size.height)));
                    // Things of one depth that move differently are different.
                    vec2<Real> const its = fetch<Real>(frame.knows_toward ? frame.toward : frame.onward, size, place, dx, dy);
                    Real const sign(frame.knows_toward ? 1.f : -1.f);
                    auto const amiss_x = fma(its.x, sign, step.x), amiss_y = fma(its.y, sign, step.y);
                    auto const amiss = amiss_x * amiss_x + amiss_y * amiss_y;
                    auto const goes_there = either(invert(is_finite(amiss)), amiss <= allowed);
                    auto const found = both(inside, goes_there, all_finite(c), d >= surface.low, d <= surface.high);
                    auto const off_x = column + (0.5f + frame.jitter.x) - safe.x, off_y = row + (0.5f + frame.jitter.y) - safe.y;
                    auto const any_w =
                        masked(inside, quell::exp((off_x * off_x + off_y * off_y) * (-0.5f / (policy.deviation * policy.deviation))));
                    // The other surface is a gap in this one. What hides both, lies between them or goes elsewhere says nothing.
                    whole = whole + masked(either(found, d <= surface.behind), any_w);
                    auto const w = masked(found, any_w);
                    auto const colour_there = select(found, c, zero<vec3<Real>>());
                    sum = add_scaled(sum, colour_there, w);
                    plain = plain + colour_there, plain_count = plain_count + masked(found, Real(1.f));
                    weights = weights + w;
                    auto const closer = w > best;
                    best = select(closer, w, best);
                    if (k + 1 < count) onward = select(closer, fetch<Real>(frame.onward, size, place, dx, dy), onward);
                }
            alive = both(alive, best > Real(0.f));
            auto counts = alive;
            if (policy.change > 0.f) {
                auto const a = luminance(scale(plain, 1.f / max(plain_count, Real(1.f)))), b = luminance(surface.plain);
                counts = both(counts, abs(a - b) <= (abs(a) + abs(b)) * policy.change);
            }
            surface.colours = add_scaled(surface.colours, sum, masked(counts, Real(1.f)));
            surface.weights = surface.weights + masked(counts, weights);
            surface.whole = surface.whole + masked(counts, whole);
            where = where + onward, step = onward;
            alive = both(alive, all_finite(where));
        }
    }
};
} // namespace detail

/// Multiplies light by a frame's colours, anti-aliased by those of frames around it.
///
/// For hosts of several signals, or of light that is added: each signal's light is multiplied by its own colours. What is added, such as
/// emission, is the colour, and 1 its light; it may change by itself, which `policy.change` is for. Hosts of one signal have
/// presets::anti_aliased(), which keeps the frames too.
/// @param policy   how
/// @param executor runs the pass
/// @param here     the frame that the light is of
/// @param before   frames before it, the nearest first, up to the first of another size; AntiAliased::most_frames of them are looked at
/// @param after    the same after it, as far as `to_next` is known; none in real time
/// @param light    a view of three components
/// @param to       a view of three components, other than the others
template <Executor E, class Storage, ImageView Light, ImageView To>
void anti_alias(AntiAliased const& policy, E const& executor, ColouredFrame<Storage> const& here,
                std::span<std::type_identity_t<ColouredFrame<Storage>> const> before,
                std::span<std::type_identity_t<ColouredFrame<Storage>> const> after, Light const& light, To const& to) {
    detail::AntiAliasJob<Storage, Light, To> job{policy, here, light, {}, {}, 0, 0, to};
    auto const size = here.depth.size;
    for (auto const& frame : before.first(std::min(before.size(), job.before.size()))) {
        if (!(frame.depth.size == size)) break;
        job.before[static_cast<std::size_t>(job.count_before++)] = {frame.colour,  frame.depth,  frame.motion,
                                                                    frame.to_next, frame.jitter, frame.knows_next};
    }
    bool is_known = here.knows_next;
    for (auto const& frame : after.first(std::min(after.size(), job.after.size()))) {
        if (!is_known || !(frame.depth.size == size)) break;
        job.after[static_cast<std::size_t>(job.count_after++)] = {frame.colour, frame.depth,  frame.to_next,
                                                                  frame.motion, frame.jitter, true};
        is_known = frame.knows_next;
    }
    detail::run_or_enqueue(executor, Region{0, 0, size.width, size.height}, job);
    detail::submit_queue(executor);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
