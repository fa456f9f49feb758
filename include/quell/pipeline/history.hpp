#pragma once

#include <quell/image/memory.hpp>
#include <quell/pipeline/execution/counts.hpp>
#include <quell/pipeline/execution/image_pool.hpp>
#include <quell/pipeline/pipeline.hpp>

#include <optional>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {
template <class... Ps> struct Composite;
template <class P, ImageStorage Storage> class History;

/// Pixels of a frame with guides that no scene has, which are repaired (docs/channels.md, impossible guides). A pixel without a surface
/// needs no normal.
struct RepairedGuides {
    long long pixels = 0; ///< with one or more
    long long albedo = 0; ///< with a component outside [0, 1]
    long long normal = 0; ///< of another length than 1 or 0
    long long depth = 0;  ///< 0, negative or NaN
    long long motion = 0; ///< not finite: such pixels have no history

    /// Adds those of another frame.
    RepairedGuides& operator+=(RepairedGuides const& other) {
        pixels += other.pixels, albedo += other.albedo, normal += other.normal, depth += other.depth, motion += other.motion;
        return *this;
    }
};

/// Counts of the runs with one history.
struct Statistics {
    long long frames = 0;           ///< since the last reset
    long long missing_samples = 0;  ///< in the last frame: not finite, a component beyond 1e16, or negative luminance
    RepairedGuides repaired_guides; ///< in the last frame
    /// Light that SuppressFireflies took away in the last frame: sum of luminance, in the units of the host's samples. The same for any
    /// number of threads.
    double suppressed = 0;
    long long resets = 0; ///< how often history was dropped: first frame, new size, gap in the frame numbers, forget()
};

namespace detail {
template <class Set> struct StoredChannels;
template <class... Cs> struct StoredChannels<Channels<Cs...>> { using type = Channels<typename Remembered<Cs>::Stored...>; };
template <class P, class FrameT, class H, class E, class Into> class Run;
struct Inspect;
struct ReachContents;
struct DiagnosisNotes;

/// What one frame leaves for the next. A history has two, a double buffer: `then` and `now`.
template <class P, class Storage> struct FrameState {
    using Guides = typename StoredChannels<typename P::remembers>::type; ///< as the history stores them

    PooledImage<ImageOf<Storage, typename P::Signal>> signal; ///< accumulated
    Handles<Storage, typename P::keeps> kept;                 ///< made by policies
    Handles<Storage, Guides> guides;                          ///< copies of the host's channels that policies remember
    Camera camera;
    float shutter = 0;
    std::optional<long long> number;

    void drop_images() {
        signal = {};
        kept.drop_all();
        guides.drop_all();
    }
};

template <class... Parts> std::true_type a_pipeline(Pipeline<Parts...> const*);
template <class... Ps> std::true_type a_pipeline(Composite<Ps...> const*);
std::false_type a_pipeline(void const*);
template <class P, class Storage> std::true_type a_history(History<P, Storage> const*);
std::false_type a_history(void const*);
template <class T> inline constexpr bool is_pipeline = decltype(a_pipeline(static_cast<T const*>(nullptr)))::value;
template <class T> inline constexpr bool is_history = decltype(a_history(static_cast<T const*>(nullptr)))::value;

/// Whether a history cannot be made of these.
template <class... Ts> inline constexpr bool makes_no_history = true;
template <class T> inline constexpr bool makes_no_history<T> = !is_history<T> && !std::is_same_v<T, std::shared_ptr<ImagePool>>;
template <class Size, class P, class... Rest>
inline constexpr bool makes_no_history<Size, P, Rest...> =
    !(std::is_convertible_v<Size const&, Extent> && is_pipeline<P> && sizeof...(Rest) < 2 && (ImageStorage<Rest> && ...));

template <class... Args> void refuse_history() {
    static_assert(sizeof...(Args) > 99,
                  "History{size, pipeline, storage}: it takes an Extent{width, height}, a pipeline, and maybe a storage "
                  "as quell/image/image_storage.hpp describes it, in that order");
}

/// Checks the size of a history.
inline Extent checked(Extent size) {
    if (size.width > 0 && size.height > 0) return size;
    raise_error<Failure>("history size", to_string(size), "give a width and a height of at least one pixel");
}
} // namespace detail

/// All state between frames: the accumulated signal, copies of guides of the last frame, what the policies keep, and scratch. One history
/// serves one pipeline and one view. It resets itself at the first frame, after a change of size, and where frame numbers do not follow
/// each other.
/// @tparam P       the pipeline's type
/// @tparam Storage of history and scratch: Planar<>, Planar<Float16>, or another ImageStorage that owns its memory
template <class P, ImageStorage Storage = Planar<>> class History {
    static_assert(owns_memory<Storage>(),
                  "History<P, Storage>: what quell remembers needs memory of its own: Planar<> or Planar<Float16>, not Borrowed");

public:
    /// @throws Error for a size without pixels
    explicit History(Extent size_, P const&, Storage const& = {}) : History(std::make_shared<detail::ImagePool>(detail::checked(size_))) {}

    /// @cond
    template <class... Args>
        requires detail::makes_no_history<Args...>
    explicit History(Args const&...) { detail::refuse_history<Args...>(); }
    /// @endcond

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() { empty = true; }

    /// Gives scratch back, and what run() returned: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() {
        output = {};
        pool->release();
    }
    /// Forgets, and gives all memory back.
    void release() {
        forget();
        then.drop_images();
        release_scratch();
    }

    /// Counts so far.
    [[nodiscard]] Statistics const& statistics() const { return counted; }
    /// Memory of history and scratch, in bytes. Complete after the second frame.
    [[nodiscard]] std::size_t bytes() const { return pool->bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(size.pixels()); }

    /// View of a channel that a policy keeps (history_length, luminance_variance, ...). Valid after the first frame. One that none keeps
    /// does not compile, and makes a requires-expression false.
    template <ChannelTag C>
        requires(P::keeps::template has<C>)
    [[nodiscard]] auto operator[](C) const { return then.kept.views(Channels<C>{}).view(C{}); }
    /// @cond
    template <ChannelTag C, detail::Sentence = "history[channel]: no policy of this pipeline keeps that channel">
        requires(!P::keeps::template has<C>)
    void operator[](C) const = delete; // history[channel]: no policy of this pipeline keeps that channel
    /// @endcond

private:
    template <class, class, class, class, class> friend class detail::Run;
    friend struct detail::Inspect;
    friend struct detail::ReachContents;
    template <class, ImageStorage> friend class History;
    using State = detail::FrameState<P, Storage>;

    std::shared_ptr<detail::ImagePool> pool;                                               ///< this history's own, or shared by a composite
    std::shared_ptr<detail::Counts> counts = detail::counts_in<MemoryOf<Storage>>();       ///< of the running frame
    std::shared_ptr<detail::Counts> counts_again = detail::counts_in<MemoryOf<Storage>>(); ///< of its second ingest, with repaired guides
    Extent size;
    State then; ///< of the last frame: passes read it. Images that no later pass reads go back to the pool, or to `now`.
    State now;  ///< of the running frame: passes write it. advance() makes it `then`.
    detail::PooledImage<ImageOf<Storage, typename P::Output>> output; ///< for the host; may be the signal's image
    bool empty = true;                                                ///< whether `then` is no past of the next frame
    Statistics counted;
    std::shared_ptr<detail::DiagnosisNotes> notes; ///< of quell::diagnose

    explicit History(std::shared_ptr<detail::ImagePool> shared) : pool(std::move(shared)), size(pool->size()) {}

    /// Starts a frame: drops what is no past of it, and returns whether there is one.
    bool start(Extent frame_size, std::optional<long long> number) {
        bool const follows = !number || !then.number || *number == *then.number + 1;
        if (!(size == frame_size)) restart(frame_size);
        if (!follows) empty = true;
        now = {}; // half written, if an exception ended the last frame
        if (empty) then.drop_images(), ++counted.resets, counted.frames = 0;
        output = {};
        // History counts as empty until the frame is complete: an exception must not leave half of one.
        return !std::exchange(empty, true);
    }
    /// Takes note of what the first pass has counted.
    void note(detail::GuideCounts const& guides, detail::Counts const& samples) {
        counted.missing_samples = samples.missing;
        counted.suppressed = samples.suppressed.total();
        counted.repaired_guides = {guides.pixels, guides.of(albedo), guides.of(normal), guides.of(depth), guides.of(motion)};
    }
    /// Ends a frame: what it has written is what the next one reads.
    void advance(auto const& frame) {
        now.camera = frame.camera, now.shutter = frame.shutter, now.number = frame.number;
        then = std::exchange(now, State{});
    }

    /// Drops everything and takes another size.
    void restart(Extent new_size) {
        then.drop_images();
        now = {};
        output = {};
        pool->resize(new_size);
        size = new_size;
        empty = true;
    }
};
/// @cond
template <class P, ImageStorage Storage>
    requires(!detail::is_pipeline<P>)
class History<P, Storage> {
public:
    template <class... Args> explicit History(Args const&...) { detail::refuse_history<Args...>(); }
};
template <class... Args>
    requires(detail::makes_no_history<Args...>)
History(Args const&...)
->History<Pipeline<Radiance>>;
/// @endcond
template <class P> History(Extent, P const&) -> History<P>;
template <class P, ImageStorage Storage> History(Extent, P const&, Storage const&) -> History<P, Storage>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
