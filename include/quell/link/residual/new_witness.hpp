#pragma once

#include <quell/link/residual/residual_bands.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far what a frame before or after lacks says something new of what this one lacks (RepeatedResidual). Correlations of both residuals
/// over a window tell whether their noise is independent:
///
/// - A residual that is nearly the same has the same samples, as a frame that is held: no two frames' noise is that small beside what both
///   lack.
/// - One that goes with that of now more on the screen than along the motion has noise that stays there, as that of a seed that is
///   repeated.
/// - What both have in common, beyond chance, and what has nothing in common with its own neighbours, is noise that goes along with
///   surfaces, as that of light from a texture or a cache. What a filter takes out of a picture by mistake has edges, lines and shapes, if
///   fine ones. The measure is the part of the product of both that is left where one is blurred, as 0 for white noise and 1 for smooth
///   shapes.
///
/// Each of them goes from nothing to whole between two numbers.
struct NewWitness {
    float alike = .6f;      ///< correlation of a residual around with that of now, up to which that frame counts whole
    float same = .85f;      ///< and from which on it counts nothing
    float stays = .05f;     ///< by how much correlation may be larger on the screen: whole up to that, and nothing from twice as much on
    float common = .2f;     ///< correlation from which on neighbours are asked; below two fifths of that they are not, as it may be chance
    float scattered = .1f;  ///< the measure of neighbours up to which what is common counts nothing
    float in_shapes = .18f; ///< and from which on it counts whole
};

namespace detail {

/// Of a residual of now, of one around where its surfaces are now, of that one on the screen, and of its blur: the squares of the first
/// three, and the products of the first with the others.
struct WitnessProducts : ExactChannel<6> {
    static constexpr auto name = "witness_products";
};
struct WitnessProductsOfRows : ExactChannel<6> {
    static constexpr auto name = "witness_products_of_rows";
};

inline constexpr int witness_radius = 16; ///< of the windows, in pixels

/// What the frame before keeps, or what the host says of the frame after.
template <Around frame> using lacking_there = std::conditional_t<frame == Around::before, Channels<>, Channels<LackingNext>>;
template <Around frame> using kept_lacking = std::conditional_t<frame == Around::before, Channels<Lacking>, Channels<>>;

/// What a frame around lacks at a pixel and so many to the right and below, if the place lies in the image.
template <Around frame, class Px, class Place> QUELL_KERNEL auto lacking_at(Px const& px, Place const& place, int dx, int dy) {
    if constexpr (frame == Around::before)
        return px.past(place, dx, dy)[Lacking{}];
    else
        return px.elsewhere({place.column + static_cast<float>(dx), place.row + static_cast<float>(dy)}, LackingNext{});
}

/// Takes a residual of a frame around to where its surfaces are now, between its pixels.
template <Around frame> struct MoveResidual {
    static constexpr auto name = frame == Around::before ? "residual before" : "residual after";
    using Vectors = std::conditional_t<frame == Around::before, Motion, MotionNext>;
    using reads = union_of<Channels<Vectors, LightAround>, lacking_there<frame>, FrameBrightness::whole>;
    using reads_kept = kept_lacking<frame>;
    using emits = Channels<ResidualThere<frame>>;
    static constexpr int farthest_tap = frame == Around::before ? 0 : anywhere;
    float most; ///< a residual is at most so many times the light around

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        if (frame == Around::before && !px.has_past()) return emitted<Real>(ResidualThere<frame>{}, zero<Value<4, Real>>());
        auto const motion = px[Vectors{}];
        auto const width = Real(to_real(px.size().width)), height = Real(to_real(px.size().height));
        auto const column = px.columns() + motion.x, row = px.row_of_lanes() + motion.y;
        auto const is_inside =
            both(is_finite(column), is_finite(row), column > Real(-.5f), column<width - .5f, row> Real(-.5f), row < height - .5f);
        auto const at_column = select(is_inside, column, Real(0.f)), at_row = select(is_inside, row, Real(0.f));
        auto const left = floor(at_column), top = floor(at_row);
        auto const right_part = at_column - left, lower_part = at_row - top;
        auto sum = zero<vec3<Real>>();
        Real whole(0.f);
        PixelCoordinates<Real> const place(left, top);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                auto const x = left + static_cast<float>(i), y = top + static_cast<float>(j);
                auto const counts = both(x >= Real(0.f), x < width, y >= Real(0.f), y < height);
                auto const weight = masked(counts, (i == 0 ? 1.f - right_part : right_part) * (j == 0 ? 1.f - lower_part : lower_part));
                sum = add_scaled(sum, lacking_at<frame>(px, place, i, j), weight), whole = whole + weight;
            }
        auto const value = scale(sum, 1.f / (max(whole, Real(1e-6f)) * frame_brightness(px)));
        auto const is_known = both(is_inside, all_finite(value));
        auto const limits = limited(value, px[LightAround{}] * most);
        return emitted<Real>(ResidualThere<frame>{}, with_last(map([&](Real a) QUELL_INLINED { return masked(is_known, a); }, limits),
                                                               masked(is_known, Real(1.f))));
    }
};

/// Takes the products.
template <Around frame> struct TakeWitness {
    static constexpr auto name = "witness";
    using reads =
        union_of<Channels<Lacking, ResidualThere<frame>, Blurs<frame>, LightAround>, lacking_there<frame>, FrameBrightness::whole>;
    using reads_kept = kept_lacking<frame>;
    using emits = Channels<WitnessProducts>;
    static constexpr int farthest_tap = 0;
    float most;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = px[LightAround{}], per_square = 1.f / (light * light);
        auto const a = residual_of<Around::now>(px), b = residual_of<frame>(px), c = on_screen(px), blurred = blurs_of<frame>(px).finer;
        return emitted<Real>(WitnessProducts{},
                             Components<6, Real>{{dot(a, a) * per_square, dot(a, b) * per_square, dot(b, b) * per_square,
                                                  dot(a, c) * per_square, dot(c, c) * per_square, dot(a, blurred) * per_square}});
    }

private:
    template <class Px> QUELL_KERNEL auto on_screen(Px const& px) const {
        using Real = typename Px::Real;
        if constexpr (frame == Around::before) {
            if (!px.has_past()) return zero<vec3<Real>>();
            PixelCoordinates<Real> const here(px.columns(), px.row_of_lanes());
            return in_limits(px, vec3<Real>(px.past(here)[Lacking{}]));
        } else
            return in_limits(px, vec3<Real>(px[LackingNext{}]));
    }
    template <class Px, class V> QUELL_KERNEL V in_limits(Px const& px, V const& value) const {
        return limited(scale(value, 1.f / frame_brightness(px)), px[LightAround{}] * most);
    }
};

/// Finds how far a frame around counts.
template <Around frame> struct JudgeWitness {
    static constexpr auto name = "new witness";
    using reads = Channels<ResidualThere<frame>, WitnessProductsOfRows>;
    using emits = Channels<Witness<frame>>;
    static constexpr int farthest_tap = witness_radius;
    NewWitness rule;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const sums = sum_along_column(px, WitnessProductsOfRows{}, witness_radius);
        auto const& of_window = sums.at;
        auto const tiny = Real(1e-30f);
        auto const correlation = [&](Real const& common, Real const& square)
                                     QUELL_INLINED { return common / max(sqrt(of_window[0]) * sqrt(square), tiny); };
        auto const ramp = [&](Real const& value, float nothing, float whole)
                              QUELL_INLINED { return clamp((value - nothing) * (1.f / (whole - nothing)), Real(0.f), Real(1.f)); };
        constexpr float of_white = finer_gaussian.of_own_pixel();
        auto const alike = correlation(of_window[1], of_window[2]), stays = correlation(of_window[3], of_window[4]) - alike;
        auto const smooth = (of_window[5] / max(of_window[1], tiny) - of_white) * (1.f / (1.f - of_white));
        auto const is_new = ramp(alike, rule.same, rule.alike) * ramp(stays, 2.f * rule.stays, rule.stays);
        auto const is_detail = max(ramp(smooth, rule.scattered, rule.in_shapes), ramp(alike, rule.common, .4f * rule.common));
        auto const known = px[ResidualThere<frame>{}].w;
        return emitted<Real>(Witness<frame>{},
                             vec2<Real>{known * max(is_new * is_detail, Real(1e-6f)), known * is_new}); // 0 of the first: unknown
    }
};

/// Passes of a frame around.
template <Around frame> struct CallWitness {
    using parts = Parts<MoveResidual<frame>, BlurResidual<frame>, TakeWitness<frame>, SumRows<WitnessProducts, WitnessProductsOfRows>,
                        JudgeWitness<frame>>;
    NewWitness rule;
    float most;

    constexpr void for_each_pass(auto&& pass) const {
        pass(MoveResidual<frame>{most});
        BlurResidual<frame>{}.for_each_pass(pass);
        pass(TakeWitness<frame>{most}), pass(SumRows<WitnessProducts, WitnessProductsOfRows>{witness_radius});
        pass(JudgeWitness<frame>{rule});
    }
};

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
