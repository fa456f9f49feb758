#pragma once

#include "channels.hpp"
#include "core/scenes.hpp"
#include "denoiser.hpp"
#include "pictures.hpp"

namespace quell::live {

/// What the reader of the page has chosen, for one frame.
struct View {
    int scene = 0;             ///< number
    int preset = 0;            ///< number; -1: what is traced is denoised elsewhere
    int samples = 1;           ///< per pixel
    Moment at;                 ///< time and light
    float yaw = 0, pitch = 0;  ///< radians
    float distance = 3;        ///< of the camera from its target
    bool anti_aliased = false; ///< whether edges are smoothed, over frames whose samples lie elsewhere in the pixels

    /// Whether nothing has moved.
    [[nodiscard]] bool shows_the_same_as(View const& other) const {
        return scene == other.scene && at.time == other.at.time && at.light == other.at.light && yaw == other.yaw && pitch == other.pitch &&
               distance == other.distance;
    }
    [[nodiscard]] Camera camera(Extent size) const {
        auto orbit = first_orbit(scene);
        orbit.yaw = yaw, orbit.pitch = pitch, orbit.distance = distance;
        return camera_of(within_reach(scene, orbit), size.width, size.height);
    }
};

/// A number from 0 to 1, far from those of the numbers before: the digits of `n` to a base, the other way round.
inline float halton(uint32_t n, uint32_t base) {
    float value = 0, digit = 1;
    for (; n > 0; n /= base) digit /= static_cast<float>(base), value += digit * static_cast<float>(n % base);
    return value;
}
inline ScreenPoint place_in_pixel(uint32_t number) { return {halton(number, 2) - 0.5f, halton(number, 3) - 0.5f}; }

/// Traces and denoises frame by frame, and keeps what is compared: noisy, denoised, and the mean of many samples.
class Session {
    std::vector<Vector> sums; // of the reference
    uint32_t frame_number = 0, reference_number = 0;
    int preset = -1;
    std::unique_ptr<Denoiser> denoiser, smoother;
    TracedFrame denoised_frame; // what the smoother takes
    View last;
    bool has_last = false;
    Scene scene;
    Cameras cameras;

public:
    Extent const size;
    TracedFrame frame;                 ///< what was traced
    Planar<>::Image<3> denoised;       ///< where what is denoised elsewhere goes to, too
    int reference_samples = 0;         ///< 0: the reference starts anew
    ScreenPoint jitter, jitter_before; ///< where the samples of the last frame lie, and of the one before it, from the pixels' middles
    std::vector<PassTime> times;       ///< of the last frame
    double trace_seconds = 0, denoise_seconds = 0; ///< of the last frame

    explicit Session(Extent s) : sums(static_cast<std::size_t>(s.pixels())), denoised_frame(s), size(s), frame(s), denoised(s) {}

    /// The next frame.
    void advance(View const& view) {
        bool const is_cut = !has_last || view.scene != last.scene;
        if (view.preset != preset) preset = view.preset, denoiser = make_denoiser(preset, size);
        if (is_cut && denoiser) denoiser->forget();
        auto const& before = is_cut ? view : last;
        if (is_cut || !view.shows_the_same_as(last)) reference_samples = 0;
        jitter_before = jitter, jitter = view.anti_aliased ? place_in_pixel(1 + frame_number % 16) : ScreenPoint{};
        if (is_cut) jitter_before = jitter;
        frame.camera.jitter = {jitter.x, jitter.y};
        if (!view.anti_aliased || is_cut) smoother.reset(); // it starts anew
        scene = moving_scene(view.scene, view.at, before.at);
        cameras = {view.camera(size), before.camera(size)};
        double const start = seconds_now();
        trace(view.samples);
        double const traced = seconds_now();
        last = view, has_last = true;
        times.clear();
        if (denoiser) {
            denoiser->run(frame, denoised);
            times = denoiser->times;
            smooth();
        }
        trace_seconds = traced - start, denoise_seconds = seconds_now() - traced;
    }

    /// Smooths the edges of what was denoised, if the last view is anti-aliased. advance() does so, but for what is denoised elsewhere.
    void smooth() {
        if (!last.anti_aliased) return;
        if (!smoother) smoother = make_anti_aliasing(size);
        denoised_frame.camera.jitter = frame.camera.jitter;
        auto const copy = [&](auto const& from, auto& to) { for_each_pixel([&](int x, int y) { to.set(x, y, from.get(x, y)); }); };
        copy(denoised, denoised_frame[radiance]), copy(frame[depth], denoised_frame[depth]), copy(frame[motion], denoised_frame[motion]);
        smoother->run(denoised_frame, denoised);
        times.insert(times.end(), smoother->times.begin(), smoother->times.end());
    }

    /// Adds so many samples to the reference of the last frame. The first ones replace those of frames before.
    void refine(int samples) {
        // Numbers that no frame has.
        Tracing tracing{.samples = samples, .frame = 0x80000000u + ++reference_number};
        if (last.anti_aliased) tracing.jitter = place_in_pixel(reference_number);
        for_each_pixel(
            [&](int x, int y) { add_to_sum(x, y, radiance_of(scene, seen_at(scene, cameras, tracing, x, y), tracing, x, y), samples); });
        reference_samples += samples;
    }

    /// A picture's colours.
    [[nodiscard]] Vector colour(Picture picture, int x, int y) const {
        if (picture == Picture::noisy) return vector_of(frame[radiance].get(x, y));
        if (picture == Picture::denoised) return vector_of(denoised.get(x, y));
        return sums[static_cast<std::size_t>(y * size.width + x)] * (reference_samples > 0 ? 1 / static_cast<float>(reference_samples) : 0);
    }

private:
    static Vector vector_of(glm::vec3 a) { return {a.x, a.y, a.z}; }

    /// Calls task(x, y) for all pixels, on all threads.
    void for_each_pixel(auto const& task) const {
        share_rows(0, size.height, [&](int y0, int y1) {
            for (int y = y0; y < y1; ++y)
                for (int x = 0; x < size.width; ++x) task(x, y);
        });
    }
    void add_to_sum(int x, int y, Vector radiance, int samples) {
        auto& sum = sums[static_cast<std::size_t>(y * size.width + x)];
        sum = (reference_samples == 0 ? Vector{} : sum) + radiance * static_cast<float>(samples);
    }
    void trace(int samples) {
        Tracing const tracing{.samples = samples, .frame = ++frame_number, .jitter = jitter};
        auto const views = frame.views(TracedFrame::channels{});
        for_each_pixel([&](int x, int y) {
            TracedPixel(views, x, y).trace(scene, cameras, tracing);
            add_to_sum(x, y, vector_of(frame[radiance].get(x, y)), samples);
        });
        reference_samples += samples;
    }
};

} // namespace quell::live
