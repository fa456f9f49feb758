#pragma once

#include "channels.hpp"
#include "core/scenes.hpp"
#include "denoise/denoiser.hpp"
#include "pictures.hpp"

namespace quell::live {

constexpr int traced_only = -1; ///< a preset's number

/// What the reader of the page has chosen, for one frame.
struct View {
    int scene = 0;             ///< number
    int preset = 0;            ///< number; traced_only: what is traced is denoised elsewhere
    int samples = 1;           ///< per pixel
    Moment at;                 ///< time and light
    float yaw = 0, pitch = 0;  ///< radians
    float distance = 3;        ///< of the camera from its target
    bool anti_aliased = false; ///< whether edges are smoothed, over frames whose samples lie elsewhere in the pixels
};

/// Traces and denoises frame by frame, and keeps what is compared: noisy, denoised, and the mean of many samples.
class Session {
    Extent size;
    TracedFrame frame;
    Planar<>::Image<3> denoised;
    std::vector<Vector> sums; // of the reference
    int samples_in_sums = 0;
    uint32_t frame_number = 0, reference_number = 0;
    int preset = -1;
    std::unique_ptr<Denoiser> denoiser, smoother;
    TracedFrame denoised_frame; // what the smoother takes
    ScreenPoint jitter, jitter_then;
    View last;
    bool has_last = false;
    std::vector<PassTime> times;
    Scene scene;
    Cameras cameras;

public:
    double trace_seconds = 0, denoise_seconds = 0; ///< of the last frame

    explicit Session(Extent size);
    /// The next frame.
    void advance(View const& view);
    /// Adds so many samples to the reference of the last frame. The first ones replace those of frames before.
    void refine(int samples);
    /// Starts the reference anew.
    void clear_reference() { samples_in_sums = 0; }
    [[nodiscard]] int reference_samples() const { return samples_in_sums; }
    /// A picture's colours.
    [[nodiscard]] Vector colour(Picture picture, int x, int y) const;
    [[nodiscard]] Extent extent() const { return size; }
    /// What was traced, and where what was denoised elsewhere goes to.
    [[nodiscard]] TracedFrame const& traced() const { return frame; }
    [[nodiscard]] Planar<>::Image<3>& result() { return denoised; }
    /// Smooths the edges of what was denoised, if the last view is anti-aliased. advance() does so, but for what is denoised elsewhere.
    void smooth();
    /// Where the samples of the last frame lie, and of the one before it, from the pixels' middles.
    [[nodiscard]] ScreenPoint jitter_now() const { return jitter; }
    [[nodiscard]] ScreenPoint jitter_before() const { return jitter_then; }
    [[nodiscard]] std::vector<PassTime> const& pass_times() const { return times; }

private:
    /// Calls task(x, y) for all pixels, on all threads.
    void for_each_pixel(auto const& task) const;
    void add_to_sum(int x, int y, Vector radiance, int samples, bool starts);
    void trace(int samples);
    void choose(int number);
};

} // namespace quell::live
