#pragma once

#include <quell/image/memory.hpp>
#include <quell/pipeline/graph/history_images.hpp>
#include <quell/pipeline/pipeline.hpp>

#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {
template <class... Ps> struct Composite;
template <class First, class... Links> struct Chain;
template <class P, class Policy> struct Resolved;
template <class P, class Judge> struct ByEvidence;
template <class P> struct TwoSided;
template <class P, ImageStorage Storage> class History;

namespace detail {
struct Inspect;
struct DiagnosisNotes;
struct ChainRun;
/// Puts the passes of a denoiser that its histories have run in their last frame among those of a plan.
template <class P> struct PassesOf;
/// How many frames before the last one it keeps as they were.
template <class P> inline constexpr int kept_frames_of = 0;
template <ChannelTag S, class... Parts>
inline constexpr int kept_frames_of<Pipeline<S, Parts...>> = most_frames_earlier(typename Pipeline<S, Parts...>::carries{});
/// Access to what a history holds.
struct OpenHistory {
    template <class H> static auto& images(H& history) { return history.images; }
    /// Where its images lie, to be shared with others.
    template <class H> static auto& shared_pool(H& history) {
        if constexpr (requires { history.images; })
            return history.images.pool;
        else if constexpr (requires { history.pool; })
            return history.pool;
        else if constexpr (requires { history.before; })
            return shared_pool(history.before);
        else
            return shared_pool(history.first);
    }
    template <class H> static auto& pool(H& history) { return *shared_pool(history); }
    /// How many frames in a row it has been given, with the last.
    template <class H> static long long frames(H const& history) {
        if constexpr (requires { history.images; })
            return history.images.counted.frames;
        else if constexpr (requires { history.histories; })
            return frames(std::get<0>(history.histories));
        else if constexpr (requires { history.with; })
            return frames(history.with);
        else if constexpr (requires { history.before; })
            return frames(history.before);
        else
            return frames(history.first);
    }
    template <class H> static auto& first(H& chain) { return chain.first; }
    template <std::size_t i, class H> static auto& link(H& chain) { return std::get<i>(chain.links); }
    template <std::size_t i, class H> static auto& of_pipeline(H& composite) { return std::get<i>(composite.histories); }
};

template <class... Parts> std::true_type a_pipeline(Pipeline<Parts...> const*);
template <class... Ps> std::true_type a_pipeline(Composite<Ps...> const*);
template <class... Ps> std::true_type a_pipeline(Chain<Ps...> const*);
template <class P, class Policy> std::true_type a_pipeline(Resolved<P, Policy> const*);
template <class P, class Judge> std::true_type a_pipeline(ByEvidence<P, Judge> const*);
template <class P> std::true_type a_pipeline(TwoSided<P> const*);
std::false_type a_pipeline(void const*);
template <class... Parts> std::true_type has_stages(Pipeline<Parts...> const*);
template <class... Ps> std::true_type has_stages(Composite<Ps...> const*);
template <class... Ps> std::true_type has_stages(Chain<Ps...> const*);
template <class P, class Judge> std::true_type has_stages(ByEvidence<P, Judge> const*);
template <class P> std::true_type takes_window(TwoSided<P> const*);
template <class First, class... Links>
auto takes_window(Chain<First, Links...> const*) -> decltype(takes_window(static_cast<First const*>(nullptr)));
template <class P, class Policy> auto takes_window(Resolved<P, Policy> const*) -> decltype(takes_window(static_cast<P const*>(nullptr)));
std::false_type takes_window(void const*);
std::false_type has_stages(void const*);
template <class P, class Storage> std::true_type a_history(History<P, Storage> const*);
std::false_type a_history(void const*);
template <class T> inline constexpr bool is_pipeline = decltype(a_pipeline(static_cast<T const*>(nullptr)))::value;
/// Whether a denoiser is given the frames after each one too: a TwoSided, and what stands behind one.
template <class T> inline constexpr bool is_two_sided = decltype(takes_window(static_cast<T const*>(nullptr)))::value;
/// A denoiser whose passes a plan lists: a Pipeline, a Composite, a ByEvidence or a Chain.
template <class T>
concept PlainPipeline = decltype(has_stages(static_cast<T const*>(nullptr)))::value;
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
    void forget() { images.forget(); }

    /// Gives scratch back, and what run() returned: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() { images.release_scratch(); }
    /// Forgets, and gives all memory back.
    void release() { images.release(); }

    /// Counts so far. After a run with a QueueExecutor, such as Cuda, it waits for the frame.
    /// @throws Error where a pass in the queue has failed
    [[nodiscard]] Statistics const& statistics() const {
        images.take_late_counts();
        return images.counted;
    }
    /// Memory of history and scratch, in bytes. Complete after the second frame, or when all frames that are kept are there.
    [[nodiscard]] std::size_t bytes() const { return images.pool->bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(images.size.pixels()); }

    /// View of a channel that a policy keeps (history_length, luminance_variance, ...). Valid after the first frame. One that none keeps
    /// does not compile, and makes a requires-expression false.
    template <ChannelTag C>
        requires(P::keeps::template has<C>)
    [[nodiscard]] auto operator[](C) const { return images.then.kept.template view<Storage, C>(); }
    /// @cond
    template <ChannelTag C, detail::Sentence = "history[channel]: no policy of this pipeline keeps that channel">
        requires(!P::keeps::template has<C>)
    void operator[](C) const = delete; // history[channel]: no policy of this pipeline keeps that channel
    /// @endcond

private:
    friend struct detail::OpenHistory;
    friend struct detail::Inspect;
    template <class, ImageStorage> friend class History;

    detail::HistoryImages images;
    std::shared_ptr<detail::DiagnosisNotes> notes; ///< of quell::diagnose

    explicit History(std::shared_ptr<detail::ImagePool> shared) : images{std::move(shared), detail::counts_in<MemoryOf<Storage>>()} {}
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
