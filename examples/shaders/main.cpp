// Writes a preset as compute shaders, one per pass, and plan.json, which says how a host runs them: docs/shaders.md.
//     quell-shaders --preset general --language wgsl --out out/general
#include "translation.hpp"

#include <library/recorded_presets.hpp>
#include <quell/io/replace_file.hpp>
#include <quell/shader/write_plan.hpp>
#include <support/output_folder.hpp>
#include <support/program.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>

namespace {

using namespace quell;

struct Options {
    std::string preset, language = "wgsl", workgroup = "8x8";
    std::filesystem::path out;
    bool list = false, print = false;
    int samples_per_pixel = 1;
    RecordOptions record;
};

void write_all(ShaderPlan const& plan, Options const& options) {
    auto const language = shaders::language_of(options.language);
    shaders::require_programs(language);
    examples::make_output_folder(options.out);
    auto const written = language.name == "wgsl" ? ShaderLanguage::wgsl : ShaderLanguage::glsl;
    for (auto const& [name, text] : shader_files(plan, written, language.extension)) {
        auto const file = options.out / name;
        if (language.needs_cross) {
            shaders::translate(text, file, language);
        } else if (language.needs_glslang) {
            auto const glsl = std::filesystem::path(file).replace_extension("comp");
            io::replace_file(glsl, text);
            shaders::compile_to_spirv(glsl, file);
        } else {
            io::replace_file(file, text);
        }
    }
    io::replace_file(options.out / "plan.json", to_json(plan, language.extension));
}

Extent workgroup_in(std::string const& text) {
    Extent threads;
    char behind = 0;
    bool const two = std::sscanf(text.c_str(), "%4dx%4d%c", &threads.width, &threads.height, &behind) == 2;
    if (!two || !RecordOptions::is_workgroup(threads))
        raise_error("--workgroup", "'" + text + "'",
                    "give threads along x and y, " + std::to_string(RecordOptions::most_threads) + " or fewer together, as in 8x8");
    return threads;
}
RecordOptions checked(Options const& options) {
    auto record = options.record;
    record.workgroup = workgroup_in(options.workgroup);
    if (record.texel_loads && options.language != "glsl" && options.language != "spirv")
        raise_error("--texel-loads", "the language is " + options.language, "give --language glsl or spirv");
    return record;
}

void body(Options const& options) {
    if (options.list) {
        for (auto const& preset : shaders::recorded_presets()) std::cout << preset.name << "\n";
        return;
    }
    if (options.preset.empty()) raise_error("--preset", "none is given", "give one of --list");
    auto const plan = shaders::recorded_preset_named(options.preset, checked(options), static_cast<float>(options.samples_per_pixel));
    if (options.print)
        for (auto const& pass : plan.passes) std::cout << to_string(pass.graph);
    if (!options.out.empty())
        write_all(plan, options);
    else if (!options.print)
        raise_error("--out", "no folder is given", "give a folder for the shaders, or --print");
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("quell-shaders", [&] {
        Options options;
        CLI::App app{"Writes a preset as compute shaders, and plan.json, which says how a host runs them."};
        app.add_option("--preset", options.preset, "the preset, or a stage behind presets: one of --list");
        app.add_option("--samples-per-pixel", options.samples_per_pixel, "for a stage (default: 1, or not known)")
            ->check(CLI::Range(1, 1 << 24));
        app.add_option("--language", options.language,
                       std::string(shaders::language_names) + "; glslangValidator makes spirv, and spirv-cross of it hlsl and metal")
            ->check(CLI::IsMember({"wgsl", "glsl", "spirv", "hlsl", "metal"}));
        app.add_option("--out", options.out, "folder for the shaders and plan.json");
        app.add_flag("--repair-guides", options.record.repair_guides, "repairs guides that no scene has, by a pass at the front");
        app.add_option("--fill-holes", options.record.fill_holes,
                       "so many passes give missing samples what stands 2, 4, 8, ... pixels away")
            ->check(CLI::Range(0, RecordOptions::most_fill_holes));
        app.add_flag("--counts", options.record.counts, "counts missing samples, impossible guides and suppressed light");
        app.add_flag("--half-precision", options.record.half_precision,
                     "keeps history and scratch as 16-bit floats where the CPU would: two of a pixel to a word");
        app.add_option("--buffer-slots", options.record.most_slots, "slots of a buffer at most: what has more lies in several")
            ->check(CLI::Range(1, 1000));
        app.add_flag("--texel-loads", options.record.texel_loads,
                     "loads of views of the buffers: for glsl and spirv on a device that is a CPU");
        app.add_option("--workgroup", options.workgroup, "threads of a workgroup along each axis")->capture_default_str();
        app.add_flag("--print", options.print, "prints the recorded steps of each pass, for people");
        app.add_flag("--list", options.list, "prints the presets and stages that can be recorded, one a line");
        if (examples::parse(app, argc, argv)) body(options);
    });
}
