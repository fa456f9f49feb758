#pragma once

#include <baselines/presets.hpp>
#include <quell/presets/named.hpp>

/// All presets by name, as one typed list: what programs, tests, fuzzers and charts go through.
namespace quell::inline QUELL_INSTRUCTION_SET {

namespace presets::named {
inline constexpr std::tuple published{
    NamedPreset{"asvgf", PresetGroup::published, any_signal, [](auto... a) { return asvgf(a...); }},
    NamedPreset{"dual-color", PresetGroup::published, any_signal, [](auto... a) { return dual_color(a...); }},
    NamedPreset{"mirror-clamp", PresetGroup::published, Glossy{}, [](auto... a) { return mirror_clamp(a...); }},
    NamedPreset{"shadow-paper", PresetGroup::published, Visibility{}, [](auto... a) { return shadow_paper(a...); }},
    NamedPreset{"glossy-paper", PresetGroup::published, Glossy{}, [](auto... a) { return glossy_paper(a...); }},
    NamedPreset{"dual-cone-paper", PresetGroup::published, Indirect{}, [](auto... a) { return dual_cone_paper(a...); }},
    NamedPreset{"trmv-paper", PresetGroup::published, all_signals, [](auto... options) { return trmv_paper(options...); }},
    NamedPreset{"blur-wavelet", PresetGroup::published, Radiance{}, [](auto signal, auto...) { return blur_wavelet(signal); }},
    NamedPreset{"blur-fixed-step", PresetGroup::published, Radiance{}, [](auto signal, auto...) { return blur_fixed_step(signal); }},
    NamedPreset{"blur-one-step", PresetGroup::published, Radiance{}, [](auto signal, auto...) { return blur_one_step(signal); }},
    NamedPreset{"blur-paper", PresetGroup::published, Radiance{}, [](auto signal, auto...) { return blur_paper(signal); }},
    NamedPreset{"blur-no-pre-filter", PresetGroup::published, Radiance{}, [](auto signal, auto...) { return blur_no_pre_filter(signal); }},
    NamedPreset{"gather-blur", PresetGroup::published, Radiance{}, [](auto... a) { return gather_blur(a...); }},
    NamedPreset{"tilemax-blur", PresetGroup::published, Radiance{}, [](auto... a) { return tilemax_blur(a...); }},
};
} // namespace presets::named

/// named_presets, and the published ones behind them.
inline constexpr auto all_presets = std::tuple_cat(named_presets, presets::named::published);

} // namespace quell::inline QUELL_INSTRUCTION_SET
