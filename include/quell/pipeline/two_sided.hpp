#pragma once

#include <quell/blend/variance_over_time.hpp>
#include <quell/pipeline/run.hpp>

#include <iterator>
#include <optional>
#include <utility>

namespace quell {

/// What frames need beside a pipeline's channels to be used from both sides: Frame frame{size, denoise, two_sided};
struct TwoSided {
    using reads = Channels<MotionNext>;
};
inline constexpr TwoSided two_sided;

/// The state between frames that are denoised by frames before and after them: see run_two_sided().
/// @tparam P       a pipeline with KnownSamples{} and WithVariance{...RunningMean{}}, as presets::general(radiance, KnownSamples{})
/// @tparam Storage of history and scratch
template <class P, ImageStorage Storage = Planar<>> class TwoSidedHistory {
    static_assert(P::known_samples::size > 0 && P::keeps::template has<HistoryLength> && P::keeps::template has<LuminanceVariance>,
                  "TwoSidedHistory{size, pipeline}: what several frames have in common counts as several samples: the pipeline needs "
                  "KnownSamples{}, and a Temporal{..., WithVariance{RunningMean{}}}");

public:
    /// @throws Error for a size of no pixels
    explicit TwoSidedHistory(Extent size, P const& pipeline, Storage const& storage = {})
        : before(size, pipeline, storage), after(size, pipeline, storage) {}

    /// Starts afresh at the next frame.
    void forget() { before.forget(); }
    [[nodiscard]] Statistics const& statistics() const { return before.statistics(); }
    [[nodiscard]] std::size_t bytes() const { return before.bytes() + after.bytes(); }

    History<P, Storage> before; ///< of the frame that was denoised last and of those before it
    History<P, Storage> after;  ///< of those after it; made anew for each frame
};
template <class P> TwoSidedHistory(Extent, P const&) -> TwoSidedHistory<P>;
template <class P, class Storage> TwoSidedHistory(Extent, P const&, Storage const&) -> TwoSidedHistory<P, Storage>;

namespace detail {
/// Two images of a frame, exchanged for as long as this lives.
template <class Image> class Exchanged {
    Image &a, &b;

public:
    Exchanged(Image& a_, Image& b_) : a(a_), b(b_) { std::swap(a, b); }
    ~Exchanged() { std::swap(a, b); }
    Exchanged(Exchanged const&) = delete;
    Exchanged& operator=(Exchanged const&) = delete;
};

/// A frame's number as it is counted backwards in time.
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

/// Copies what a history shows of a frame, and of how many samples of which variance, to where the pipeline finds it when it runs
/// backwards.
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

/// Denoises a frame with those before it, which the history knows, and those after it: for files, where nobody waits. The frames after it
/// are accumulated backwards in time, along their motion to the next frame, by the same pipeline; what they show of this frame is joined
/// with what the frames before show as if it were one more history, so that it is forgotten where the light has changed; then comes the
/// rest of the pipeline. Light that moves is followed with less lag, and what has
/// just been uncovered has a history as well.
///     Frame frame{size, denoise, two_sided};     TwoSidedHistory history{size, denoise};
///     auto clean = run_two_sided(denoise, window, history, Threads{});    // window[0] is denoised, the others follow it
/// Frames whose numbers don't follow each other end the window; one frame is a window too. Each call does the work of run() and, for every
/// further frame, of accumulate(). The frames are changed while this runs, and left as they were.
/// @param joining the same pipeline, with other numbers if that is better for joining what comes before with what comes after: where light
/// moves, the one lags and the other leads, so that their mean is less wrong than either (presets::general_joining)
/// @param window any range of frames by index, such as std::deque<Frame<...>>, which own their memory and have MotionNext
/// @throws Error for a window of no frames, and as run() does
template <class P, class Window, class Storage, Executor E = Simd>
auto run_two_sided(P const& pipeline, P const& joining, Window& window, TwoSidedHistory<P, Storage>& history, E const& executor = {}) {
    using F = std::remove_reference_t<decltype(window[0])>;
    using FrameStorage = typename F::storage;
    using Light = typename P::Output;
    static_assert(F::channels::template has<MotionNext>,
                  "run_two_sided(pipeline, window, ...): the frames have no motion_next; construct them with two_sided");
    static_assert(owns_memory<FrameStorage>(), "run_two_sided(pipeline, window, ...): the frames must own their memory (Planar<>)");
    if (std::size(window) == 0) throw Error("run_two_sided: the window", "no frames", "give the frame to denoise and those after it");
    std::size_t last = 0;
    auto const follows = [&](std::size_t i) {
        return window[i].size == window[0].size &&
               (!window[i].number || !window[i - 1].number || *window[i].number == *window[i - 1].number + 1);
    };
    while (last + 1 < std::size(window) && follows(last + 1)) ++last;
    auto& frame = window[0];
    if (last == 0) return run(pipeline, frame, history.before, executor);

    auto const light = accumulate(pipeline, frame, history.before, executor);
    history.after.forget();
    for (auto i = last; i > 0; --i) {
        detail::Exchanged const backwards(window[i][motion], window[i][motion_next]);
        detail::CountedBackwards const number(window[i]);
        accumulate(pipeline, window[i], history.after, executor);
    }
    ImageOf<FrameStorage, Light> known_light(frame.size);
    ImageOf<FrameStorage, SampleCount> known_count(frame.size), known_variance(frame.size);
    detail::copy_accumulated(light, history.before, known_light.view(), known_count.view(), known_variance.view());
    detail::Exchanged const of_light(frame[Light{}], known_light);
    detail::Exchanged const of_count(frame[sample_count], known_count);
    detail::Exchanged const of_variance(frame[sample_variance], known_variance);
    detail::Exchanged const backwards(frame[motion], frame[motion_next]);
    detail::CountedBackwards const number(frame);
    return run(joining, frame, history.after, executor);
}
template <class P, class Window, class Storage, Executor E = Simd>
auto run_two_sided(P const& pipeline, Window& window, TwoSidedHistory<P, Storage>& history, E const& executor = {}) {
    return run_two_sided(pipeline, pipeline, window, history, executor);
}

} // namespace quell
