#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// @file
/// What other people's programs make of a pass in GLSL.

namespace quell::shaders {

/// A language that shaders are written in.
struct Language {
    std::string_view name,      ///< as in --language
        extension;              ///< of the shaders' files
    bool needs_glslang = false, ///< whether glslangValidator is run
        needs_cross = false;    ///< and spirv-cross
};

/// The language of a name, which is one of language_names.
Language language_of(std::string_view name);
/// All names, for people.
inline constexpr std::string_view language_names = "wgsl, glsl, spirv, hlsl or metal";

/// Looks for the programs that a language needs.
/// @throws Failure where one is missing
void require_programs(Language const& language);

/// Compiles a file of GLSL to SPIR-V.
/// @throws Failure where the compiler fails
void compile_to_spirv(std::filesystem::path const& glsl, std::filesystem::path const& spirv);

/// Writes a pass in HLSL or Metal.
/// @param glsl the pass in GLSL
/// @param to   the file; others beside it are made for a while
/// @throws Failure where a program fails
void translate(std::string const& glsl, std::filesystem::path const& to, Language const& language);

} // namespace quell::shaders
