#pragma once

#include "chart_effect.hpp"

#include <quell/presets/named.hpp>

#include <tuple>

namespace quell::bench {

/// Whether a pipeline makes motion blur of samples of different times.
template <class P> inline constexpr bool blurs_samples = P::reads::template has<Time>;
/// Whether a pipeline makes motion blur of a picture of one instant.
template <class P> inline constexpr bool blurs_picture = P::reads::template has<Sweep> && !blurs_samples<P>;

/// The presets for which `wanted<P>` holds, P being the pipeline for a signal, as a tuple of Named. Presets of all signals are among them
/// where the signal is `radiance`.
template <class Wanted> auto charted_presets(Wanted, ChannelTag auto signal, auto... parts) {
    using Signal = decltype(signal);
    auto const charted = [&](auto const& preset) {
        using Preset = std::remove_cvref_t<decltype(preset)>;
        constexpr bool whole_picture = std::is_same_v<typename Preset::signal_type, AllSignals> && std::is_same_v<Signal, Radiance>;
        if constexpr (whole_picture || Preset::template serves<Signal>) {
            auto const pipeline = preset.make(signal, parts...);
            if constexpr (Wanted::template of<std::remove_const_t<decltype(pipeline)>>)
                return std::tuple(Named{std::string(preset.name), pipeline});
            else
                return std::tuple();
        } else
            return std::tuple();
    };
    return std::apply([&](auto const&... preset) { return std::tuple_cat(charted(preset)...); }, named_presets);
}
struct Sharp {
    template <class P> static constexpr bool of = !blurs_samples<P> && !blurs_picture<P>;
};
struct BlursSamples {
    template <class P> static constexpr bool of = blurs_samples<P>;
};
struct BlursPicture {
    template <class P> static constexpr bool of = blurs_picture<P>;
};

/// svgf with a wavelet of another shape.
template <class Spline> constexpr auto svgf_with(Spline, ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Temporal{SurfaceMotion{}, WithMoments{RunningMean{.cap = 5.f}}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge>, Spline>{}}};
}

/// Variants of another type than the presets of any signal.
auto variants_of_any(ChannelTag auto signal, auto... parts) {
    return std::tuple(
        variant_of({"atrous", "taps", 3., 5.}, Pipeline{signal, parts..., Spatial{Atrous<Product<DepthEdge, NormalEdge>, LinearSpline>{}}}),
        Named{"general", presets::general(signal, parts...)}.in_half(), Named{"svgf", presets::svgf(signal, parts...)}.in_half(),
        variant_of({"svgf", "taps", 3., 5.}, svgf_with(LinearSpline{}, signal, parts...)));
}

/// Charts all presets of a signal on frames of one sharp sample per pixel, and more pipelines.
/// @param parts what presets of any signal get
template <class... Parts>
void chart_presets(Job const& job, ChannelTag auto signal, std::vector<tracer::Effect> const& effects, std::tuple<Parts...> parts,
                   auto const&... more) {
    tracer::RenderSettings const one_sample{.size = job.options.size, .seed = job.options.seed, .threads = job.options.threads};
    auto const methods = std::apply(
        [&](auto... part) {
            return std::tuple_cat(charted_presets(Sharp{}, signal, part...), variants_of_any(signal, part...), std::tuple(more...));
        },
        parts);
    chart_feeds(job, signal, effects, Feed{one_sample, methods});
}

} // namespace quell::bench
