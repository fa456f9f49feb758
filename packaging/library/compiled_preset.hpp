#pragma once

#include "preset_code.hpp"

#include <quell/diagnose/debug_channels.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/frame/camera.hpp>
#include <quell/pipeline/history_contents.hpp>
#include <quell/pipeline/statistics.hpp>
#include <quell/presets/preset_group.hpp>

#include <optional>
#include <span>

// Presets as compiled code. libquell, the programs and the tests share it, so that a build compiles each preset once.
namespace quell_library {

/// The images of one frame, in the order of Way::channels, and what else frames have.
struct FrameImages {
    quell::Extent size{};
    std::vector<Image> channels{}; ///< an optional one may have no data
    quell::Camera camera{};
    std::optional<long long> number{};
    float shutter = 0.5f;
};

/// A preset of any type with its history.
class CompiledDenoiser {
public:
    CompiledDenoiser() = default;
    CompiledDenoiser(CompiledDenoiser const&) = delete;
    CompiledDenoiser& operator=(CompiledDenoiser const&) = delete;
    virtual ~CompiledDenoiser() = default;

    /// Denoises the first frame of a window. The others are those after it, which two-sided ways make use of.
    /// @param output written; of the frame's size, or of its own: see resolve_stage
    /// @throws quell::Error as quell::run() does
    virtual void run(std::span<FrameImages const> window, Image const& output) = 0;

    virtual void forget() = 0;
    /// Gives back all memory but what it remembers.
    virtual void release_scratch() = 0;
    [[nodiscard]] virtual quell::Statistics statistics() const = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;

    /// What quell::diagnose() looks at: a frame that will be denoised next. It refers to the frame's images.
    /// @throws quell::Error for frames that run() refuses
    [[nodiscard]] virtual quell::detail::Observation observe(FrameImages const& frame) = 0;
    /// Whether it makes a channel of quell::DebugChannels, by its name.
    [[nodiscard]] virtual bool has_debug_view(std::string_view view) const = 0;
    /// What that channel shows of the last frame.
    [[nodiscard]] virtual std::vector<quell::DebugImage> debug_images(std::string_view view) = 0;
    /// Copies a guide that it has accumulated, of the frame that was denoised last, by its channel's name: one of Way::guides. Returns
    /// false where there is none, as before the first frame.
    /// @param output written; of the frame's size
    virtual bool copy_guide(std::string_view /*name*/, Image const& /*output*/) { return false; }
    /// What it remembers; nothing where that is nothing, or not of one signal.
    [[nodiscard]] virtual std::optional<quell::HistoryContents> remembered() const = 0;
    /// Makes it remember what another one of the same preset did, of a picture with or without alpha.
    virtual void remember(quell::HistoryContents const& contents) = 0;
    /// The same as images that it holds: for another one to go on from there, of the same preset or of one that keeps and remembers no
    /// other channel. Nothing is known where it remembers nothing, or not of one signal.
    virtual void tell(quell::detail::KnownPast& to) const = 0;
    /// Goes on from there.
    virtual void learn(quell::detail::KnownPast const& past) = 0;
};

/// A channel that a denoiser reads.
struct ReadChannel {
    std::string name{};
    int components = 0;
    int fraction = 1;      ///< image size = frame size / fraction, rounded up
    bool optional = false; ///< frames may lack it
    bool is_guide = false; ///< every pixel must have it
};

/// A guide that a denoiser accumulates, for what comes behind it.
struct MadeGuide {
    std::string name{};
    int components = 0;
};

/// A preset compiled for one purpose.
struct Way {
    std::vector<ReadChannel> channels{};
    std::vector<MadeGuide> guides{}; ///< that it accumulates
    std::string signal{};            ///< the channel that its one history is of; empty: it has none, or several
    int output_components = 0;
    bool needs_camera = false;
    std::vector<std::string> (*passes)() = nullptr; ///< their names, in order
    std::string (*plan)() = nullptr;                ///< a table in Markdown
    /// @throws quell::Error, std::bad_alloc
    std::function<std::unique_ptr<CompiledDenoiser>(quell::Extent size, Parallel const&, Memory const&)> make{};

    explicit operator bool() const { return make != nullptr; }
    /// The place of a channel among those that it reads; none where it does not read it.
    [[nodiscard]] std::optional<std::size_t> place_of(std::string_view channel) const {
        for (std::size_t i = 0; i < channels.size(); ++i)
            if (channels[i].name == channel) return i;
        return std::nullopt;
    }
};

/// A channel that a preset denoises.
struct SignalOfPreset {
    std::string name{};
    int components = 0;
};

/// A preset with all that is compiled of it.
struct CompiledPreset {
    std::string name{};
    quell::PresetGroup group = quell::PresetGroup::general;
    Way usual{};           ///< in real time: what the preset's function makes
    Way picture{};         ///< of one effect: its part of the picture comes out
    Way two_sided{};       ///< uses the frames after each, as far as there are some
    Way two_sided_alpha{}; ///< the same for a picture with alpha
    Way watched{};         ///< makes debug images

    std::vector<SignalOfPreset> of_signals{}; ///< what it denoises: several where it puts a picture together
    bool by_albedo = false;                   ///< whether it divides the picture by its albedo before it denoises it
    bool wants_sharp_picture = false;         ///< whether it blurs a picture of one instant
    std::string_view judge{};                 ///< see quell::NamedPreset
    std::string_view stages{};                ///< see quell::NamedPreset
    int warm_up = 0;                          ///< how many frames before the first make a frame what it is in the whole sequence
};

/// All that are compiled, in the order of quell::all_presets.
[[nodiscard]] std::vector<CompiledPreset> const& compiled_presets();
/// A share of the presets of the first three groups (`published` false) or of the published ones, number `unit` of `units`: those among
/// QUELL_PRESETS, in a generated file.
template <bool published, std::size_t unit, std::size_t units> [[nodiscard]] std::vector<CompiledPreset> compiled_presets_of_unit();

} // namespace quell_library
