#pragma once

#include <quell/execute/threads.hpp>
#include <quell/quell.hpp>

namespace quell::examples {

/// What the demo runs: every effect by its own pipeline. The frame has the noisy image too, to be shown beside the clean one.
inline constexpr auto denoise = presets::trmv();
using Denoise = std::remove_const_t<decltype(denoise)>;
using DemoFrame = Frame<decltype(Denoise::reads{} | Channels<Radiance>{})>;

/// The pipelines with their histories.
struct DemoDenoiser {
    History<Denoise> history;
    Threads<> threads;

    explicit DemoDenoiser(Extent size, int thread_count);
    /// The denoised image, valid until the next frame, and the milliseconds that it took.
    double run(DemoFrame const& frame);
    ViewOf<Planar<>, Radiance> result;
};

} // namespace quell::examples
