#pragma once

#include <quell/link/residual/residual.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What the picture of a frame lacks of its samples: these minus the picture, within limits, and 0 where there is no sample.
struct Lacking : ExactChannel<3> {
    static constexpr auto name = "lacking";                    ///< of the channel
    static constexpr std::string_view component_names = "RGB"; ///< in files
};
inline constexpr Lacking lacking; ///< of a history
/// What the picture of the frame after lacks: its Lacking, by a host that has denoised that frame already. Not finite: not known.
struct LackingNext : Colour {
    static constexpr auto name = "lacking_next"; ///< of the channel
    static constexpr bool full_precision = true; ///< never half
};
inline constexpr LackingNext lacking_next; ///< of a frame

namespace detail {

/// Limits values to so many times the light; what is not finite becomes 0.
template <class Real> QUELL_KERNEL vec3<Real> limited(vec3<Real> const& value, Real most) {
    return map([&](Real a) QUELL_INLINED { return masked(is_finite(a), clamp(a, -most, most)); }, value);
}

/// Takes what the picture lacks.
/// @tparam Samples the channel that the picture was made of
/// @tparam Made    channels that it makes of it
template <ChannelTag Samples> struct TakeLacking {
    static constexpr auto name = "lacking";
    using reads = union_of<Channels<Samples, RowBrightness>, FrameBrightness::whole>;
    using emits = Channels<LightAround>;
    using keeps = Channels<Lacking>;
    static constexpr int farthest_tap = light_radius;
    float most; ///< so many times the light around

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const sample = px[Samples{}];
        auto const around = light_around(px);
        auto const is_known = both(is_light(sample), invert(px.missing()));
        auto const off = map([&](Real s, Real p) QUELL_INLINED { return masked(is_known, s - p); }, sample, px.signal());
        return emitted<Real>(Lacking{}, limited(off, around * frame_brightness(px) * most)).with(LightAround{}, around);
    }
};

} // namespace detail

/// Makes a picture of what a picture lacks of its samples, for the frame before: its channel `lacking_next`.
///
///     constexpr auto lack = Pipeline{denoised, Spatial{LackingOfSamples<Radiance>{}}};
///
/// @tparam Samples the channel of three components that the picture was made of, linear
template <ChannelTag Samples = Radiance> struct LackingOfSamples {
    float most = 20.f; ///< as that of RepeatedResidual
    /// @cond
    struct Show {
        static constexpr auto name = "lacking";
        using reads = Channels<Lacking>;
        static constexpr int farthest_tap = 0;
        QUELL_KERNEL auto filter(auto px) const { return px[Lacking{}]; }
    };
    using parts = Parts<detail::FrameBrightness, detail::SumBrightnessOfRows, detail::TakeLacking<Samples>, Show>;
    /// @endcond

    /// Its passes.
    constexpr void for_each_pass(auto&& pass) const {
        detail::FrameBrightness{}.for_each_pass(pass);
        pass(detail::SumBrightnessOfRows{}), pass(detail::TakeLacking<Samples>{most}), pass(Show{});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
