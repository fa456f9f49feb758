#include <denoise/preset_memory.hpp>

#include <quell/presets/named.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

/// Frames after which a blend policy gives an old frame 1/e of its first weight.
template <class Blend> constexpr float memory_of(Blend const& blend) {
    if constexpr (requires { blend.inner; })
        return memory_of(blend.inner);
    else if constexpr (requires { blend.cap; })
        return blend.cap;
    else if constexpr (requires { blend.alpha; })
        return 1.f / blend.alpha;
    else
        static_assert(sizeof(Blend) == 0, "a blend policy whose memory isn't known");
}

/// How many memories make what is missing invisible: measured, see docs/programs.md. Least where a filter as wide as the noise that is left
/// follows, or layers of motion blur leave the image; less where history is clamped; else all of the frames' noise has to fade.
template <class Blend> inline constexpr float memories = 9.f;
template <class Inner> inline constexpr float memories<WithVariance<Inner>> = 2.f;
template <class Inner, class Range, class Axes, int radius> inline constexpr float memories<Clamped<Inner, Range, Axes, radius>> = 4.f;
template <ChannelTag S> inline constexpr float memories<PairBlend<S>> = 1.f;
template <ChannelTag S> inline constexpr float memories<LayerBlend<S>> = 1.f;

template <class Stage> constexpr float warm_up_of_stage(Stage const& stage) {
    if constexpr (requires { stage.blending; })
        return memory_of(stage.blending) * memories<std::remove_cvref_t<decltype(stage.blending)>>;
    else
        return 0.f;
}

template <class P> constexpr float warm_up_of_pipeline(P const& pipeline) {
    auto const largest = [](auto const& parts, auto const& warm_up) {
        return std::apply([&](auto const&... part) { return std::max({0.f, warm_up(part)...}); }, parts);
    };
    if constexpr (requires { pipeline.pipelines; })
        return largest(pipeline.pipelines, [](auto const& part) { return warm_up_of_pipeline(part); });
    else
        return largest(pipeline.stages, [](auto const& stage) { return warm_up_of_stage(stage); });
}

template <class Named> float warm_up_of_preset(Named const&) {
    constexpr auto pipeline = Named::usual();
    return warm_up_of_pipeline(pipeline); // joining both sides begins anew in each frame
}

} // namespace

int usual_warm_up(std::string const& preset) {
    float frames = 0;
    for_each_preset([&](auto const& named) {
        if (named.name == preset) frames = warm_up_of_preset(named);
    });
    return static_cast<int>(std::ceil(frames));
}

} // namespace quell::examples
