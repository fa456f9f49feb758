#pragma once

#include <quell/pipeline/graph/counts.hpp>
#include <quell/pipeline/graph/frame_pass.hpp>
#include <quell/pipeline/graph/listed_passes.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A list of passes that is made again only where a frame is run otherwise than the last: with other numbers in the pipeline, another type
/// of executor or of the frame, or up to another stage.
class ListOnce {
    PassList held;
    void const* made_by = nullptr;
    std::vector<std::byte> made_of;

public:
    [[nodiscard]] PassList const& list() const { return held; }
    /// @param maker    its address tells all types that a list depends on
    /// @param pipeline whose bytes tell its numbers. Other bytes in its gaps make another list of the same passes.
    /// @param make     make(list)
    template <class P> void update(void const* maker, P const& pipeline, auto const& make) {
        if (made_by == maker && std::memcmp(made_of.data(), static_cast<void const*>(&pipeline), sizeof(P)) == 0) return;
        made_by = nullptr; // until it is complete
        make(held);
        made_of.resize(sizeof(P));
        std::memcpy(made_of.data(), static_cast<void const*>(&pipeline), sizeof(P));
        made_by = maker;
    }
};

/// Counts of a frame that is in a queue: who has to be asked for them.
struct LateCounts {
    static constexpr std::size_t most_bytes = 64;
    QueueCalls const* queue = nullptr; ///< null: there are none
    alignas(std::max_align_t) std::array<std::byte, most_bytes> executor{};

    void await(TypedByKernel const& typed) {
        queue = typed.queue;
        std::memcpy(executor.data(), typed.executor, queue->size);
    }
};

/// What a history remembers of its last frame, for others that go on from there too. Images are shared: a pass overwrites none that is held
/// here.
struct KnownPast {
    FrameState then{};
    Extent size{0, 0};
    long long frames = 0; ///< since that history began
    bool is_known = false;

    /// Whether it is the past of a frame.
    [[nodiscard]] bool is_before(Extent frame, std::optional<long long> number) const {
        return is_known && size == frame && (!number || !then.number || *number == *then.number + 1);
    }
    /// Drops the images, and keeps memory of its own.
    void drop() { then.drop_images(), is_known = false; }
};

/// What a history holds, whatever its pipeline.
struct HistoryImages {
    std::shared_ptr<ImagePool> pool;     ///< this history's own, or shared by a composite
    std::shared_ptr<FrameCounts> counts; ///< of the running frame
    Extent size = pool->size();
    FrameState then{};            ///< of the last frame: passes read it. Images that no later pass reads go back to the pool, or to `now`.
    FrameState now{};             ///< of the running frame: passes write it. advance() makes it `then`.
    PooledImage output{};         ///< for the host; may be the signal's image
    bool empty = true;            ///< whether `then` is no past of the next frame
    mutable Statistics counted{}; ///< without `late`
    mutable LateCounts late{};
    ListOnce passes{};                         ///< of the last frame, and of the next if it is run like the last
    ListedPasses listed{};                     ///< of the running frame, for a ListExecutor
    std::vector<std::byte> job{};              ///< of the running pass
    ImageTable made{}, made_out{}, repaired{}; ///< of the running frame

    /// Drops all history before the next frame.
    void forget() { empty = true; }
    void release_scratch() {
        output = {};
        pool->release();
    }
    void release() {
        forget();
        then.drop_images();
        release_scratch();
    }

    /// Starts a frame: drops what is no past of it, and returns whether there is one.
    bool start(Extent frame_size, std::optional<long long> number) {
        bool const follows = !number || !then.number || *number == *then.number + 1;
        if (!(size == frame_size)) restart(frame_size);
        if (!follows) empty = true;
        late.queue = nullptr;
        now.drop_images(); // half written, if an exception ended the last frame
        if (empty) then.drop_images(), ++counted.resets, counted.frames = 0;
        output = {};
        // History counts as empty until the frame is complete: an exception must not leave half of one.
        return !std::exchange(empty, true);
    }
    /// Waits for a queue, where the last frame is in one, and takes note of what it has counted.
    void take_late_counts() const {
        if (auto const* const queue = std::exchange(late.queue, nullptr)) {
            FrameCounts of_frame;
            queue->read(late.executor.data(), &of_frame, counts.get(), sizeof(of_frame));
            bool repeated = false;
            for (auto const& each : passes.list().repairs)
                repeated = repeated || (each.changes_samples && of_frame.first.guides.of(each.number) > 0);
            note(of_frame.first.guides, repeated ? of_frame.again : of_frame.first);
        }
    }
    /// Takes note of what the first pass has counted.
    void note(GuideCounts const& guides, Counts const& samples) const {
        counted.missing_samples = samples.missing;
        counted.suppressed = samples.suppressed.total();
        counted.repaired_guides = guides.total();
    }
    /// Copies what it remembers.
    void tell(KnownPast& to) const {
        to.is_known = !empty;
        to.then = then, to.size = size, to.frames = counted.frames;
    }
    /// Remembers what another history of a pipeline that keeps and remembers no less does.
    void learn(KnownPast const& past) {
        if (!(size == past.size)) restart(past.size);
        then = past.then, empty = !past.is_known, counted.frames = past.frames;
    }
    /// Drops what it remembers and has put out, and leaves scratch to histories that share its pool.
    void drop_past() {
        forget();
        then.drop_images(), output = {};
    }
    /// Ends a frame: what it has written is what the next one reads.
    void advance() {
        std::swap(then, now);
        now.drop_images();
    }
    /// Drops everything and takes another size.
    void restart(Extent new_size) {
        then.drop_images(), now.drop_images();
        output = {};
        pool->resize(new_size);
        size = new_size;
        empty = true;
    }
    void drop_scratch() { made.drop_all(), made_out.drop_all(), repaired.drop_all(); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
