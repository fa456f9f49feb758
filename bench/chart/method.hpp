#pragma once

#include <quell/execute/threads.hpp>
#include <quell/metrics/picture.hpp>
#include <quell/quell.hpp>
#include <tracer/frame_sink.hpp>
#include <tracer/mask.hpp>
#include <tracer/reference.hpp>

#include <ctime>
#include <memory>
#include <string>
#include <vector>

namespace quell::bench {

/// One way to denoise an effect, at work on a sequence. The picture is the effect's share of the image: direct * visibility, glossy, or
/// albedo * indirect.
template <class FrameT> class Method {
public:
    explicit Method(std::string name_) : name(std::move(name_)) {}
    virtual ~Method() = default;
    virtual metrics::Picture run(FrameT const& frame) = 0;
    [[nodiscard]] virtual double bytes_per_pixel() const = 0;

    std::string name;
    std::vector<double> milliseconds; ///< of each frame
};

template <class FrameT, class P> class MethodOf final : public Method<FrameT> {
    Composite<P> pipeline;
    History<Composite<P>> history;
    Threads<> threads;

public:
    MethodOf(std::string name, P const& p, Extent size, int thread_count)
        : Method<FrameT>(std::move(name)), pipeline(p), history(size, pipeline), threads{.count = thread_count} {}

    metrics::Picture run(FrameT const& frame) override {
        auto const begin = now();
        auto const view = quell::run(pipeline, frame, history, threads);
        this->milliseconds.push_back(1e3 * (now() - begin));
        metrics::Picture picture{frame.size, {}};
        picture.pixels.reserve(static_cast<std::size_t>(frame.size.pixels()));
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x) picture.pixels.emplace_back(view.get(0, x, y), view.get(1, x, y), view.get(2, x, y));
        return picture;
    }
    [[nodiscard]] double bytes_per_pixel() const override { return history.bytes_per_pixel(); }

private:
    static double now() {
        timespec t{};
        clock_gettime(CLOCK_MONOTONIC, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    }
};

template <class FrameT> using Methods = std::vector<std::unique_ptr<Method<FrameT>>>;

/// What the command line says.
struct ChartOptions {
    std::string scene = "fence", effect = "shadow";
    Extent size{480, 270};
    int frames = 41;
    int threads = 0;
    double tolerance = 0.01; ///< of the references: mean FLIP between two independent halves
    bool every_scored_frame = true;
};

} // namespace quell::bench
