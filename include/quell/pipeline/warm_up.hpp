#pragma once

#include <quell/pipeline/chain.hpp>
#include <quell/pipeline/composite.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
template <class Stage> constexpr float frames_seen_of(Stage const&) { return 0.f; }
template <class M, class B, class F> constexpr float frames_seen_of(Temporal<M, B, F> const& stage) {
    auto const memory = memory_of(stage.blending);
    return memory.frames * memory.times;
}
/// How many frames back policies look that follow no motion by a Temporal.
template <class P>
inline constexpr int frames_looked_back = P::carries::size > 0              ? kept_frames_of<P> + 1
                                          : !P::has_temporal && P::has_past ? 1
                                                                            : 0;
} // namespace detail

/// How many frames before the first make a frame what it is in the whole sequence, to less than 0.1 % of FLIP: as far back as the blend
/// policies of the pipeline say that they remember. 0 where there is no history.
///
///     static_assert(warm_up_frames(presets::general(radiance)) == 48);
template <ChannelTag S, class... Parts> [[nodiscard]] constexpr int warm_up_frames(Pipeline<S, Parts...> const& pipeline) {
    float const frames = std::apply(
        [](auto const&... stage) {
            return std::max({0.f, detail::frames_seen_of(stage)...});
        },
        pipeline.stages);
    auto const whole = static_cast<int>(frames);
    return whole + (static_cast<float>(whole) < frames ? 1 : 0) + detail::frames_looked_back<Pipeline<S, Parts...>>;
}
/// The longest of its parts.
template <class... Ps> [[nodiscard]] constexpr int warm_up_frames(Composite<Ps...> const& composite) {
    return std::apply([](auto const&... pipeline) { return std::max({0, warm_up_frames(pipeline)...}); }, composite.pipelines);
}
/// Those of all denoisers: a link looks back at pictures that the ones before have made of the frames before.
template <class First, class... Links> [[nodiscard]] constexpr int warm_up_frames(Chain<First, Links...> const& chain) {
    return std::apply([&](auto const&... link) { return (warm_up_frames(chain.first) + ... + warm_up_frames(link)); }, chain.links);
}
/// Those of the frames before: the frames after begin anew in each call.
template <class P> [[nodiscard]] constexpr int warm_up_frames(TwoSided<P> const& denoiser) { return warm_up_frames(denoiser.pipeline); }
/// And the frames that are kept.
template <class P, class Policy> [[nodiscard]] constexpr int warm_up_frames(Resolved<P, Policy> const& resolved) {
    return warm_up_frames(resolved.pipeline) + Policy::past_frames;
}
/// @cond
template <class P> [[nodiscard]] constexpr int warm_up_frames(P const&) {
    static_assert(
        sizeof(P) == 0,
        "warm_up_frames(pipeline): it takes a Pipeline, a Composite, a ByEvidence, a TwoSided, a Chain, or what presets::resolve makes");
    return 0;
}
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
