#include "translation.hpp"

#include <quell/io/replace_file.hpp>
#include <quell/shader/write_shader.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace quell::shaders {

namespace {

constexpr std::array<Language, 5> languages{
    {{"wgsl", "wgsl"}, {"glsl", "comp"}, {"spirv", "spv", true}, {"hlsl", "hlsl", true, true}, {"metal", "metal", true, true}}};

/// For a shell: a quote ends the quoted part, stands by itself, and begins another.
std::string in_shell(std::filesystem::path const& path) {
    std::string all = "'";
    for (char const letter : path.string()) all += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return all + "'";
}

void run_program(std::string const& command, std::filesystem::path const& to) {
    auto const log = to.string() + ".log";
    if (std::system((command + " > " + in_shell(log) + " 2>&1").c_str()) != 0)
        raise_error<Failure>(command, "it failed", "look into " + log);
    std::filesystem::remove(log);
}

void replace_all(std::string& text, std::string const& what, std::string const& with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) text.replace(at, what.size(), with);
}

/// Of a buffer, in parts of one slot.
constexpr int most_parts = 128;
/// GLSL from which spirv-cross writes what people can read: buffers with names, which nameless blocks lose.
std::string with_named_buffers(std::string glsl) {
    for (std::size_t i = 0; i < shader_buffer_names.size(); ++i)
        for (int part = 0; part < most_parts; ++part) {
            auto const name = BoundBuffer{static_cast<ShaderBuffer>(i), part}.name();
            replace_all(glsl, name + "[", name + ".values[");
            for (std::string const type : {"float ", "uint "})
                replace_all(glsl, type + name + ".values[]; };", type + "values[]; } " + name + ";");
        }
    return glsl;
}

} // namespace

Language language_of(std::string_view name) { return *std::ranges::find(languages, name, &Language::name); }

void require_programs(Language const& language) {
    auto const look_for = [&](bool needed, std::string const& program, std::string const& package) {
        if (needed && std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) != 0)
            raise_error<Failure>(program, "it is not found, and --language " + std::string(language.name) + " runs it",
                                 "install it (Debian: " + package + "), or take --language wgsl or glsl");
    };
    look_for(language.needs_glslang, "glslangValidator", "glslang-tools");
    look_for(language.needs_cross, "spirv-cross", "spirv-cross");
}

void compile_to_spirv(std::filesystem::path const& glsl, std::filesystem::path const& spirv) {
    run_program("glslangValidator --target-env vulkan1.1 -V -o " + in_shell(spirv) + " " + in_shell(glsl), spirv);
}

void translate(std::string const& glsl, std::filesystem::path const& to, Language const& language) {
    bool const is_metal = language.name == "metal";
    auto source = with_named_buffers(glsl);
    // Metal has no such word: each sum would become a call of a function that is not optimised.
    if (is_metal) replace_all(source, "precise ", "");
    auto const between = to.string() + ".comp", spirv = to.string() + ".spv";
    io::replace_file(between, source);
    compile_to_spirv(between, spirv);
    auto const options = is_metal ? " --msl --msl-version 20000 --msl-decoration-binding" : " --hlsl --shader-model 51";
    run_program("spirv-cross " + in_shell(spirv) + options + " --output " + in_shell(to), to);
    std::filesystem::remove(between);
    std::filesystem::remove(spirv);
    // The comment of the second line, which says what the pass is, has not come through SPIR-V.
    auto const begin = glsl.find('\n') + 1;
    auto const comment = glsl.substr(begin, glsl.find('\n', begin) + 1 - begin);
    std::ifstream stream(to, std::ios::binary);
    std::string const text(std::istreambuf_iterator<char>(stream), {});
    stream.close();
    io::replace_file(to, comment + text);
}

} // namespace quell::shaders
