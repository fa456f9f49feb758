#pragma once

#include <quell/pipeline/run.hpp>

#include <cstdint>
#include <iterator>
#include <limits>
#include <math.h>
#include <string>
#include <utility>
#include <vector>

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

/// Copies what `before` knows of a frame to where the pipeline finds it when it runs backwards.
struct AccumulatedSamples {
    template <class Accumulated, class Kept, class Light, class Scalar>
    static void copy(Accumulated const& light, Kept const& length, Kept const& variance, Light& to_light, Scalar& to_count,
                     Scalar& to_variance) {
        constexpr int components = Accumulated::components;
        for (int y = 0; y < light.size.height; ++y)
            for (int x = 0; x < light.size.width; ++x) {
                for (int c = 0; c < components; ++c) to_light.view().set(c, x, y, light.get(c, x, y));
                float const n = length.get(0, x, y);
                to_count.view().set(0, x, y, n);
                // Of n samples; the variance of one of many.
                to_variance.view().set(0, x, y, n > 1.f ? variance.get(0, x, y) * n / max(n - 1.f, 0.5f) : 0.f);
            }
    }
};
} // namespace detail

/// Denoises a frame with those before it, which the history knows, and those after it: for files, where nobody waits. The frames after it
/// are accumulated backwards in time, along their motion to the next frame, by the same pipeline; what they show of this frame is joined
/// with what the frames before show as if it were one more history, so that it is forgotten where the light has changed; then comes the
/// rest of the pipeline. Half of the lag goes, and half of the noise where things have just been uncovered.
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
    detail::AccumulatedSamples::copy(light, history.before[history_length], history.before[luminance_variance], known_light, known_count,
                                     known_variance);
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

namespace detail {
/// Lets every pixel of the next frame say where it was to the pixels within `reach` of there that aren't taken.
template <ImageView To, ImageView NextMotion, ImageView NextDepth>
void splat_motion(To const& to, NextMotion const& next_motion, NextDepth const& next_depth, float reach, std::vector<std::uint8_t>& taken) {
    auto const width = static_cast<std::size_t>(to.size.width);
    struct Offer {
        float depth = std::numeric_limits<float>::infinity(), distance = 4.f;
    };
    std::vector<Offer> best(taken.size());
    auto const offer = [&](int x, int y, float dx, float dy, Offer const& now) {
        auto const i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        if (taken[i] == 1) return;
        auto& so_far = best[i];
        // Of one surface, that which comes closest to the pixel's centre; of two, the one in front.
        bool const in_front = now.depth < so_far.depth * 0.95f,
                   same = now.depth <= so_far.depth * 1.05f || (!is_finite(now.depth) && !is_finite(so_far.depth));
        if (!in_front && !(same && now.distance < so_far.distance)) return;
        so_far = now;
        to.set(0, x, y, dx), to.set(1, x, y, dy);
    };
    for (int y = 0; y < to.size.height; ++y)
        for (int x = 0; x < to.size.width; ++x) {
            float const dx = next_motion.get(0, x, y), dy = next_motion.get(1, x, y), z = next_depth.get(0, x, y);
            if (!is_finite(dx) || !is_finite(dy) || abs(dx) > 1e6f || abs(dy) > 1e6f) continue;
            float const u = static_cast<float>(x) + dx, v = static_cast<float>(y) + dy;
            int const left = static_cast<int>(::floorf(u)), top = static_cast<int>(::floorf(v));
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 2; ++i) {
                    int const column = left + i, row = top + j;
                    float const off_x = abs(u - static_cast<float>(column)), off_y = abs(v - static_cast<float>(row));
                    bool const inside = column >= 0 && row >= 0 && column < to.size.width && row < to.size.height;
                    if (inside && off_x <= reach && off_y <= reach) offer(column, row, -dx, -dy, {z, off_x * off_x + off_y * off_y});
                }
        }
    for (std::size_t i = 0; i < taken.size(); ++i)
        if (best[i].distance < 4.f) taken[i] = 1;
}
} // namespace detail

/// Motion to the next frame where a renderer gives none: the next frame's motion to this one, turned round. Every pixel of the next frame
/// says where it was; of several that were in one pixel, the nearest to the camera counts. Where nothing was (it is hidden in the next
/// frame) the motion is not finite, and there is no history from that side.
/// @param to is this frame's motion_next
/// @param next_motion, next_depth the next frame's, of the same size
template <ImageView To, ImageView NextMotion, ImageView NextDepth>
void invert_motion(To const& to, NextMotion const& next_motion, NextDepth const& next_depth) {
    static_assert(To::components == 2 && NextMotion::components == 2 && NextDepth::components == 1,
                  "invert_motion(to, next_motion, next_depth): motion has two components and depth has one");
    if (!(to.size == next_motion.size && to.size == next_depth.size))
        throw Error("invert_motion", to_string(to.size) + ", " + to_string(next_motion.size) + " and " + to_string(next_depth.size),
                    "give images of one size");
    auto const nowhere = std::numeric_limits<float>::quiet_NaN();
    for (int y = 0; y < to.size.height; ++y)
        for (int x = 0; x < to.size.width; ++x) to.set(0, x, y, nowhere), to.set(1, x, y, nowhere);
    // What comes to lie in a pixel first; then, for pixels that nothing came to lie in since things grow, what comes within a pixel.
    std::vector<std::uint8_t> taken(static_cast<std::size_t>(to.size.pixels()), 0);
    for (float const reach : {0.5f, 0.99f}) detail::splat_motion(to, next_motion, next_depth, reach, taken);
}

} // namespace quell
