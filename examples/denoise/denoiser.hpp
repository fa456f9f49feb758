#pragma once

#include <quell/diagnose/cheap_diagnosis.hpp>
#include <quell/diagnose/debug_channels.hpp>
#include <quell/diagnose/finding.hpp>
#include <quell/io/channel_names.hpp>
#include <quell/io/exr_image.hpp>
#include <quell/metrics/picture.hpp>
#include <quell/pipeline/history_contents.hpp>
#include <quell/presets/preset_group.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quell::examples {

/// Adds the time for which it lives to a sum of milliseconds.
class Timer {
    using Clock = std::chrono::steady_clock;
    double& sum;
    Clock::time_point begin = Clock::now();

public:
    explicit Timer(double& milliseconds) : sum(milliseconds) {}
    Timer(Timer const&) = delete;
    Timer& operator=(Timer const&) = delete;
    ~Timer() { sum += std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }
};

/// A pipeline of any type together with its frame and its history: what one signal of a sequence is denoised by.
class Denoiser {
public:
    virtual ~Denoiser() = default;

    /// The planes that it wants of each file.
    [[nodiscard]] virtual std::vector<std::string> planes(io::ChannelNames const& names) const = 0;
    /// Planes that it makes use of where a file has them.
    [[nodiscard]] virtual std::vector<std::string> optional_planes(io::ChannelNames const&) const { return {}; }
    /// Whether each file must say where its camera is.
    [[nodiscard]] virtual bool needs_camera() const = 0;
    /// Shows it a frame that comes after those that it has seen, and will be denoised later. Most presets make no use of it.
    virtual void look_ahead(io::ExrImage const&, io::ChannelNames const&, long long /*number*/) {}
    /// Drops the frames that it was shown and has not denoised.
    virtual void drop_ahead() {}
    /// From now on each frame is looked at for what its renderer got wrong.
    /// @param by what the denoised signal is multiplied by at the end, where that is the albedo it was divided by; one source per component
    void diagnose(std::vector<io::Source> by = {}) { looks = true, factor = std::move(by); }
    /// Looks at the first frames for the mistakes that are told at little cost.
    void check_first_frames() { to_check = first_frames; }
    /// What was found in the last frame.
    [[nodiscard]] virtual std::vector<Finding> const& findings() const = 0;
    /// Whether it makes a channel of DebugChannels, by its name.
    [[nodiscard]] virtual bool has_debug_view(std::string const& view) const = 0;
    /// What a channel of DebugChannels shows of the last frame, by its name: none where it makes none.
    [[nodiscard]] virtual std::vector<DebugImage> debug_images(std::string const& view) = 0;
    /// The next frame, denoised: linear, row by row. Where its size is another one, history starts afresh.
    [[nodiscard]] virtual metrics::Picture denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number) = 0;
    /// What it remembers; nothing where that is nothing, or not of one signal.
    [[nodiscard]] virtual std::optional<HistoryContents> remembered() const { return std::nullopt; }
    /// Makes it remember what another one of the same preset did, of a picture with or without alpha.
    virtual void remember(HistoryContents const&) {}
    /// Gives back all memory but what it remembers.
    virtual void release_scratch() = 0;
    /// Alpha of the last frame, where the signal has it.
    [[nodiscard]] std::vector<float> const& alpha() const { return denoised_alpha; }
    /// Counts of the last frame: missing samples, impossible guides.
    [[nodiscard]] virtual Statistics statistics() const = 0;
    /// Its passes in order, what each reads and writes, and memory: a table in Markdown.
    [[nodiscard]] virtual std::string plan() const = 0;
    /// Memory of history and scratch. Complete once a frame was denoised.
    [[nodiscard]] virtual double bytes_per_pixel() const = 0;
    /// How long denoising has taken so far, without reading files and loading frames from them.
    [[nodiscard]] double milliseconds() const { return taken; }

protected:
    double taken = 0;   ///< milliseconds
    bool looks = false; ///< whether frames are looked at
    static constexpr int first_frames = 10;
    int to_check = 0; ///< frames that are still to be looked at at little cost
    CheapDiagnosis check;
    std::vector<io::Source> factor; ///< what diagnose() was told
    std::vector<float> denoised_alpha;

    /// What is found in one of the first frames.
    template <class F> [[nodiscard]] std::vector<Finding> checked(F const& frame, MotionConvention const& converted_from) {
        if (to_check == 0) return {};
        --to_check;
        return check(frame, converted_from);
    }

    /// The picture, after its alpha was kept.
    [[nodiscard]] metrics::Picture picture_and_alpha(ImageView auto const& view) {
        if constexpr (std::remove_cvref_t<decltype(view)>::components == 4) {
            denoised_alpha.clear();
            for (int y = 0; y < view.size.height; ++y)
                for (int x = 0; x < view.size.width; ++x) denoised_alpha.push_back(view.get(3, x, y));
        }
        return metrics::picture_of(view);
    }

    /// Component c at (x, y) of the factor, as quell::diagnose() wants it; nothing where there is none.
    [[nodiscard]] std::function<float(int c, int x, int y)> factor_in(io::ExrImage const& image) const;
};

/// A channel that a preset denoises.
struct SignalOfPreset {
    std::string name;
    int components;
};

/// A pipeline by its name, for a size and a number of threads (0: all that there are).
struct Preset {
    std::string name;
    std::unique_ptr<Denoiser> (*make)(Extent size, int threads);
    /// The same for a picture with alpha; null where alpha can't be denoised.
    std::unique_ptr<Denoiser> (*make_with_alpha)(Extent size, int threads) = nullptr;
    /// The same with debug images, slower; null where there is none.
    std::unique_ptr<Denoiser> (*make_watched)(Extent size) = nullptr;
    bool looks_ahead = false;         ///< whether it makes use of frames that come later
    bool is_part = false;             ///< whether what comes out is one effect's part of the picture
    bool wants_sharp_picture = false; ///< whether it blurs a picture of one instant
    PresetGroup group = PresetGroup::general;
    std::vector<SignalOfPreset> of_signals = {}; ///< what it denoises: several where it puts a picture together
    bool by_albedo = false;                      ///< whether it divides the picture by its albedo before it denoises it
    int warm_up = 0;                             ///< how many frames before the first make a frame what it is in the whole sequence

    static constexpr int usual_later_frames = 2; ///< of those that it looks ahead at
};

} // namespace quell::examples
