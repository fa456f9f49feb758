#pragma once

#include "method.hpp"

#include <quell/execute/threads.hpp>
#include <quell/quell.hpp>
#include <tracer/trace_frame.hpp>

#include <chrono>

namespace quell::examples {

/// Frames of a pipeline's own, with the noisy image too, to be shown beside the clean one; their histories; and what comes out.
template <class P> class Denoised {
    using Rendered = Frame<decltype(typename P::reads{} | Channels<Radiance>{})>;
    P pipeline;
    Rendered rendered;
    History<P> history;
    Threads<> threads;

public:
    double milliseconds = 0;

    Denoised(P const& p, DemoOptions const& options)
        : pipeline(p), rendered(options.size), history(options.size, p), threads{.count = options.threads} {}

    [[nodiscard]] metrics::Picture frame(tracer::PreparedScene& scene, tracer::RenderSettings const& settings) {
        tracer::trace_frame(scene, settings, rendered);
        auto const begin = std::chrono::steady_clock::now();
        auto const clean = run(pipeline, rendered, history, threads);
        milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        return metrics::picture_of(clean);
    }
    [[nodiscard]] metrics::Picture noisy() const { return metrics::picture_of(rendered[radiance].view()); }
    [[nodiscard]] double bytes_per_pixel() const { return history.bytes_per_pixel(); }
};

} // namespace quell::examples
