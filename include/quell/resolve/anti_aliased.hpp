#pragma once

#include <quell/execute/executor.hpp>
#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/nearness.hpp>

#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Colours of one ray per pixel, anti-aliased by those of other frames (after Yang et al. 2009, "Amortized supersampling", with samples in
/// place of pictures, so that nothing is blurred from frame to frame). Each sample of a frame around is moved along its own motion to where
/// it is now. It counts where its depth is found among the 3x3 pixels there, and by a Gaussian of its distance from the pixel's centre.
///
/// The samples of a pixel are those of two surfaces at most, the nearest and the farthest of the 3x3: each is multiplied by the light of
/// its own surface, so that an edge is as mixed as its pixel covers of both.
struct AntiAliased {
    static constexpr int most_frames = 4; ///< to each side

    float deviation = 0.5f; ///< of the Gaussian, in pixels
    float range = 0.03f;    ///< part of the depth by which samples may be off
    float own = 1.f;        ///< weight of the pixel's own sample
    bool by_surface = true; ///< whether each surface has its own light; else both have the pixel's
    float change = 0.f;     ///< colours whose mean around differs by more than this part have changed by themselves; 0: none does
};

namespace detail {
/// What is read of a frame around.
struct AroundFrame {
    ViewOf<Planar<>, Albedo> colour{};
    ViewOf<Planar<>, Depth> depth{};
    ViewOf<Planar<>, Motion> onward{}; ///< from there to the next frame farther away
    ViewOf<Planar<>, Motion> toward{}; ///< from there to the next frame nearer by; not finite: not known
};

/// The pass of AntiAliased.
struct AntiAliasJob {
    static constexpr auto name = "anti-alias";
    using Colour = ViewOf<Planar<>, Albedo>;
    AntiAliased policy;
    Colour colour, light;
    ViewOf<Planar<>, Depth> depth;
    ViewOf<Planar<>, Motion> motion, motion_next;
    std::array<AroundFrame, AntiAliased::most_frames> before, after;
    int count_before, count_after;
    Colour to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        auto const size = depth.size;
        vec2<Real> const centre{Real(static_cast<float>(x) + 0.5f) + lanes<Real>(), Real(static_cast<float>(y) + 0.5f)};
        Surface<Real> front, back;
        front.nearness = Real(-1.f), back.nearness = Real(1e38f);
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, int, int) QUELL_INLINED {
            auto const d = masked(inside, nearness(load_pixels<Real>(depth, column, row)));
            auto const nearer = both(inside, d > front.nearness), farther = both(inside, d < back.nearness);
            if (any(nearer)) front.take(nearer, d, column, row, *this);
            if (any(farther)) back.take(farther, d, column, row, *this);
        });
        auto const middle = (front.nearness + back.nearness) * 0.5f;
        auto const is_two = front.nearness > back.nearness * (1.f + policy.range) + Real(1e-20f);
        auto const here = nearness(load_pixels<Real>(depth, x, y));
        front.is_here = either(invert(is_two), here > middle), back.is_here = both(is_two, here <= middle);
        each_neighbour<Real>(x, y, [&](auto inside, int column, int row, int dx, int dy) QUELL_INLINED {
            auto const d = nearness(load_pixels<Real>(depth, column, row));
            auto const of_front = both(inside, either(invert(is_two), d > middle)), of_back = both(inside, is_two, d <= middle);
            auto const c = load_pixels<Real>(colour, column, row), l = load_pixels<Real>(light, column, row);
            Real const w(weight_at(static_cast<float>(dx), static_cast<float>(dy)));
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
        auto const value = policy.by_surface
                               ? around
                               : scale(add_scaled(scale(around, others), load_pixels<Real>(colour, x, y) * own_light, Real(policy.own)),
                                       1.f / (others + policy.own));
        auto const plain = load_pixels<Real>(colour, x, y) * own_light;
        store_pixels<Real>(to, x, y, select(both(all_finite(value), others > Real(0.f)), value, plain), count);
    }

private:
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
            motion = select(mask, load_pixels<Real>(job.motion, column, row), motion);
            motion_next = select(mask, load_pixels<Real>(job.motion_next, column, row), motion_next);
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
        Real const width(static_cast<float>(depth.size.width));
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (y + dy < 0 || y + dy >= depth.size.height) continue;
                auto const column = columns + static_cast<float>(dx);
                visit(both(column >= Real(0.f), column < width), x + dx, y + dy, dx, dy);
            }
    }
    /// Adds the samples of a surface in the frames to one side.
    template <class Real, std::size_t n>
    QUELL_KERNEL void follow(Surface<Real>& surface, vec2<Real> const& centre, vec2<Real> const& first,
                             std::array<AroundFrame, n> const& frames, int count, Extent size) const {
        auto step = first;
        auto where = centre + first;
        auto alive = both(all_finite(where), surface.pixels > Real(0.f));
        for (int k = 0; k < count; ++k) {
            auto const& frame = frames[static_cast<std::size_t>(k)];
            alive = both(alive, where.x >= Real(0.f), where.y >= Real(0.f), where.x < Real(static_cast<float>(size.width)),
                         where.y < Real(static_cast<float>(size.height)));
            if (!any(alive)) return;
            auto const safe = select(alive, where, centre);
            auto const place = nearest_inside(size, vec2<Real>{floor(safe.x), floor(safe.y)});
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
                    auto const back = fetch<Real>(frame.toward, size, place, dx, dy);
                    auto const amiss_x = back.x + step.x, amiss_y = back.y + step.y;
                    auto const amiss = amiss_x * amiss_x + amiss_y * amiss_y;
                    auto const goes_there = either(invert(is_finite(amiss)), amiss <= allowed);
                    auto const found = both(inside, goes_there, all_finite(c), d >= surface.low, d <= surface.high);
                    auto const off_x = column + 0.5f - safe.x, off_y = row + 0.5f - safe.y;
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

} // namespace quell::inline QUELL_INSTRUCTION_SET
