// error: image.set(x, y, value): put the components in braces, set(x, y, {r, g, b})
// error: image.set(x, y, value): `value` must have as many components as the channel
// error: image.set(x, y, {...}): there must be as many numbers in the braces as the channel has components
// error: image.set(x, y, value): a Borrowed image is read only
// error: run(pipeline, frame, history, executor): it takes a pipeline, a frame and a history, in that order
// error: run(pipeline, frame, history, executor): `history` must be a variable that is not const
// error: run(pipeline, frame, history, executor): `executor` must have for_each_pixel(region, job)
// error: run(pipeline, frame, history, executor): there are too many arguments
// error: run(pipeline, frame, history): the history is another pipeline's
// error: accumulate(pipeline, frame, history, executor): it takes a pipeline, a frame and a history, in that order
// error: run_into(target, pipeline, frame, history, executor): it takes a view, a pipeline, a frame and a history, in that order
// error: run_into(target, pipeline, frame, history, executor): `target` must be a view of an image
// error: Frame{size, pipelines..., storage}: the size comes first
// error: Frame{size, pipelines..., storage}: what follows the size must be pipelines, and a storage
// error: History{size, pipeline, storage}: it takes an Extent{width, height}, a pipeline, and maybe a storage
// error: Pipeline{channel, options..., stages...}: the channel of the signal comes first
// error: run(denoiser, window, history): `window` must be a range of frames with operator[]
// error: run(pipeline, frame, ...): the frame lacks a channel that the pipeline reads; construct the frame with this pipeline
// error: run_into(target, pipeline, frame, ...): the frame lacks a channel that the pipeline reads; construct the frame with this pipeline
// error: run_into(target, pipeline, frame, ...): the target has another number of components than the pipeline's signal
// error: History<P, Storage>: what quell remembers needs memory of its own
// error: what several frames have in common counts as several samples
#include <quell/pipeline/two_sided.hpp>
#include <quell/quell.hpp>

#include <vector>
using namespace quell;

#ifdef CORRECT
#define CALL(right, ...) right
#else
#define CALL(right, ...) __VA_ARGS__
#endif

constexpr auto denoise = presets::surface(radiance);
constexpr auto other = presets::surface_clamp(radiance);
constexpr Extent size{8, 8};
constexpr Temporal temporal{SurfaceMotion{}, RunningMean{}};

/// A storage that kernels cannot write.
struct ReadOnly {
    using Exact = ReadOnly;
    template <int N> struct Image {
        explicit Image(Extent) {}
        struct View {
            static constexpr int components = N;
            Extent size;
            float get(int, int, int) const { return 0; }
        };
        View view() const { return {}; }
    };
};

void set(Frame<Channels<Radiance, Depth>>& frame, Borrowed<>::Image<3>& borrowed) {
    auto& colour = frame[radiance];
    CALL(colour.set(0, 0, {1.f, 2.f, 3.f}), colour.set(0, 0, 1.f, 2.f, 3.f));
    CALL(colour.set(0, 0, {1, 2.0, 3.f}), colour.set(0, 0, 1.f));
    CALL(colour.set(0, 0, glm::vec3(1.f)), colour.set(0, 0, glm::vec4(1.f))); // a vec3 of it would lack alpha
    CALL(colour.set(0, 0, {glm::vec2(1.f), 1.f}), colour.set(0, 0, {1.f, 2.f}));
    CALL(frame[depth].set(0, 0, 1), frame[depth].set(0, 0, glm::vec3(1.f)));
    CALL(frame[depth].set(0, 0, {1.f}), frame[depth].set(0, 0, {1.f, 2.f}));
    CALL(static_cast<void>(borrowed.get(0, 0)), borrowed.set(0, 0, glm::vec3(1.f)));
}
void run_them(Frame<Channels<Radiance, Motion, Depth, Normal>>& frame, Planar<>::Image<3> picture) {
    History history{size, denoise};
    auto const& fixed = history;
    static_cast<void>(fixed);
    CALL(run(denoise, frame, history), run(frame, history, denoise));
    CALL(run(denoise, frame, history), run(denoise, frame));
    CALL(run(denoise, frame, history), run(denoise, frame, &history));
    CALL(run(denoise, frame, history), run(denoise, frame, fixed));
    CALL(run(denoise, frame, history), run(denoise, frame, History{size, denoise}));
    CALL(run(denoise, frame, history, Serial{}), run(denoise, frame, history, 4));
    CALL(run(denoise, frame, history, Serial{}), run(denoise, frame, history, Serial{}, 4));
    CALL(run(denoise, frame, history), run(other, frame, history));
    CALL(accumulate(denoise, frame, history), accumulate(frame, history, denoise));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(denoise, frame, history, picture.view()));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(picture, denoise, frame, history));
    // These are right: a pixel and a component, of what run() returns and of images.
    static_cast<void>(run(denoise, frame, history).get(0, 0).x + run(denoise, frame, history).get(2, 0, 0));
    static_cast<void>(frame[radiance].get(0, 0).x + frame[radiance].get(2, 0, 0) + frame[depth].get(0, 0));
}
void run_on_a_frame_that_lacks_channels(Frame<Channels<Radiance, Motion, Depth, Normal>>& frame, Planar<>::Image<3>& picture) {
    Frame<Channels<Radiance>> bare{size};
    static_cast<void>(bare);
    History history{size, denoise};
    CALL(run(denoise, frame, history), run(denoise, bare, history));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(picture.view(), denoise, bare, history));
    Planar<>::Image<1> grey{size};
    static_cast<void>(grey);
    CALL(run_into(picture.view(), denoise, frame, history), run_into(grey.view(), denoise, frame, history));
}
void run_with_later_frames() {
    constexpr TwoSided general{presets::general(radiance, KnownSamples{})};
    std::vector<decltype(Frame{size, general})> window{Frame{size, general}};
    History history{size, general};
    CALL(run(general, window, history), run(general, window[0], history));
}
void construct() {
    CALL((History{size, denoise}), History{size, denoise, Borrowed<>{}});
    CALL((TwoSided{presets::general(radiance, KnownSamples{})}), TwoSided{presets::general(radiance)});
    CALL((Frame{size, denoise}), Frame{denoise, size});
    CALL((Frame{size, denoise}), Frame{8, 8, denoise});
    CALL((Frame{size, denoise, Planar<Float16>{}}), Frame{size, denoise, ReadOnly{}});
    CALL((Frame{size, denoise}), Frame{size, 3});
    CALL((History{size, denoise}), History{denoise, size});
    CALL((History{size, denoise}), History{size});
    CALL((History{size, denoise}), History{size, SurfaceMotion{}});
    CALL((History{size, denoise, Planar<Float16>{}}), History{size, denoise, ReadOnly{}});
    CALL((Pipeline{radiance, temporal}), Pipeline{temporal, radiance});
    CALL(presets::general(radiance, Demodulate{}), presets::general(Demodulate{}, radiance));
}
