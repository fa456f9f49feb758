#pragma once

#include <denoise/presets.hpp>
#include <denoise/two_sided_denoiser.hpp>
#include <support/name_list.hpp>

#include <quell/pipeline/warm_up.hpp>
#include <quell/presets/named.hpp>

namespace quell::examples {

/// Whether a preset denoises one part of the picture.
template <class Signal> inline constexpr bool is_effect = ChannelTag<Signal> && !std::is_same_v<Signal, Radiance>;
/// Debug images are of one pipeline with a history, of colours and not of cones.
template <class P> inline constexpr bool has_debug_images = false;
template <ChannelTag S, class... Parts>
inline constexpr bool has_debug_images<Pipeline<S, Parts...>> = Pipeline<S, Parts...>::has_past && !(std::is_same_v<Parts, Cones> || ...);

/// Makes the pipeline. An effect's is a composite, so that its part of the picture comes out.
template <class Named> struct MakePipeline {
    constexpr auto operator()(auto... parts) const {
        if constexpr (is_effect<typename Named::signal_type>)
            return Composite{Named::usual(parts...)};
        else
            return Named::usual(parts...);
    }
};
template <class Named> struct MakeJoining {
    constexpr auto operator()(auto... parts) const { return Named::usual_joining(parts...); }
};
/// The same for a picture with alpha.
template <class Function> struct MakeForAlpha {
    constexpr auto operator()(auto... parts) const { return Function{}(radiance_alpha, Demodulate{}, parts...); }
};

/// What a pipeline denoises, or the pipelines of a composite.
template <ChannelTag S, class... Parts> std::vector<SignalOfPreset> signals_of(Pipeline<S, Parts...> const&) {
    return {{std::string(S::name), S::components}};
}
template <class... Ps> std::vector<SignalOfPreset> signals_of(Composite<Ps...> const&) {
    return {{std::string(Ps::Output::name), Ps::Output::components}...};
}

template <class Named> Preset made_preset(Named const& named) {
    using P = decltype(Named::usual());
    std::string name(named.name);
    auto made = [&] {
        if constexpr (Named::is_two_sided)
            return two_sided_preset(std::move(name), MakePipeline<Named>{}, MakeJoining<Named>{}, MakeForAlpha<decltype(Named::make)>{},
                                    MakeForAlpha<decltype(Named::join)>{});
        else if constexpr (has_debug_images<P>)
            return watched_preset(std::move(name), MakePipeline<Named>{});
        else
            return preset(std::move(name), MakePipeline<Named>{});
    }();
    made.group = named.group;
    constexpr auto pipeline = Named::usual();
    made.of_signals = signals_of(pipeline);
    made.warm_up = warm_up_frames(pipeline); // joining both sides begins anew in each frame
    made.is_part = is_effect<typename Named::signal_type>;
    made.by_albedo = std::is_same_v<typename Named::signal_type, AnySignal> && P::reads::template has<Albedo>;
    made.wants_sharp_picture = blur_input<P> == BlurInput::picture;
    return made;
}

constexpr bool is_preset(std::string_view name) {
    bool found = false;
    for_each_preset([&](auto const& named) { found = found || named.name == name; });
    return found;
}
static_assert(!any_name(QUELL_DENOISE_PRESETS, [](auto name) { return !is_preset(name); }),
              "QUELL_DENOISE_PRESETS names a preset that there is not: docs/presets.md lists them");

template <std::size_t unit, std::size_t units> std::vector<Preset> presets_of_unit() {
    std::vector<Preset> made;
    for_each_preset_index<unit, units>([&](auto i) {
        constexpr auto const& named = std::get<i>(named_presets);
        if constexpr (is_chosen(QUELL_DENOISE_PRESETS, named.name))
            made.push_back(made_preset(named));
        else
            made.emplace_back();
    });
    return made;
}

} // namespace quell::examples
