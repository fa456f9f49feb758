#pragma once

#include <denoise/denoiser.hpp>

#include <quell/io/sequence_names.hpp>

namespace quell::examples {

/// All presets that are compiled, in the order of quell::all_presets.
[[nodiscard]] std::vector<Preset> const& presets();
/// Null where there is no such preset, or it is not compiled.
[[nodiscard]] Preset const* find_preset(std::string const& name);
/// @throws Error, listing the names, where there is no such preset
[[nodiscard]] Preset const& preset_of(std::string const& name);

/// @throws Error where there is no such device, or the program was not built for it
void check_device(std::string const& device);
/// The presets that a device runs, in the same order.
/// @param device cpu or cuda
/// @throws Error as check_device() does
[[nodiscard]] std::vector<Preset> const& presets_on(std::string const& device);
/// A preset on a device.
/// @throws Error where it is not compiled for it
[[nodiscard]] Preset const& preset_on(std::string const& device, Preset const& preset);

/// Whether a file has all the planes that a preset wants for these signals, and a camera where it needs one.
[[nodiscard]] bool applies(Preset const& preset, io::ExrListing const& file, io::SequenceNames const& names);

/// The preset that suits what a file has, and why: a part of a sentence.
struct PresetChoice {
    Preset const* preset = nullptr;
    std::string reason = {};
};
/// blur where there are sweeps and times, trmv where there is all by which shadows, reflections and indirect light are followed, else
/// final-frame.
[[nodiscard]] PresetChoice preset_for(io::ExrListing const& file, io::SequenceNames const& names);

} // namespace quell::examples
