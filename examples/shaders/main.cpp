// Writes a preset as compute shaders, one per pass, and plan.json, which says how a host runs them: docs/shaders.md.
//     quell-shaders --preset general --language wgsl --out out/general
#include "recorded_presets.hpp"

#include <quell/core/error.hpp>
#include <quell/shader/write_plan.hpp>
#include <support/output_folder.hpp>
#include <support/program.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using namespace quell;

struct Options {
    std::string preset, language = "wgsl", glslang = "glslangValidator";
    std::filesystem::path out;
    bool list = false, print = false;
};

ShaderPlan recorded(std::string const& name) {
    auto const all = shaders::recorded_presets();
    auto const found = std::ranges::find(all, name, &shaders::RecordedPreset::name);
    if (found != all.end()) return found->record();
    if (name.starts_with("blur"))
        raise_error("--preset " + name, "presets of motion blur look at lanes, so that they cannot be recorded", "take one of --list");
    raise_error("--preset " + name, "there is no such preset, or it is not compiled in", "take one of --list");
}

void write(std::filesystem::path const& file, std::string const& text) {
    std::ofstream stream(file, std::ios::binary);
    if (!(stream << text).flush()) raise_error<Failure>(file.string(), "it can't be written", "check the folder and the space in it");
}

void compile(std::filesystem::path const& source, std::filesystem::path const& to, std::string const& glslang) {
    // For a shell: a quote ends the quoted part, stands by itself, and begins another.
    auto const quoted = [](std::filesystem::path const& path) {
        std::string all = "'";
        for (char const letter : path.string()) all += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
        return all + "'";
    };
    auto const command =
        glslang + " --target-env vulkan1.1 -V -o " + quoted(to) + " " + quoted(source) + " > " + quoted(to.string() + ".log");
    if (std::system(command.c_str()) != 0) raise_error<Failure>(command, "it failed", "install glslang-tools, or take --language glsl");
    std::filesystem::remove(to.string() + ".log");
}

void write_all(ShaderPlan const& plan, Options const& options) {
    bool const is_wgsl = options.language == "wgsl", is_spirv = options.language == "spirv";
    auto const language = is_wgsl ? ShaderLanguage::wgsl : ShaderLanguage::glsl;
    std::string const extension = is_wgsl ? "wgsl" : "comp";
    examples::make_output_folder(options.out);
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        for (bool const is_first : {false, true}) {
            if (is_first && !plan.passes[pass].first) continue;
            auto const file = options.out / shader_file_name(plan, pass, is_first, extension);
            write(file, shader_text(plan, pass, is_first, language));
            if (is_spirv) compile(file, options.out / shader_file_name(plan, pass, is_first, "spv"), options.glslang);
        }
    write(options.out / "plan.json", to_json(plan, is_spirv ? "spv" : extension));
}

void body(Options const& options) {
    if (options.list) {
        for (auto const& preset : shaders::recorded_presets()) std::cout << preset.name << "\n";
        return;
    }
    if (options.preset.empty()) raise_error("--preset", "none is given", "give one of --list");
    auto const plan = recorded(options.preset);
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
        app.add_option("--preset", options.preset, "the preset: one of --list");
        app.add_option("--language", options.language, "wgsl, glsl, or spirv, for which glslangValidator is run")
            ->check(CLI::IsMember({"wgsl", "glsl", "spirv"}));
        app.add_option("--out", options.out, "folder for the shaders and plan.json");
        app.add_flag("--print", options.print, "prints the recorded steps of each pass, for people");
        app.add_flag("--list", options.list, "prints the presets that can be recorded, one a line");
        if (examples::parse(app, argc, argv)) body(options);
    });
}
