#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// What the library's own code and its code for one instruction set say to each other. No header of quell's is included: these types are the
// same for all instruction sets.
namespace quell_library {

/// Which pixels have a sample, where there are fewer samples than pixels: quell_samples of quell.h, with nothing left to default.
struct Samples {
    std::int32_t columns = 0, rows = 0; ///< of a block, in pixels; 0: every pixel has one
    std::int32_t staggered = 0, phase_x = 0, phase_y = 0;
    std::int32_t width = 0, height = 0; ///< of the image
    bool side_by_side = false;          ///< the image holds samples only; else it is of the frame's size
    bool repeats = false;               ///< whether a pixel without a sample has its block's; else it has none
};

/// An image of the caller's. Strides are in bytes.
struct Image {
    std::byte* data = nullptr;
    std::ptrdiff_t component_stride = 0, pixel_stride = 0, row_stride = 0;
    bool is_half = false;
    bool is_padded = false; ///< planes of floats in padded rows, as quell's own images are
    /// What a value of a channel of two components is multiplied by, and what is added to it.
    float scale[2] = {1, 1}, offset[2] = {0, 0};
    Samples samples{};
};

struct Channel {
    std::string name{};
    int components = 0;
    bool optional = false; ///< frames may lack it
    bool is_guide = false; ///< every pixel must have it
};

struct Camera {
    float view[16], projection[16], jitter[2];
};

/// What motion vectors mean: see quell.h.
struct Motion {
    std::int32_t from_previous = 0, unit = 0, y_up = 0, has_jitter = 0;
};

struct Frame {
    std::int32_t width = 0, height = 0;
    std::vector<Image> channels{}; ///< in the preset's order; an optional one may have no data
    Camera const* camera = nullptr;
    long long number = 0;
    bool has_number = false;
    float shutter = 0.5f;
};

/// Runs tasks side by side.
struct Parallel {
    void (*run)(void* user, std::int32_t count, void (*task)(void* context, std::int32_t index), void* context) = nullptr;
    void* user = nullptr;
    std::int32_t threads = 1;                ///< that there are, as far as is known: none should idle
    void (*pass_done)(void* user) = nullptr; ///< called behind each pass, if at all
    void* stream = nullptr;                  ///< of a device, for code that runs on one
};
/// Where images lie.
struct Memory {
    void* (*allocate)(void* user, std::size_t bytes, std::size_t alignment) = nullptr;
    void (*release)(void* user, void* memory) = nullptr;
    void* user = nullptr;
    bool may_move = false; ///< to and from a device that has too little, as passes need it
};

struct Statistics {
    long long frames = 0, resets = 0, missing_samples = 0, repaired_guides = 0;
    std::size_t bytes = 0;
};

enum class Outcome { ok, invalid, not_supported, no_memory, failed };

/// A preset with its history.
class Instance {
public:
    Instance() = default;
    Instance(Instance const&) = delete;
    Instance& operator=(Instance const&) = delete;
    virtual ~Instance() = default;
    /// Denoises the first of some frames, with those after it where it makes use of them.
    /// @param error what is wrong, where it is not ok
    virtual Outcome run(std::vector<Frame> const& frames, Image const& output, std::string& error) noexcept = 0;
    /// Copies a guide that it has accumulated, of the frame that was denoised last. Invalid where there is none.
    virtual Outcome copy_guide(std::string const& name, Image const& output, std::string& error) noexcept = 0;
    virtual void forget() noexcept = 0;
    [[nodiscard]] virtual Statistics statistics() const noexcept = 0;
};

/// Sizes of the frames and of what comes out, which are the same but where a preset is resolved.
struct Sizes {
    std::int32_t width = 0, height = 0, output_width = 0, output_height = 0;
};

/// A preset as code for one purpose, with stages.
struct PresetWay {
    std::vector<Channel> channels{};
    std::vector<Channel> guides{}; ///< that it accumulates
    int output_components = 0;
    bool needs_camera = false;
    std::string needs_jitter{}; ///< the stage that needs the camera's jitter, in a range; empty: none
    std::function<std::string()> plan{};
    /// Null, and what is wrong, where it can't be made.
    /// @param samples of each pixel
    std::function<std::unique_ptr<Instance>(Sizes const&, float samples, Motion const&, Parallel const&, Memory const&, Outcome& outcome,
                                            std::string& error)>
        make{};
};
/// A preset as code.
struct PresetCode {
    std::string name{};
    /// The preset with stages. Null where that can't be.
    /// @param stages  names of Codes::stages, each once
    /// @param alpha   whether pictures have it
    /// @param refusal what is wrong then: a sentence
    std::function<std::shared_ptr<PresetWay const>(std::vector<std::string> const& stages, bool alpha, std::string& refusal)> with{};
};

/// All presets, compiled for one instruction set, or for a device, and the names of all stages, in the order in which they run.
struct Codes {
    std::vector<PresetCode> presets{};
    std::vector<std::string> stages{};
};
using CodesOf = Codes const*();

// Names of stages that change what a denoiser reads, how it is called, or what stands behind them.
inline constexpr auto two_sided_stage = "two-sided", resolve_stage = "resolve", evidence_stage = "evidence", colours_stage = "colours";
/// Behind the name of a preset: why it can't have both.
inline constexpr auto colours_and_resolve = "has the colours of the pixels' centres with 'colours', and 'resolve' is for samples that lie "
                                            "elsewhere; leave one of the two out";

} // namespace quell_library
