#pragma once

#include <quell/presets/blur.hpp>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>
#include <quell/presets/preset_group.hpp>

#include <cstddef>
#include <tuple>
#include <utility>

/// Presets by name, as one typed list.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// The signal of a preset that denoises any.
struct AnySignal {};
/// The signal of a preset that denoises all signals of a picture and puts them together.
struct AllSignals {};

/// A preset with its name.
/// @tparam Signal what it denoises: a channel, AnySignal or AllSignals
/// @tparam Make   make(signal, options...) returns the pipeline; of AllSignals make(options...) returns the Composite. Presets of motion
/// blur drop
///                options.
/// @tparam Join   the same for the second argument of TwoSided{}; nullptr where the preset makes no use of later frames
template <class Signal, class Make, class Join = std::nullptr_t> struct NamedPreset {
    using signal_type = Signal; ///< what it denoises
    std::string_view name;      ///< of lower-case words with hyphens; the function has underscores
    PresetGroup group;          ///< where it stands
    Signal signal;              ///< what it denoises
    Make make;                  ///< makes the pipeline
    Join join = nullptr;        ///< makes the one that joins both sides
    std::string_view judge{};   ///< with evidence: the preset that judges its history, in less time; empty: it does so itself
    std::string_view stages{};  ///< that quell-denoise does behind it where nothing else is said, with commas between

    /// Whether it denoises this channel, by itself.
    template <ChannelTag S> static constexpr bool serves = std::is_same_v<Signal, AnySignal> || std::is_same_v<Signal, S>;
    /// Whether the frames before and after can be joined by a TwoSided.
    static constexpr bool is_two_sided = !std::is_null_pointer_v<Join>;

    /// The pipeline for its own signal. Where that is any, it is for `radiance`, filtered without its albedo.
    static constexpr auto usual(auto... options) { return of_usual_signal(Make{}, options...); }
    /// The second argument of TwoSided{} for usual().
    static constexpr auto usual_joining(auto... options) { return of_usual_signal(Join{}, options...); }

private:
    static constexpr auto of_usual_signal(auto function, auto... options) {
        if constexpr (std::is_same_v<Signal, AllSignals>)
            return function(options...);
        else if constexpr (std::is_same_v<Signal, AnySignal>)
            return function(radiance, Demodulate{}, options...);
        else
            return function(Signal{}, options...);
    }
};
template <class S, class M> NamedPreset(std::string_view, PresetGroup, S, M) -> NamedPreset<S, M>;
template <class S, class M, class J> NamedPreset(std::string_view, PresetGroup, S, M, J) -> NamedPreset<S, M, J>;
template <class S, class M, class J>
NamedPreset(std::string_view, PresetGroup, S, M, J, std::string_view, std::string_view) -> NamedPreset<S, M, J>;

// In namespace presets a preset hides the channel of its name, so channels go by their types.
namespace presets::named {
inline constexpr AnySignal any_signal;
inline constexpr AllSignals all_signals;
inline constexpr std::tuple list{
    NamedPreset{"none", PresetGroup::general, any_signal, [](auto signal, auto...) { return none(signal); }},
    NamedPreset{"surface", PresetGroup::general, any_signal, [](auto... a) { return surface(a...); }},
    NamedPreset{"surface-clamp", PresetGroup::general, any_signal, [](auto... a) { return surface_clamp(a...); }},
    NamedPreset{"atrous", PresetGroup::general, any_signal, [](auto... a) { return atrous(a...); }},
    NamedPreset{"svgf", PresetGroup::general, any_signal, [](auto... a) { return svgf(a...); }},
    NamedPreset{"general", PresetGroup::general, any_signal, [](auto... a) { return general(a...); },
                [](auto... a) { return general_joining(a...); }, "", "light,colours"},
    NamedPreset{"final-frame", PresetGroup::general, any_signal, [](auto... a) { return final_frame(a...); },
                [](auto... a) { return final_frame_joining(a...); }, "general", "evidence,light,colours"},
    NamedPreset{"accumulated", PresetGroup::general, any_signal, [](auto... a) { return accumulated(a...); }},

    NamedPreset{"shadow", PresetGroup::effects, Visibility{}, [](auto... a) { return shadow(a...); }},
    NamedPreset{"glossy", PresetGroup::effects, Glossy{}, [](auto... a) { return glossy(a...); }},
    NamedPreset{"dual-cone", PresetGroup::effects, Indirect{}, [](auto... a) { return dual_cone(a...); }},
    NamedPreset{"trmv", PresetGroup::effects, all_signals, [](auto... options) { return trmv(options...); }},

    NamedPreset{"blur", PresetGroup::blur, Radiance{}, [](auto signal, auto...) { return blur(signal); }},
    NamedPreset{"blur-straight", PresetGroup::blur, Radiance{}, [](auto signal, auto...) { return blur<StraightTrajectories>(signal); }},
    NamedPreset{"blur-bent", PresetGroup::blur, Radiance{}, [](auto signal, auto...) { return blur<BentTrajectories>(signal); }},
    NamedPreset{"blur-split", PresetGroup::blur, all_signals, [](auto...) { return blur_split(); }},
};
} // namespace presets::named

/// All presets, group by group.
inline constexpr auto& named_presets = presets::named::list;

/// Calls function(i) with the index of each preset of a list such as named_presets, in order, as a constant (std::integral_constant).
template <class... Presets> constexpr void for_each_preset_index(std::tuple<Presets...> const&, auto const& function) {
    [&]<std::size_t... i>(std::index_sequence<i...>) { (function(std::integral_constant<std::size_t, i>{}), ...); }
    (std::index_sequence_for<Presets...>{});
}

/// Calls function(preset) for each preset of a list, in order.
template <class... Presets> constexpr void for_each_preset(std::tuple<Presets...> const& list, auto const& function) {
    std::apply([&](auto const&... preset) { (function(preset), ...); }, list);
}

/// What motion blur is made of: samples at random times of the open shutter, a picture of one instant; or none is made.
enum class BlurInput { none, samples, picture };
/// What a pipeline makes motion blur of, by the channels that it reads.
template <class P>
inline constexpr BlurInput blur_input = P::reads::template has<Time>    ? BlurInput::samples
                                        : P::reads::template has<Sweep> ? BlurInput::picture
                                                                        : BlurInput::none;

} // namespace quell::inline QUELL_INSTRUCTION_SET
