// Runs the shaders of presets on the first Vulkan device, and compares their pictures with the CPU's.
//     shaders_on_device FOLDER...   each as `quell-shaders --language spirv --out FOLDER` has written it
#include "../images.hpp"

#include <library/recorded_presets.hpp>
#include <support/program.hpp>
#include <vulkan_host/plan_runner.hpp>

#include <quell/shader/interpreter.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

namespace {

using namespace quell;

using Input = Frame<AllChannels>;
constexpr Extent size{41, 23};
constexpr unsigned frames = 4, cut = 3;

Camera camera_of(unsigned frame) {
    auto const number = static_cast<float>(frame);
    auto const aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    return {glm::lookAt(glm::vec3(0.1f * number, 1, 8), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)),
            glm::perspective(0.9f, aspect, 0.1f, 100.f), glm::vec2(0.3f * number - 0.2f, 0.1f * number)};
}
/// Some samples are missing, some parts of the image are sky.
void fill(Input& frame, unsigned number) {
    tests::fill_randomly(frame, number + 7);
    std::mt19937 random(number + 99);
    auto const spoil = [&](auto& image, auto const& value) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (random() % 40 == 0) image.set(x, y, value);
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    spoil(frame[radiance], glm::vec3(nan, 1, 1));
    spoil(frame[glossy], glm::vec3(1, -infinity, 1));
    spoil(frame[indirect], glm::vec3(1, 1, 2e16f));
    spoil(frame[visibility], infinity);
    spoil(frame[depth], infinity);
    frame.camera = camera_of(number);
}
/// Copies the frame's planes to where the plan reads them.
void upload(Input const& frame, ShaderPlan const& plan, vulkan::PlanRunner const& on_device) {
    for_each_channel(AllChannels{}, [&]<class C>(C c) {
        for (auto const& each : plan.inputs) {
            if (each.channel != C::name) continue;
            auto const plane = on_device.input(each.channel, each.component);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    plane[static_cast<std::size_t>(y * size.width + x)] = frame[c].get(each.component, x, y);
        }
    });
}
/// The largest difference, relative where the picture is above 1.
float difference(std::span<float const> wanted, std::span<float const> found) {
    float worst = 0.f;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        float const off = std::abs(wanted[i] - found[i]) / std::max(1.f, std::abs(wanted[i]));
        // NaN counts as infinite: it would give way to the next number.
        worst = std::max(worst, std::isnan(off) ? std::numeric_limits<float>::infinity() : off);
    }
    return worst;
}

ShaderPlan recorded(std::string_view name) {
    auto const all = shaders::recorded_presets();
    auto const found = std::ranges::find(all, name, &shaders::RecordedPreset::name);
    if (found == all.end()) raise_error("preset " + std::string(name), "it is not compiled in", "name the folder of another one");
    return found->record();
}

/// Runs the shaders of a preset beside what the CPU makes of the recorded steps, which has the bits of Serial. A device may round a product
/// and the sum behind it one by one (lavapipe does), by which random frames differ at few pixels where something is just or just not
/// chosen; then it has the bits of a CPU that does the same.
/// @throws Failure where a picture is off by more than five times what docs/limits.md allows Serial itself
void compare(vulkan::Device const& device, std::filesystem::path const& folder) {
    auto const start = std::chrono::steady_clock::now();
    vulkan::PlanRunner on_device(device, folder);
    auto const name = folder.filename().string();
    auto const plan = recorded(name);
    std::array interpreters{PlanInterpreter(plan, size, true), PlanInterpreter(plan, size, false)};
    std::array<float, interpreters.size()> off{};
    on_device.resize(size);
    Input frame(size);
    for (unsigned number = 0; number < frames; ++number) {
        fill(frame, number);
        bool const has_past = number > 0 && number != cut;
        if (!has_past) on_device.forget();
        upload(frame, plan, on_device);
        FrameBlock const block{.size = size,
                               .frame_index = static_cast<std::int32_t>(number),
                               .camera = frame.camera,
                               .camera_then = has_past ? camera_of(number - 1) : frame.camera,
                               .shutter = frame.shutter,
                               .shutter_then = frame.shutter,
                               .needs_camera = plan.needs_camera};
        on_device.run(block);
        for (std::size_t i = 0; i < interpreters.size(); ++i) {
            if (!has_past) interpreters[i].forget();
            for (int slot = 0; slot < plan.slot_count(ShaderBuffer::inputs); ++slot) {
                auto const& of = plan.inputs[static_cast<std::size_t>(slot)];
                std::ranges::copy(on_device.input(of.channel, of.component), interpreters[i].plane(ShaderBuffer::inputs, slot).begin());
            }
            interpreters[i].run(block);
            for (int c = 0; c < plan.slot_count(ShaderBuffer::output); ++c)
                off[i] = std::max(off[i], difference(interpreters[i].plane(ShaderBuffer::output, c), on_device.picture(c)));
        }
    }
    auto const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%s: %.1e from the CPU, %.1e where it joins no product and sum, %.1f s\n", name.c_str(), static_cast<double>(off[0]),
                static_cast<double>(off[1]), seconds);
    std::fflush(stdout);
    bool const keeps_cones = name == "dual-cone" || name == "trmv";
    if (auto const least = std::min(off[0], off[1]); !(least <= (keeps_cones ? 1e-3f : 1e-4f)))
        raise_error<Failure>("the picture of " + name, "it differs from the CPU's by " + std::to_string(least), "see docs/shaders.md");
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("shaders_on_device", [&] {
        vulkan::Device const device;
        std::printf("%s\n", device.name.c_str());
        for (int i = 1; i < argc; ++i) compare(device, argv[i]);
    });
}
