#pragma once

#include <quell/frame/channels.hpp>
#include <quell/frame/cursor/taps.hpp>
#include <quell/link/residual/residual.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Logarithms of the picture's light: of the pixel's own, and of that around it.
struct LightLogarithms : ExactChannel<2> {
    static constexpr auto name = "light_logarithms";
};
/// Each half of a checkerboard's residual smoothed, and which part of a pixel's weights that half has.
struct FirstHalf : ExactChannel<4> {
    static constexpr auto name = "first_half";
};
struct SecondHalf : ExactChannel<4> {
    static constexpr auto name = "second_half";
};

/// Smooths both halves of a residual over surfaces, and over pieces of like light, by a B-spline's 5x5 taps. What differs weighs
/// 1 / (1 + d^2), which far neighbours still have a little of: with weights that fall exponentially, a level has mostly the pixel's own
/// noise, and held-out samples speak against it.
struct SmoothHalves {
    static constexpr auto name = "smooth residual";
    using reads = Channels<Normal, Depth, LightLogarithms, FirstHalf, SecondHalf>;
    using emits = Channels<FirstHalf, SecondHalf>;
    int step;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        constexpr float spline[] = {0.375f, 0.25f, 0.0625f}, per_depth_range = 20.f, per_light_range = 1.f / .15f;
        auto const n = px[normal];
        auto const z = seen_depth(px), light = px.template channel_component<0>(LightLogarithms{});
        auto first = zero<Value<4, Real>>(), second = zero<Value<4, Real>>();
        Real whole(0.f);
        for_each_tap<2>(px, step, spline, [&](auto const& near_by, Real known, int dx, int dy) QUELL_INLINED {
            auto weight = known;
            if (dx != 0 || dy != 0) {
                auto p = max(dot(vec3<Real>(n), vec3<Real>(near_by[normal])), Real(0.f));
                p = p * p, p = p * p, p = p * p, p = p * p, p = p * p; // to the power of 32
                auto const there = seen_depth(near_by), behind = (there - z) / max(there, z) * per_depth_range;
                auto const darker = (near_by.template channel_component<0>(LightLogarithms{}) - light) * per_light_range;
                weight = known * p / (fma(behind, behind, Real(1.f)) * fma(darker, darker, Real(1.f)));
            }
            first = add_scaled(first, near_by[FirstHalf{}], weight), second = add_scaled(second, near_by[SecondHalf{}], weight);
            whole = whole + weight;
        });
        auto const per_whole = 1.f / whole;
        return emitted<Real>(FirstHalf{}, scale(first, per_whole)).with(SecondHalf{}, scale(second, per_whole));
    }

private:
    /// A large number where nothing is seen.
    template <class Px> QUELL_KERNEL static auto seen_depth(Px const& px) {
        using Real = typename Px::Real;
        return max(min(px[depth], Real(1e30f)), Real(1e-30f));
    }
};

/// The residual smoothed, of all samples.
template <class Px> QUELL_KERNEL auto smoothed(Px const& px) {
    using Real = typename Px::Real;
    auto const both_halves = add_scaled(px[FirstHalf{}], px[SecondHalf{}], Real(1.f));
    return scale(colour_of(both_halves), 1.f / max(both_halves.w, Real(1e-6f)));
}
/// The same of samples of the checkerboard's other half. Where next to none of these is of this surface, nothing is known.
template <class Px> QUELL_KERNEL auto smoothed_of_others(Px const& px) {
    using Real = typename Px::Real;
    auto const others = select(checkerboard_half(px) > Real(0.5f), px[FirstHalf{}], px[SecondHalf{}]);
    return scale(colour_of(others), masked(others.w > Real(.02f), 1.f / max(others.w, Real(.02f))));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
