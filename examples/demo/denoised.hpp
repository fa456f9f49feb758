#pragma once

#include <quell/execute/threads.hpp>
#include <quell/quell.hpp>

namespace quell::examples {

/// What the demo runs: the whole image as one signal.
inline constexpr auto denoise = presets::svgf(radiance, Demodulate{});
using Denoise = std::remove_const_t<decltype(denoise)>;
using DemoFrame = Frame<Denoise::reads>;

/// Fills the frame with frame `number` of the scene that the tracer stands at.
struct DemoDenoiser {
    History<Denoise> history;
    Threads<> threads;

    explicit DemoDenoiser(Extent size, int thread_count);
    /// The denoised image, valid until the next frame, and the milliseconds that it took.
    double run(DemoFrame const& frame);
    ViewOf<Planar<>, Radiance> result;
};

} // namespace quell::examples
