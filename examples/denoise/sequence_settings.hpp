#pragma once

#include <denoise/anti_alias.hpp>
#include <denoise/denoiser.hpp>
#include <denoise/upsampler.hpp>

#include <quell/io/sequence_names.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// How a sequence is denoised.
struct SequenceSettings {
    Preset preset;
    int threads = 0;                        ///< 0: all that there are
    std::optional<io::SequenceNames> map{}; ///< how the files name their channels; without one, that is recognised from the first file
    std::optional<float> shutter{};         ///< how long it is open, whatever the files or the map say
    std::optional<float> field_of_view{};   ///< vertical, degrees: of files whose depth is the length of rays, where they have no camera
    int later_frames = 0;              ///< that each frame is denoised with, where the preset makes use of them and the files are there
    bool keeps_alpha = false;          ///< leave alpha as the files have it
    std::vector<std::string> stages{}; ///< names that is_stage() knows
    bool accounts = false;             ///< gather what each stage changed: see StageAccount
    bool diagnose = false;             ///< look at each frame for what its renderer got wrong
    std::optional<Upsampling> upsampling{}; ///< of the picture and its alpha, which are then all that a frame has; empty: none
    std::vector<std::string> debug_views{}; ///< names of DebugChannels that debug_images() will be asked for: slower, and on one thread

    /// Whether stages are done, and later frames read: debug images show what happens without.
    [[nodiscard]] bool takes_more() const { return debug_views.empty(); }
    /// Whether colours are put together from frames around.
    [[nodiscard]] bool is_anti_aliased() const { return has("colours"); }
    /// Whether light that filters took out is given back, noise of guides taken off, and fog seen through.
    [[nodiscard]] bool is_refined() const { return has("light"); }
    /// Whether samples choose, for each signal, between its history and the frame by itself.
    [[nodiscard]] bool is_judged() const { return has("evidence"); }
    [[nodiscard]] bool has(std::string_view stage) const { return takes_more() && std::ranges::find(stages, stage) != stages.end(); }
    /// How far frames are read ahead: those after a frame that its light is denoised with, and those that its colours are put together
    /// from.
    [[nodiscard]] int frames_ahead() const {
        if (!takes_more()) return 0;
        return is_anti_aliased() && later_frames > 0 ? std::max(later_frames, AntiAliased::most_frames) : later_frames;
    }
};

} // namespace quell::examples
