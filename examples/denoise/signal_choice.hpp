#pragma once

#include <denoise/presets.hpp>

namespace quell::examples {

/// One signal of the files, which is denoised by itself.
struct SignalChoice {
    std::string word;        ///< what the user calls it
    io::SequenceNames names; ///< how a file makes it up: one signal, and nothing is added
    int components = 3;      ///< that the file has of it: 1 or 3
};

/// The signal that a user names: one of a map's or of Blender's (diffuse), else a channel of quell's that the file has (visibility), else
/// a layer or a channel of the file.
/// @param names how the files' picture is made up
/// @throws Error listing the signals of the file where it has none of that name
[[nodiscard]] SignalChoice choose_signal(std::string const& word, io::ExrListing const& file, io::SequenceNames const& names);

/// Whether a preset can denoise such a signal.
[[nodiscard]] bool can_denoise(Preset const& preset, SignalChoice const& signal);

/// The names by which a preset reads the signal as what it denoises. A signal of one component is given three times to a preset that wants
/// three, and the parts of the picture that a preset multiplies its signal by are 1.
/// @throws Error where the preset denoises several signals, or fewer components
[[nodiscard]] io::SequenceNames names_for(Preset const& preset, SignalChoice const& signal);

/// The preset that suits the signal and what the file has: blur, the signal's own preset where there is what it moves by, else final-frame.
[[nodiscard]] PresetChoice preset_for(io::ExrListing const& file, SignalChoice const& signal);

/// Where the denoised signal goes: its own place, which is no layer of its own, or where it is a sum or has a factor, a layer
/// denoised_NAME.
[[nodiscard]] std::optional<std::string> layer_of_signal(io::SequenceNames const& names);

/// How a converged frame holds what a preset of effects makes: direct * visibility, glossy, albedo * indirect, or their sum. Nothing for
/// other presets.
[[nodiscard]] std::optional<io::SequenceNames> names_of_effects(Preset const& preset, io::SequenceNames const& names);

} // namespace quell::examples
