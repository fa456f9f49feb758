#pragma once

#include <quell/link/colours/anti_aliased.hpp>
#include <quell/link/light_given_back.hpp>
#include <quell/link/resolve/resolve.hpp>

#include <string_view>
#include <tuple>

/// Stages by name, as one typed list. Opt-in: not in quell.hpp.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// What a stage knows of the denoiser that it stands behind.
struct StandsBehind {
    float samples = 1.f;    ///< of each pixel; where that is not known, 1
    bool is_judged = false; ///< whether samples chose, for each pixel, between the picture with history and one without
};

/// A stage behind presets, with its name.
/// @tparam Make make(StandsBehind) returns a pipeline that reads `denoised`, which is what the preset makes; in it, `radiance` are the
/// preset's samples
template <class Make> struct NamedStage {
    std::string_view name; ///< of lower-case words with hyphens
    Make make;             ///< makes the pipeline; without state
};
template <class M> NamedStage(std::string_view, M) -> NamedStage<M>;

/// All stages that stand behind presets, in the order in which they run. libquell, quell for Python, quell-denoise, shaders and CUDA go by
/// it.
inline constexpr std::tuple named_stages{
    NamedStage{"light", [](StandsBehind of) { return light_given_back(radiance, of.samples, of.is_judged); }},
    NamedStage{"colours",
               [](StandsBehind of) {
                   return Pipeline{denoised, Spatial{AntiAliased::of_samples(static_cast<int>(of.samples))}};
               }},
};
/// Stands behind all of them, and behind those of a host's own: what comes out may be of another size.
inline constexpr NamedStage named_resolve{"resolve", [](StandsBehind) { return Pipeline{denoised, Spatial{Resolve{}}}; }};

} // namespace quell::inline QUELL_INSTRUCTION_SET
