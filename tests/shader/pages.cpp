// Writes a page that runs shaders of presets by WebGPU, with what they are given and what the CPU makes of it: pages FOLDER. With
// QUELL_SHADERS_OF naming presets, those.
#include "preset_frames.hpp"

#include <library/recorded_presets.hpp>
#include <quell/shader/write_plan.hpp>
#include <support/program.hpp>

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

using namespace quell;

/// 32-bit words, which a script reads as fast as numbers and without rounding.
std::string words_of(auto const& all) {
    std::string text = "[";
    for (auto const each : all) (text += std::to_string(std::bit_cast<std::uint32_t>(each))) += ',';
    return text + "]";
}
std::string planes(int count, auto const& plane) {
    std::string text = "[";
    for (int i = 0; i < count; ++i) text += words_of(plane(i)) + ",";
    return text + "]";
}

/// All that can be added to passes, and buffers of few slots.
constexpr RecordOptions everything{.repair_guides = true, .fill_holes = 2, .counts = true, .most_slots = 5};

/// The preset of a case: NAME, +NAME with everything that can be added, NAME-half in half precision.
std::string without_sign(std::string const& name) { return name.substr(name.starts_with('+')); }
std::string preset_of(std::string const& name) { return without_sign(name).substr(0, without_sign(name).rfind("-half")); }
void write_case(std::string const& name, std::ostream& to) {
    auto const plan = shaders::recorded_preset_named(
        preset_of(name), name[0] == '+' ? everything : RecordOptions{.half_precision = name.ends_with("-half")});
    to << "cases.push({name: '" << without_sign(name) << "', plan: " << to_json(plan, "wgsl") << ", texts: {\n";
    for (auto const& [file, text] : shader_files(plan, ShaderLanguage::wgsl, "wgsl")) to << "'" << file << "': `" << text << "`,\n";
    tests::PresetFrames frames(plan, tests::Missing::marked);
    to << "}, allowed: " << frames.allowed(without_sign(name)) << ", width: " << frames.size.width << ", height: " << frames.size.height
       << ", frames: [\n";
    while (frames.next()) {
        auto const wanted = [&](std::size_t way) { return planes(frames.components(), [&](int c) { return frames.wanted(way, c); }); };
        to << "{has_past: " << frames.has_past << ", block: " << words_of(frames.block.as_words())
           << ", inputs: " << planes(plan.slot_count(ShaderBuffer::inputs), [&](int slot) { return frames.input(slot); }) << ", wanted: ["
           << wanted(0) << ", " << wanted(1) << "], totals: [";
        for (auto const total : frames.totals()) to << total << ",";
        to << "]},\n";
    }
    to << "]});\n";
}

/// Those that are compiled in, of a few quick ones or of those that are named.
std::vector<std::string> chosen() {
    auto const* const named = std::getenv("QUELL_SHADERS_OF");
    std::istringstream list(named && *named ? named : "surface-clamp;+general;shadow");
    std::vector<std::string> names;
    auto const all = shaders::recorded_presets();
    for (std::string name; std::getline(list, name, ';');)
        if (std::ranges::count(all, preset_of(name), &shaders::RecordedPreset::name) > 0) names.push_back(name);
    return names;
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of(
        "shader_pages", [&] {
            if (argc != 2) raise_error("arguments", std::to_string(argc - 1), "give a folder");
            std::filesystem::path const folder = argv[1];
            std::ofstream(folder / "index.html")
                << "<!DOCTYPE html><title>shaders</title><script src='gpu.js'></script><script src='cases.js'></script>\n";
            std::filesystem::copy_file(QUELL_GPU_SCRIPT, folder / "gpu.js", std::filesystem::copy_options::overwrite_existing);
            std::ofstream cases(folder / "cases.js");
            cases << "const cases = [];\n";
            for (auto const& name : chosen()) write_case(name, cases);
        });
}
