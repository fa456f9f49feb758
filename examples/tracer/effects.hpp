#pragma once

#include "mask.hpp"

#include <quell/presets/general.hpp>

#include <array>
#include <string>
#include <vector>

namespace quell::tracer {

// What quell-trace writes for an effect, what its converged reference is made of, and the masks of the pixels that it touches.

struct CompositeEffect {
    static constexpr auto name = "composite";
    using channels = union_of<decltype(presets::none(radiance))::reads, decltype(presets::surface_clamp(radiance, Demodulate{}))::reads,
                              decltype(presets::svgf(radiance, Demodulate{}))::reads>;
    using reference = Channels<Radiance>;
    static constexpr std::array masks{Effect::shadow, Effect::glossy, Effect::curved, Effect::indirect};
};
struct ShadowEffect {
    static constexpr auto name = "shadow";
    using channels =
        Channels<Normal, Depth, Position, Motion, Direct, Visibility, Light, LightPrevious, Blocker, BlockerPrevious, ReceiverPrevious>;
    using reference = Channels<Direct, Visibility>;
    static constexpr std::array masks{Effect::shadow};
};
struct GlossyEffect {
    static constexpr auto name = "glossy";
    using channels = Channels<Normal, Depth, Position, Roughness, Motion, ReceiverPrevious, Glossy, GlossyHit, GlossyHitPrevious>;
    using reference = Channels<Glossy>;
    static constexpr std::array masks{Effect::glossy, Effect::curved};
};
struct IndirectEffect {
    static constexpr auto name = "indirect";
    using channels = Channels<Albedo, Normal, Depth, Motion, Indirect, IndirectDirection>;
    using reference = Channels<Albedo, Indirect>;
    static constexpr std::array masks{Effect::indirect};
};
struct BlurEffect {
    static constexpr auto name = "blur";
    using channels = Channels<Radiance, Albedo, Normal, Depth, Motion, Sweep, SweepBend, Time>;
    using reference = Channels<Radiance>;
    static constexpr std::array masks{Effect::blur};
};
/// Points of the frame before, shaded anew. Written with `composite` alone, whose light they are of: it takes rays of its own.
struct GradientEffect {
    static constexpr auto name = "gradient";
    using channels = decltype(CompositeEffect::channels{} | Channels<GradientOf<Radiance>>{});
    using reference = CompositeEffect::reference;
    static constexpr std::array<Effect, 0> masks{};
};

/// Calls f(effect...) with all of them.
decltype(auto) with_all_effects(auto&& f) {
    return f(CompositeEffect{}, ShadowEffect{}, GlossyEffect{}, IndirectEffect{}, BlurEffect{}, GradientEffect{});
}

/// Calls f(effect) for each.
void for_each_effect(auto&& f) {
    with_all_effects([&](auto... effects) { (f(effects), ...); });
}

[[nodiscard]] inline std::vector<std::string> all_effect_names() {
    std::vector<std::string> names;
    for_each_effect([&](auto effect) { names.emplace_back(effect.name); });
    return names;
}

namespace detail {

/// What is written besides where the shutter is open: how shadows and reflections move meanwhile.
template <class Set>
using EffectSweeps =
    union_of<std::conditional_t<Set::template has<Time> && Set::template has<Visibility>, Channels<SweepOf<Visibility>>, Channels<>>,
             std::conditional_t<Set::template has<Time> && Set::template has<Glossy>, Channels<SweepOf<Glossy>>, Channels<>>>;

template <class Set> RayCounts with_channels(auto const&, auto&& f, Set) {
    if constexpr (Set::size > 0)
        // In one order, so that equal sets are the same type.
        return f(common_to<AllChannels, decltype(Set{} | EffectSweeps<Set>{})>{});
    else
        return {};
}
/// Not with every set: there would be twice as many.
template <class Set> RayCounts with_channels(auto const& is_chosen, auto&& f, Set set, GradientEffect) {
    if constexpr (contained_in<Set, GradientEffect::channels>) {
        if (is_chosen(GradientEffect::name)) return with_channels(is_chosen, f, GradientEffect::channels{});
    }
    return with_channels(is_chosen, f, set);
}
template <class Set, class First, class... Rest> RayCounts with_channels(auto const& is_chosen, auto&& f, Set set, First, Rest... rest) {
    if (is_chosen(First::name)) return with_channels(is_chosen, f, set | typename First::channels{}, rest...);
    return with_channels(is_chosen, f, set, rest...);
}

} // namespace detail

/// Calls f with the set of all channels of the effects whose names is_chosen(name) tells. There is one instance of f for each set that may
/// come of it.
RayCounts with_channels(auto const& is_chosen, auto&& f) {
    return with_all_effects([&](auto... effects) { return detail::with_channels(is_chosen, f, Channels<>{}, effects...); });
}

} // namespace quell::tracer
