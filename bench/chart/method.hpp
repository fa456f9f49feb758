#pragma once

#include "charted.hpp"
#include "judge.hpp"

#include <quell/execute/threads.hpp>
#include <quell/metrics/picture.hpp>
#include <quell/quell.hpp>
#include <support/median.hpp>

#include <chrono>
#include <memory>

namespace quell::bench {

/// One way to denoise an effect, at work on a sequence.
template <class FrameT> class Method {
public:
    virtual ~Method() = default;
    /// The effect's share of the picture, linear.
    virtual metrics::Picture run(FrameT const& frame) = 0;
    [[nodiscard]] virtual double bytes_per_pixel() const = 0;

    /// The middle time of those from first_timed on; unknown where there is none.
    [[nodiscard]] double ms_per_frame() const { return examples::median(milliseconds); }

protected:
    std::vector<double> milliseconds;
};

template <class FrameT, class Whole> class MethodOf final : public Method<FrameT> {
    Whole pipeline;
    History<Whole> history;
    Threads<> threads;

public:
    MethodOf(Whole const& p, ChartOptions const& options)
        : pipeline(p), history(options.size, pipeline), threads{.count = options.threads} {}

    metrics::Picture run(FrameT const& frame) override {
        auto const begin = std::chrono::steady_clock::now();
        auto const view = quell::run(pipeline, frame, history, threads);
        std::chrono::duration<double, std::milli> const taken = std::chrono::steady_clock::now() - begin;
        if (frame.number >= ChartOptions::first_timed) this->milliseconds.push_back(taken.count());
        return metrics::picture_of(view);
    }
    [[nodiscard]] double bytes_per_pixel() const override { return history.bytes_per_pixel(); }
};

} // namespace quell::bench
