#pragma once

#include <denoise/guide_images.hpp>
#include <denoise/linear_picture.hpp>
#include <library/history_choice.hpp>
#include <library/own_threads.hpp>

#include <quell/diagnose/cheap_diagnosis.hpp>
#include <quell/diagnose/finding.hpp>

#include <chrono>
#include <deque>
#include <functional>

namespace quell::examples {

/// A preset with all that is compiled of it.
using Preset = quell_library::CompiledPreset;

/// What a preset is used for.
enum class Purpose {
    picture,    ///< the picture, or an effect's part of it; with later frames where the preset makes use of them
    with_alpha, ///< a picture with alpha
    watched,    ///< debug images
};
/// The code of a preset for a purpose; none where there is none.
[[nodiscard]] quell_library::Way const& way_of(Preset const& preset, Purpose purpose = Purpose::picture);
/// Whether what comes out is one effect's part of the picture.
[[nodiscard]] inline bool is_part(Preset const& preset) { return static_cast<bool>(preset.picture); }
/// Whether a preset makes use of frames that come later.
[[nodiscard]] inline bool looks_ahead(Preset const& preset) { return static_cast<bool>(preset.two_sided); }
/// How many later frames a preset that looks ahead gets.
inline constexpr int usual_later_frames = 2;

/// The stages that are done besides a preset, by name: evidence, light and colours, and of those that stand behind presets the host's own.
[[nodiscard]] bool is_stage(std::string_view name);
[[nodiscard]] std::string stage_names();
/// Whether a stage is one of the host's own (QUELL_OWN_STAGES).
[[nodiscard]] bool is_own_stage(std::string_view name);

/// Denoises one signal of a sequence of files.
class Denoiser {
public:
    /// @param way one that there is
    /// @param threads 0: all that there are
    /// @param output  of what comes out, anti-aliased over time behind the preset; none: the frames' size, without
    /// @throws Error for a size without pixels
    Denoiser(quell_library::Way const& way, Extent size, int threads, std::optional<Extent> output = {});

    /// The planes that it wants of each file.
    [[nodiscard]] std::vector<std::string> planes(io::ChannelNames const& names) const { return planes(names, false); }
    /// Planes that it makes use of where a file has them.
    [[nodiscard]] std::vector<std::string> optional_planes(io::ChannelNames const& names) const { return planes(names, true); }
    /// Whether each file must say where its camera is.
    [[nodiscard]] bool needs_camera() const { return way.needs_camera; }
    /// Shows it a frame that comes after those that it has seen, and will be denoised later.
    /// @param guides of the frame, for all denoisers
    void look_ahead(io::ExrImage const& image, io::ChannelNames const& names, long long number, GuideImages& guides);
    /// Drops the frames that it was shown and has not denoised.
    void drop_ahead() { window.clear(); }
    /// From now on these of the stages that stand behind a preset are behind it.
    /// @param names of stages, of which others are left to whoever calls
    /// @throws Error where the preset can't have one
    void put_behind(std::vector<std::string> const& names);
    /// From now on each frame is looked at for what its renderer got wrong.
    /// @param by what the denoised signal is multiplied by at the end, where that is the albedo it was divided by; one source per component
    void diagnose(std::vector<io::Source> by = {}) { looks = true, factor = std::move(by); }
    /// Looks at the first frames for the mistakes that are told at little cost.
    void check_first_frames() { to_check = first_frames; }
    /// What was found in the last frame.
    [[nodiscard]] std::vector<Finding> const& findings() const { return found; }
    /// Whether it makes a channel of DebugChannels, by its name.
    [[nodiscard]] bool has_debug_view(std::string const& view) const { return code->has_debug_view(view); }
    /// What a channel of DebugChannels shows of the last frame, by its name: none where it makes none.
    [[nodiscard]] std::vector<DebugImage> debug_images(std::string const& view) { return code->debug_images(view); }
    /// The next frame, denoised. Where its size is another one, history starts afresh.
    /// @param choice of what denoisers of this way make with their history and without, which may serve several; null: with history
    [[nodiscard]] LinearPicture denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number,
                                        quell_library::HistoryChoice* choice = nullptr);
    /// What the frame alone makes of the last one, where the choice had two estimates of it; without alpha.
    [[nodiscard]] std::optional<LinearPicture> alone(quell_library::HistoryChoice& choice) const;
    /// What the last one is with its whole history, in the same way.
    [[nodiscard]] std::optional<LinearPicture> with_history(quell_library::HistoryChoice& choice) const;
    /// What puts together what denoisers of this way make of frames of this size.
    /// @param judge the way of the preset's judge, see judge_of()
    [[nodiscard]] std::unique_ptr<quell_library::HistoryChoice> make_choice(quell_library::Way const& judge);
    /// A channel of the frame that it has denoised last, as it was read; without data where it was not.
    [[nodiscard]] quell_library::Image seen(std::string_view channel) const;
    /// The light of that frame.
    [[nodiscard]] quell_library::Image seen_light() const { return seen(seen(radiance.name).data ? radiance.name : radiance_alpha.name); }
    /// Names of the guides that it accumulates with the light.
    [[nodiscard]] std::vector<std::string> guides() const;
    /// One of them, of the frame that it has denoised last.
    [[nodiscard]] LinearPicture guide(std::string const& name);
    /// Forgets all frames so far.
    void forget() { code->forget(); }
    /// What it remembers; nothing where that is nothing, or not of one signal.
    [[nodiscard]] std::optional<HistoryContents> remembered() const { return code->remembered(); }
    /// Makes it remember what another one of the same preset did, of a picture with or without alpha.
    void remember(HistoryContents const& contents) { code->remember(contents); }
    /// Gives back all memory but what it remembers.
    void release_scratch();
    /// Alpha of the last frame, where the signal has it.
    [[nodiscard]] std::vector<float> const& alpha() const { return denoised_alpha; }
    /// Counts of the last frame: missing samples, impossible guides.
    [[nodiscard]] Statistics statistics() const { return code->statistics(); }
    /// Memory of history and scratch. Complete once a frame was denoised.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(code->bytes()) / static_cast<double>(size.pixels()); }
    /// How long denoising has taken so far, without reading files and loading frames from them.
    [[nodiscard]] double milliseconds() const { return taken; }

private:
    quell_library::Way const way;
    Extent size; ///< of the last frame
    std::optional<Extent> output;
    quell_library::OwnThreads threads;
    std::unique_ptr<quell_library::CompiledDenoiser> code; ///< with what stands behind it
    quell_library::HistoryChoice* chosen_by = nullptr;     ///< of the frame that is denoised
    /// A frame that it was shown.
    struct Shown {
        quell_library::FrameImages images{};
        std::vector<LoadedChannelPointer> channels{}; ///< where these lie
    };
    std::deque<Shown> window;                       ///< frames that it has not denoised
    Shown last;                                     ///< the frame that it has
    std::vector<quell_library::FrameImages> images; ///< the window's
    double taken = 0;                               ///< milliseconds
    bool looks = false;                             ///< whether frames are looked at
    static constexpr int first_frames = 10;
    int to_check = 0; ///< frames that are still to be looked at at little cost
    CheapDiagnosis check;
    std::vector<io::Source> factor; ///< what diagnose() was told
    std::vector<Finding> found;
    std::vector<float> denoised_alpha;

    [[nodiscard]] quell_library::Parallel parallel() {
        return {.run = quell_library::OwnThreads::run, .user = &threads, .threads = threads.count()};
    }
    [[nodiscard]] LinearPicture run_images(quell_library::HistoryChoice* choice);
    [[nodiscard]] std::optional<LinearPicture> estimate(std::function<bool(quell_library::Image const&)> const& copy) const;
    [[nodiscard]] std::vector<std::string> planes(io::ChannelNames const& names, bool optional) const;
    [[nodiscard]] std::vector<Finding> findings_in(quell_library::FrameImages const& frame, io::ExrImage const& image,
                                                   MotionConvention const& converted_from);
    [[nodiscard]] std::vector<Finding> checked(quell_library::FrameImages const& frame, MotionConvention const& converted_from);
    /// Component c at (x, y) of the factor, as quell::diagnose() wants it; nothing where there is none.
    [[nodiscard]] std::function<float(int c, int x, int y)> factor_in(io::ExrImage const& image) const;
};

/// What denoises the picture, or an effect's part of it.
[[nodiscard]] inline std::unique_ptr<Denoiser> denoiser_of(Preset const& preset, Extent size, int threads) {
    return std::make_unique<Denoiser>(way_of(preset), size, threads);
}

} // namespace quell::examples
