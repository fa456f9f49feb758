#pragma once

#include <quell/blend/variance_over_time.hpp>
#include <quell/pipeline/run.hpp>

#include <iterator>
#include <optional>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The channels that frames of a two-sided run need beside the pipeline's.
///
///     Frame frame{size, denoise, two_sided};
struct TwoSided {
    using reads = Channels<MotionNext>;
};
inline constexpr TwoSided two_sided;

/// State between calls of run_two_sided().
/// @tparam P       a pipeline with KnownSamples{} and WithVariance{...RunningMean{}}, as presets::general(radiance, KnownSamples{})
/// @tparam Storage of history and scratch
template <class P, ImageStorage Storage = Planar<>> class TwoSidedHistory {
    static_assert(P::known_samples::size > 0 && P::keeps::template has<HistoryLength> && P::keeps::template has<LuminanceVariance>,
                  "TwoSidedHistory{size, pipeline}: what several frames have in common counts as several samples: the pipeline needs "
                  "KnownSamples{}, and a Temporal{..., WithVariance{RunningMean{}}}");

public:
    /// @throws Error for a size without pixels
    explicit TwoSidedHistory(Extent size, P const& pipeline, Storage const& storage = {})
        : before(size, pipeline, storage), after(size, pipeline, storage) {}

    /// Drops all history before the next frame.
    void forget() { before.forget(); }
    /// Gives scratch back, what run_two_sided() returned, and the frames after. The next call takes it again.
    void release_scratch() {
        before.release_scratch();
        after.release();
    }
    /// Counts of the frames before.
    [[nodiscard]] Statistics const& statistics() const { return before.statistics(); }
    /// Memory of both histories, in bytes.
    [[nodiscard]] std::size_t bytes() const { return before.bytes() + after.bytes(); }

    History<P, Storage> before; ///< the frame that was denoised last, and those before it
    History<P, Storage> after;  ///< the frames after it, accumulated anew in each call
};
template <class P> TwoSidedHistory(Extent, P const&) -> TwoSidedHistory<P>;
template <class P, class Storage> TwoSidedHistory(Extent, P const&, Storage const&) -> TwoSidedHistory<P, Storage>;

namespace detail {
/// Swaps two images for as long as this lives.
template <class Image> class Exchanged {
    Image &a, &b;

public:
    Exchanged(Image& a_, Image& b_) : a(a_), b(b_) { std::swap(a, b); }
    ~Exchanged() { std::swap(a, b); }
    Exchanged(Exchanged const&) = delete;
    Exchanged& operator=(Exchanged const&) = delete;
};

/// An image of quell's own that stands in for one of a frame's for as long as this lives.
template <class F, ChannelTag C> class StandIn {
    using Theirs = ImageOf<typename F::storage, C>;
    using Own = ImageOf<StorageOfCopies<typename F::storage>, C>;
    Own own;
    Theirs &in_frame, theirs;

    Theirs exchanged() {
        if constexpr (std::is_same_v<Own, Theirs>) {
            std::swap(in_frame, own);
            return Theirs();
        } else {
            return std::exchange(in_frame, Theirs::of_copy(own.view()));
        }
    }

public:
    explicit StandIn(F& frame) : own(frame.size), in_frame(frame[C{}]), theirs(exchanged()) {}
    ~StandIn() {
        if constexpr (std::is_same_v<Own, Theirs>)
            std::swap(in_frame, own);
        else
            in_frame = std::move(theirs);
    }
    StandIn(StandIn const&) = delete;
    StandIn& operator=(StandIn const&) = delete;

    /// To be filled.
    [[nodiscard]] auto view() const {
        if constexpr (std::is_same_v<Own, Theirs>)
            return in_frame.view();
        else
            return own.view();
    }
};

/// Negates a frame's number for as long as this lives: frames then follow each other backwards in time.
template <class F> class CountedBackwards {
    F& frame;
    std::optional<long long> const number;

public:
    explicit CountedBackwards(F& f) : frame(f), number(f.number) {
        if (number) frame.number = -*number;
    }
    ~CountedBackwards() { frame.number = number; }
    CountedBackwards(CountedBackwards const&) = delete;
    CountedBackwards& operator=(CountedBackwards const&) = delete;
};

/// Copies the accumulated light of a frame, its number of samples and their variance to images that the backward run reads as its input.
template <class P, class Storage>
void copy_accumulated(ImageView auto const& light, History<P, Storage> const& history, ImageView auto const& to_light,
                      ImageView auto const& to_count, ImageView auto const& to_variance) {
    auto const length = history[history_length];
    auto const variance = history[luminance_variance];
    for (int y = 0; y < light.size.height; ++y)
        for (int x = 0; x < light.size.width; ++x) {
            for (int c = 0; c < P::Output::components; ++c) to_light.set(c, x, y, light.get(c, x, y));
            float const n = length.get(0, x, y);
            to_count.set(0, x, y, n);
            to_variance.set(0, x, y, n > 1.f ? unbiased_variance(variance.get(0, x, y), n) : 0.f);
        }
}
} // namespace detail

namespace detail {
/// A range of frames, by number.
template <class W>
concept Window = requires(W& window) {
    { window[0].size } -> std::convertible_to<Extent>;
    { std::size(window) } -> std::convertible_to<std::size_t>;
};
/// run_two_sided() for frames that are right for it.
template <class P, class W, class Storage, class E>
auto run_window(P const& pipeline, P const& joining, W& window, TwoSidedHistory<P, Storage>& history, E const& executor) {
    using F = std::remove_reference_t<decltype(window[0])>;
    using Output = typename P::Output;
    if (std::size(window) == 0)
        raise_error<Failure>("run_two_sided: the window", "no frames", "give the frame to denoise and those after it");
    std::size_t last = 0;
    auto const follows = [&](std::size_t i) {
        return window[i].size == window[0].size &&
               (!window[i].number || !window[i - 1].number || *window[i].number == *window[i - 1].number + 1);
    };
    while (last + 1 < std::size(window) && follows(last + 1)) ++last;
    auto& frame = window[0];
    if (last == 0) return run(pipeline, frame, history.before, executor);

    auto const accumulated = accumulate(pipeline, frame, history.before, executor);
    history.after.forget();
    for (auto i = last; i > 0; --i) {
        Exchanged const backwards(window[i][motion], window[i][motion_next]);
        CountedBackwards const number(window[i]);
        accumulate(pipeline, window[i], history.after, executor);
    }
    StandIn<F, Output> const light(frame);
    StandIn<F, SampleCount> const count(frame);
    StandIn<F, SampleVariance> const variance(frame);
    copy_accumulated(accumulated, history.before, light.view(), count.view(), variance.view());
    Exchanged const backwards(frame[motion], frame[motion_next]);
    CountedBackwards const number(frame);
    return run(joining, frame, history.after, executor);
}
} // namespace detail

/// Denoises a frame with the frames before it, from the history, and those after it, for offline use. Moving light lags less, and
/// disoccluded pixels have a history too.
///
/// The frames after it are accumulated backwards in time, along motion_next, by the same pipeline. The result of the frames before then
/// enters that run as if it were the frame's samples, so history is forgotten where the light has changed. The spatial filters follow.
///
///     Frame frame{size, denoise, two_sided};     TwoSidedHistory history{size, denoise};
///     auto clean = run_two_sided(denoise, window, history, Threads{});    // window[0] is denoised, the others follow it
///
/// The window ends where frame numbers do not follow each other or the size changes; it may be a single frame. A call costs one run() and,
/// for each further frame, one accumulate(). The frames are changed during the call and restored; images of the host's that they borrow are
/// not written.
/// @param pipeline for accumulating both sides
/// @param joining  the same pipeline, maybe with other numbers, for joining the two sides. Where light moves, one side lags and the other
/// leads, so that their mean is better than either: presets::general_joining
/// @param window   range of frames with operator[], such as std::deque<Frame<...>>; they have MotionNext
/// @param history  state between calls
/// @param executor what runs the passes
/// @throws Error for a window without frames, and as run() does
template <class P, class Window, class Storage, Executor E = Simd>
auto run_two_sided(P const& pipeline, P const& joining, Window& window, TwoSidedHistory<P, Storage>& history, E const& executor = {}) {
    if constexpr (!detail::Window<Window>) {
        static_assert(sizeof(Window) == 0,
                      "run_two_sided(pipeline, window, history): `window` must be a range of frames with operator[], such "
                      "as std::deque<Frame<...>>");
        return detail::NoOutput{};
    } else {
        using F = std::remove_reference_t<decltype(window[0])>;
        constexpr bool has_motion_next = F::channels::template has<MotionNext>,
                       has_copies = !std::is_void_v<detail::StorageOfCopies<typename F::storage>>;
        static_assert(has_motion_next,
                      "run_two_sided(pipeline, window, ...): the frames have no motion_next; construct them with two_sided");
        static_assert(has_copies,
                      "run_two_sided(pipeline, window, ...): the frames must own their memory (Planar<>), or their storage name one "
                      "that does, `Copy`, as Borrowed<> does");
        if constexpr (has_motion_next && has_copies)
            return detail::run_window(pipeline, joining, window, history, executor);
        else
            return detail::NoOutput{};
    }
}
/// The same with `pipeline` for joining as well.
template <class P, class Window, class Storage, Executor E = Simd>
auto run_two_sided(P const& pipeline, Window& window, TwoSidedHistory<P, Storage>& history, E const& executor = {}) {
    return run_two_sided(pipeline, pipeline, window, history, executor);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
