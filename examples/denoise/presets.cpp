#include <denoise/presets.hpp>

#include <library/cuda/cuda_presets.hpp>
#include <quell/core/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <utility>

namespace quell::examples {

std::vector<Preset> const& presets() { return quell_library::compiled_presets(); }

Preset const* find_preset(std::string const& name) {
    auto const found = std::ranges::find(presets(), name, &Preset::name);
    return found != presets().end() ? &*found : nullptr;
}

Preset const& preset_of(std::string const& name) {
    if (auto const* const found = find_preset(name)) return *found;
    throw Error("--preset", "there is no preset '" + name + "'",
                fmt::format("choose one of: {}{}", fmt::join(presets() | std::views::transform(&Preset::name), ", "),
                            std::string_view(QUELL_PRESETS).empty() ? "" : " (those of QUELL_PRESETS)"));
}

void check_device(std::string const& device) {
    if (device == "cuda")
        static_cast<void>(quell_library::cuda_presets());
    else if (device != "cpu")
        throw Error("--device", "there is no '" + device + "'", "choose one of: cpu, cuda");
}
std::vector<Preset> const& presets_on(std::string const& device) {
    check_device(device);
    return device == "cuda" ? quell_library::cuda_presets() : presets();
}
Preset const& preset_on(std::string const& device, Preset const& preset) {
    auto const& all = presets_on(device);
    auto const found = std::ranges::find(all, preset.name, &Preset::name);
    if (found != all.end()) return *found;
    throw Error("--device", "preset " + preset.name + " is not compiled for " + device,
                fmt::format("choose one of: {} (those of QUELL_CUDA_PRESETS that make a picture)",
                            fmt::join(all | std::views::transform(&Preset::name), ", ")));
}

bool applies(Preset const& preset, io::ExrListing const& file, io::SequenceNames const& names) {
    auto const denoiser = denoiser_of(preset, {1, 1}, 1);
    if (denoiser->needs_camera() && !(file.attributes.contains("quell:view") && file.attributes.contains("quell:projection"))) return false;
    return std::ranges::all_of(names.of_signals, [&](auto const& signal) { return file.has_all(denoiser->planes(signal.channels)); });
}

PresetChoice preset_for(io::ExrListing const& file, io::SequenceNames const& names) {
    if (auto const* const blur = find_preset("blur"); blur && applies(*blur, file, names))
        return {blur, "the files have sweeps and times of samples"};
    if (auto const* const trmv = find_preset("trmv"); trmv && applies(*trmv, file, names))
        return {trmv, "the files have blockers, hits and directions, by which shadows, reflections and indirect light are followed"};
    return {&preset_of("final-frame"), "the files have colour and guides"};
}

} // namespace quell::examples
