// Runs the shaders of presets on the first Vulkan device, and compares their pictures with the CPU's.
//     shaders_on_device FOLDER...   each as `quell-shaders --language spirv --out FOLDER` has written it, named as the preset; NAME-half
//                                   with --half-precision
#include "preset_frames.hpp"

#include <library/recorded_presets.hpp>
#include <support/program.hpp>
#include <vulkan_host/plan_runner.hpp>

#include <chrono>
#include <cstdio>

namespace {

using namespace quell;

/// @throws Failure where a picture is off by more than it may
void compare(vulkan::Device const& device, std::filesystem::path const& folder) {
    auto const start = std::chrono::steady_clock::now();
    vulkan::PlanRunner on_device(device, folder);
    auto const name = folder.filename().string();
    auto const preset = name.substr(0, name.rfind("-half"));
    auto const plan = shaders::recorded_preset_named(preset, {.half_precision = preset != name});
    tests::PresetFrames frames(plan, tests::Missing::as_it_comes);
    on_device.resize(frames.size);
    while (frames.next()) {
        if (!frames.has_past) on_device.forget();
        int slot = 0;
        for (auto const& each : plan.inputs) std::ranges::copy(frames.input(slot++), on_device.input(each.channel, each.component).begin());
        on_device.run(frames.block);
        for (int c = 0; c < frames.components(); ++c) frames.compare(c, on_device.picture(c));
    }
    auto const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%s: %.1e from the CPU, %.1e where it joins no product and sum, %.1f s\n", name.c_str(), static_cast<double>(frames.off[0]),
                static_cast<double>(frames.off[1]), seconds);
    std::fflush(stdout);
    if (auto const least = std::min(frames.off[0], frames.off[1]); !(least <= frames.allowed(name)))
        raise_error<Failure>("the picture of " + name, "it differs from the CPU's by " + std::to_string(least), "see docs/shaders.md");
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("shaders_on_device", [&] {
        vulkan::Device const device;
        std::printf("%s\n", device.properties().deviceName.data());
        for (int i = 1; i < argc; ++i) compare(device, argv[i]);
    });
}
