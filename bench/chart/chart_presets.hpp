#pragma once

#include "chart_effect.hpp"

#include <baselines/named.hpp>

#include <tuple>

namespace quell::bench {

/// The pipeline of a preset for a signal, or that of all signals.
template <class Preset> constexpr auto pipeline_of(Preset const& preset, ChannelTag auto signal, auto... options) {
    if constexpr (std::is_same_v<typename Preset::signal_type, AllSignals>)
        return preset.make();
    else
        return preset.make(signal, options...);
}

/// The presets for a signal that make motion blur of `input`, as a tuple of pipelines to chart. Presets of all signals are among them where
/// the signal is `radiance`.
template <BlurInput input> auto charted_presets(ChannelTag auto signal, auto... options) {
    using Signal = decltype(signal);
    auto const charted = [&]<class Preset>(Preset const& preset) {
        constexpr bool of_all = std::is_same_v<typename Preset::signal_type, AllSignals> && std::is_same_v<Signal, Radiance>;
        if constexpr (of_all || Preset::template serves<Signal>) {
            auto const pipeline = pipeline_of(preset, signal, options...);
            if constexpr (blur_input<std::remove_const_t<decltype(pipeline)>> == input)
                return std::tuple(Charted{std::string(preset.name), pipeline});
            else
                return std::tuple();
        } else
            return std::tuple();
    };
    return std::apply([&](auto const&... preset) { return std::tuple_cat(charted(preset)...); }, all_presets);
}

/// Charts all presets of a signal on frames of one sharp sample per pixel.
/// @param options what presets of any signal get
void chart_presets(ChartRequest const& request, ChannelTag auto signal, std::vector<tracer::Effect> const& effects, auto... options) {
    tracer::RenderSettings const one_sample{.size = request.options.size, .seed = request.options.seed, .threads = request.options.threads};
    chart_feeds(request, signal, effects, Feed{one_sample, charted_presets<BlurInput::none>(signal, options...)});
}

} // namespace quell::bench
