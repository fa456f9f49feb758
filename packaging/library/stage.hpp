#pragma once

#include "compiled_preset.hpp"

namespace quell_library {

/// What a stage is put around, and where.
struct StagePlace {
    Way const& way;                           ///< of the preset
    Way const& judge;                         ///< of the same purpose, of the preset that judges its history; may be the same one
    std::vector<ReadChannel> const& channels; ///< that frames have
    quell::Extent size{}, output{};           ///< of the frames, and of what comes out
    float samples = 1.f;                      ///< of each pixel
    bool is_judged = false;                   ///< whether samples choose between the preset's history and the frame by itself
    Parallel const& parallel;
    Memory const& memory;
};

/// Something that is done before a compiled preset, with it or behind it, by its name. It is compiled by itself, once for all presets.
struct Stage {
    std::string name{};
    /// What keeps it from a preset, as the end of a sentence that begins with the preset's name; empty where it can be put around it.
    std::function<std::string(Way const&)> refusal{};
    bool takes_one_frame = false; ///< not with the frames after each
    bool needs_jitter = false;    ///< the camera's must be known, and in a range
    /// The plan of all that there is with it.
    /// @param inner the plan of what it is put around
    std::function<std::string(std::string const& inner, Way const& way, Way const& judge)> plan{};
    /// @throws quell::Error, std::bad_alloc
    std::function<std::unique_ptr<CompiledDenoiser>(std::unique_ptr<CompiledDenoiser>, StagePlace const&)> put{};
};

/// All of them, in the order in which they are put around a preset: each around those before it.
[[nodiscard]] std::vector<Stage> const& stages();

/// Those of quell::named_stages and QUELL_OWN_STAGES, which stand behind a preset. Behind them is `resolve`, which here takes frames of
/// several sizes, alpha and single components: see resolved_denoiser.hpp.
[[nodiscard]] std::vector<Stage> link_stages();

} // namespace quell_library
