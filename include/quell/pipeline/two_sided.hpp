#pragma once

#include <quell/blend/variance_over_time.hpp>
#include <quell/pipeline/unfinished.hpp>
#include <quell/pipeline/window.hpp>

#include <optional>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A pipeline whose pictures are made of the frames before each one, from the history, and of those after it, for offline use. Moving light
/// lags less, and disoccluded pixels have a history too.
///
/// The frames after it are accumulated backwards in time, along motion_next, by the same pipeline. The result of the frames before then
/// enters that run as if it were the frame's samples, so history is forgotten where the light has changed. The spatial filters follow.
///
///     constexpr TwoSided denoise{presets::general(radiance, KnownSamples{}), presets::general_joining(radiance, KnownSamples{})};
///     Frame frame{size, denoise};     History history{size, denoise};
///     auto clean = run(denoise, window, history, Threads{});    // window[0] is denoised, the others follow it
///
/// A call costs one run() and, for each further frame, one accumulate(). Chain, presets::resolve and presets::anti_aliased take one too.
/// @tparam P a pipeline with KnownSamples{} and WithVariance{...RunningMean{}}, as presets::general(radiance, KnownSamples{})
template <class P> struct TwoSided {
    static_assert(P::known_samples::size > 0 && P::keeps::template has<HistoryLength> && P::keeps::template has<LuminanceVariance>,
                  "TwoSided{pipeline, joining}: what several frames have in common counts as several samples: the pipeline needs "
                  "KnownSamples{}, and a Temporal{..., WithVariance{RunningMean{}}}");
    using Output = typename P::Output;                                          ///< channel of the picture
    using reads = decltype(typename P::reads{} | Channels<MotionNext>{});       ///< channels that the host must supply
    static constexpr MotionConvention motion_convention = P::motion_convention; ///< what the host's motion vectors mean: see Supplied
    static constexpr bool needs_camera = P::needs_camera;                       ///< whether frame.camera must be set
    static constexpr bool checks_jitter = P::checks_jitter;                     ///< whether frame.camera.jitter must be in range

    P pipeline; ///< accumulates both sides
    P joining;  ///< joins them. Where light moves, one side lags and the other leads, so that their mean is better than either

    /// @param both accumulates and joins
    constexpr explicit TwoSided(P const& both) : TwoSided(both, both) {}
    /// @param accumulating the pipeline
    /// @param joins        the same pipeline with other numbers, as presets::general_joining
    constexpr TwoSided(P const& accumulating, P const& joins) : pipeline(accumulating), joining(joins) {}
};

/// State between frames of a TwoSided.
template <class P, ImageStorage Storage> class History<TwoSided<P>, Storage> {
public:
    /// @throws Error for a size without pixels
    explicit History(Extent size, TwoSided<P> const& denoiser, Storage const& storage = {})
        : before(size, denoiser.pipeline, storage), after(size, denoiser.pipeline, storage) {}

    /// Drops all history before the next frame.
    void forget() { before.forget(); }
    /// Gives scratch back, what run() returned, and the frames after. The next call takes it again.
    void release_scratch() {
        before.release_scratch();
        after.release();
    }
    /// Counts of the frames before.
    [[nodiscard]] Statistics statistics() const { return before.statistics(); }
    /// Memory of both histories, in bytes.
    [[nodiscard]] std::size_t bytes() const { return before.bytes() + after.bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return before.bytes_per_pixel() + after.bytes_per_pixel(); }

    History<P, Storage> before; ///< the frame that was denoised last, and those before it
    History<P, Storage> after;  ///< the frames after it, accumulated anew in each call
};

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
template <class From, class Length, class Variance, class To, class Count, class ToVariance> struct CopyAccumulated {
    static constexpr auto name = "accumulated";
    From from;
    Length length;
    Variance variance;
    To to;
    Count count;
    ToVariance to_variance;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int pixels) const {
        auto const n = load_pixels<Real>(length, x, y);
        auto const over_time = unbiased_variance(Real(load_pixels<Real>(variance, x, y)), Real(n));
        store_pixels<Real>(to, x, y, load_pixels<Real>(from, x, y), pixels);
        store_pixels<Real>(count, x, y, n, pixels);
        store_pixels<Real>(to_variance, x, y, select(n > Real(1.f), over_time, Real(0.f)), pixels);
    }
};
template <class... Views> CopyAccumulated(Views...) -> CopyAccumulated<Views...>;

template <class P> struct PassesOf<TwoSided<P>> {
    static void append(auto& passes, TwoSided<P> const& denoiser, auto& history) {
        PassesOf<P>::append(passes, denoiser.pipeline, history.before);
        PassesOf<P>::append(passes, denoiser.pipeline, history.before); // the frames after run the same passes
        passes.push_back({.name = "accumulated",
                          .denoises = P::Output::name,
                          .reads = {"signal", HistoryLength::name, LuminanceVariance::name},
                          .writes = {P::Output::name, SampleCount::name, SampleVariance::name}});
        PassesOf<P>::append(passes, denoiser.joining, history.after);
    }
};
template <class P> inline constexpr int kept_frames_of<TwoSided<P>> = kept_frames_of<P>;
template <class P> struct RunOf<TwoSided<P>> {
    template <class W, class Storage, class E, class Into>
    static auto all(TwoSided<P> const& denoiser, W& window, History<TwoSided<P>, Storage>& history, E const& executor, Into const& into) {
        using F = FirstFrame<W>;
        auto& frame = first_frame(window);
        std::size_t last = 0;
        auto const follows = [&](std::size_t i) {
            return window[i].size == frame.size &&
                   (!window[i].number || !window[i - 1].number || *window[i].number == *window[i - 1].number + 1);
        };
        while (last + 1 < std::size(window) && follows(last + 1)) ++last;
        constexpr int whole = StageOrder<P>::count;
        if (last == 0) return run_stages<whole>(denoiser.pipeline, frame, history.before, executor, into);

        for (std::size_t i = 0; i <= last; ++i) check_frame<P>(window[i]); // an error of what is given changes nothing
        Unfinished unfinished(history);
        auto const accumulated = accumulate(denoiser.pipeline, frame, history.before, executor);
        history.after.forget();
        for (auto i = last; i > 0; --i) {
            Exchanged const backwards(window[i][motion], window[i][motion_next]);
            CountedBackwards const number(window[i]);
            accumulate(denoiser.pipeline, window[i], history.after, executor);
        }
        StandIn<F, typename P::Output> const light(frame);
        StandIn<F, SampleCount> const count(frame);
        StandIn<F, SampleVariance> const variance(frame);
        run_or_enqueue(executor, Region{0, 0, frame.size.width, frame.size.height},
                       CopyAccumulated{accumulated, history.before[history_length], history.before[luminance_variance], light.view(),
                                       count.view(), variance.view()});
        submit_queue(executor);
        Exchanged const backwards(frame[motion], frame[motion_next]);
        CountedBackwards const number(frame);
        auto const output = run_stages<whole>(denoiser.joining, frame, history.after, executor, into);
        unfinished.finish();
        return output;
    }
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
