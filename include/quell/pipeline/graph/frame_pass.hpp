#pragma once

#include <quell/execute/list_executor.hpp>
#include <quell/execute/queue_executor.hpp>
#include <quell/frame/camera.hpp>
#include <quell/frame/pixel_rays.hpp>
#include <quell/pipeline/graph/image_pool.hpp>

#include <cstring>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

struct Counts;
struct FrameCounts;

/// What one frame leaves for the next. A history has two, a double buffer: `then` and `now`.
struct FrameState {
    PooledImage signal{}; ///< accumulated
    ImageTable kept{};    ///< made by policies
    ImageTable guides{};  ///< copies of the host's channels that policies remember
    Camera camera{};
    float shutter = 0;
    std::optional<long long> number{};

    void drop_images() {
        signal = {};
        kept.drop_all();
        guides.drop_all();
    }
};

/// What all passes of a frame have in common.
struct FrameFacts {
    Extent size;
    glm::mat4 clip_from_world{1.f}, clip_from_world_then{1.f};
    PixelRays rays, rays_then;
    glm::vec2 jitter{0.f}, jitter_then{0.f};
    float shutter = 0, shutter_then = 0;
    std::int32_t frame_index = 0;
    bool has_past = false;
};

/// What only the function of a kernel knows the types of. `target` is the image that the host wants the output in, if any. `run_list` is of
/// a ListExecutor, `queue` of a QueueExecutor; else null.
struct TypedByKernel {
    void const *pipeline = nullptr, *frame = nullptr, *executor = nullptr, *target = nullptr;
    void (*run_list)(void const* executor, std::span<ListedPass const>) = nullptr;
    QueueCalls const* queue = nullptr;
};

/// What a pass reads and writes, as images.
struct PassImages {
    ImageTable const& repaired; ///< copies of the host's channels that stand in for them
    ImageTable const& made;     ///< by earlier passes
    PooledImage const& signal;
    FrameState const& then;
    // written:
    PooledImage signal_out;
    ImageTable const& made_out;
    ImageTable const& guides_out;
    PooledImage const& output;
};
/// What a pass stores beside its channels.
struct PassStores {
    bool signal = false, output = false, guides = false;
};

/// The arguments of a pass in one frame.
struct PassArguments {
    std::byte const* kernel; ///< the policy's numbers
    FrameFacts const& facts;
    TypedByKernel const& typed;
    PassImages const& images;
    PassStores stores;
    Counts* counts;                ///< of the ingest; else null
    int step;                      ///< of FillHoles
    FrameCounts* queued = nullptr; ///< of a queue, whose passes look there whether copies stand in for the host's guides
};

/// What a queue has to do behind the ingest, in the few frames that need it.
struct IngestCompletionArguments {
    PassArguments ingest;    ///< once more, with repaired guides
    PassArguments fill;      ///< FillHoles from the ingest's image
    PassArguments fill_back; ///< and back to it
};

/// A channel that a pass makes, and how it is stored.
struct MadeChannel {
    ChannelId id = nullptr;
    ImageFormat format{};
};
/// Those that a pass makes.
struct MadeChannels {
    static constexpr int most = 8;
    std::array<MadeChannel, most> channels{};
    int count = 0;

    [[nodiscard]] constexpr MadeChannel const* begin() const { return channels.data(); }
    [[nodiscard]] constexpr MadeChannel const* end() const { return channels.data() + count; }
    [[nodiscard]] constexpr bool has(ChannelId wanted) const {
        for (auto const& each : *this)
            if (each.id == wanted) return true;
        return false;
    }
};

/// One pass over the image, as a value: what it reads and writes, and the function that runs it.
struct FramePass {
    std::string_view name;
    int fraction = 1;               ///< runs at 1/fraction of the frame's width and height
    int farthest_tap = 0;           ///< largest distance at which it looks at images of this frame, in its own pixels; or `anywhere`
    ChannelIds reads{};             ///< of the host's frame
    ChannelIds reads_made{};        ///< made by earlier passes of this frame
    ChannelIds reads_kept{};        ///< made in the last frame
    ChannelIds reads_remembered{};  ///< the host's, of the last frame
    bool reads_signal = true;       ///< of earlier passes
    bool reads_past_signal = false; ///< of the last frame
    MadeChannels makes{};
    bool makes_signal = false;
    bool feeds_history = false; ///< the signal behind it is the past of the next frame

    void (*make_job)(PassArguments const&, std::byte* job) = nullptr; ///< writes its arguments in one frame
    void (*run)(Region, std::byte const* job, void const* executor) = nullptr;
    std::size_t job_bytes = 0;
    std::size_t kernel = 0; ///< where its kernel lies in PassList::kernels

    [[nodiscard]] constexpr bool reads_past() const { return reads_past_signal || reads_kept.size() > 0 || reads_remembered.size() > 0; }
};

/// Copies a guide with its impossible values repaired, in frames that have some.
struct GuideRepair {
    ChannelId id = nullptr;
    ImageFormat format{};
    int number = 0;               ///< of CheckedGuides
    bool changes_samples = false; ///< whether the ingest reads it for the samples
    void (*run)(TypedByKernel const&, PooledImage const& copy) = nullptr;
};

/// Everything that run() does with a frame, in order: plain data that the pipeline's type and its numbers give. What differs from frame to
/// frame is none of it.
struct PassList {
    FramePass ingest, fill_holes;
    std::vector<FramePass> passes; ///< after them
    std::vector<GuideRepair> repairs;
    std::vector<std::byte> kernels; ///< numbers of the policies
    ChannelIds keeps;               ///< made channels that the next frame sees
    ChannelIds carries;             ///< what they were in frames farther back, the latest first
    /// Copies what is carried where images can't be handed on; null where they can.
    void (*carry)(TypedByKernel const&, ImagePool&, ImageTable const& then, ImageTable& now, bool has_past) = nullptr;
    ChannelIds remembers; ///< the host's channels that the next frame sees
    std::array<MadeChannel, 8> guides{};
    int guide_count = 0; ///< what is copied for the next frame, as the history stores it
    ImageFormat signal, output;
    void (*complete_ingest)(IngestCompletionArguments const&) = nullptr; ///< of a queue
    bool has_past = false;                                               ///< there is a history
    bool demodulates = false;                                            ///< the output is another image than the signal
    bool has_target = false;                                             ///< the host gives an image for the output

    constexpr void clear() {
        passes.clear(), repairs.clear(), kernels.clear();
        guide_count = 0;
    }
    /// Whether a pass behind pass i reads a channel.
    [[nodiscard]] constexpr bool is_read_behind(ChannelId made, std::size_t i) const {
        for (auto next = i + 1; next < passes.size(); ++next)
            if (passes[next].reads_made.has(made)) return true;
        return false;
    }
    /// Whether anything reads what pass i makes of a channel.
    [[nodiscard]] constexpr bool is_wanted(ChannelId made, std::size_t i) const {
        for (auto next = i + 1; next < passes.size(); ++next) {
            if (passes[next].reads_made.has(made)) return true;
            if (passes[next].makes.has(made)) return false;
        }
        return keeps.has(made);
    }
    /// Whether a later pass or the next frame reads the signal that pass i makes.
    [[nodiscard]] constexpr bool stores_signal(std::size_t i) const {
        return passes[i].makes_signal && (i + 1 < passes.size() || passes[i].feeds_history);
    }
    /// Stores a kernel, and returns its place. A list that a compiler makes has no numbers: it is looked at, not run.
    template <class Kernel> constexpr std::size_t keep(Kernel const& kernel) {
        if (std::is_constant_evaluated()) return 0;
        auto const at = kernels.size();
        kernels.resize(at + sizeof(Kernel));
        std::memcpy(kernels.data() + at, &kernel, sizeof(Kernel));
        return at;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
