#pragma once

#include <denoise/denoiser.hpp>

#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/quell.hpp>

namespace quell::examples {

/// @tparam Storage of the history
template <class P, ImageStorage Storage = Planar<>> class DenoiserOf final : public Denoiser {
    P pipeline;
    Frame<typename P::reads> frame;
    History<P, Storage> history;
    Threads<> threads;

public:
    DenoiserOf(P const& p, Extent size, int thread_count) : pipeline(p), frame(size), history(size, p), threads{thread_count} {}

    std::vector<std::string> planes(io::ChannelNames const& names) const override { return io::planes_of(typename P::reads{}, names); }

    metrics::Picture denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number) override {
        if (P::needs_camera && !io::camera_of(image))
            throw Error(image.name, "it has no camera, which this preset needs",
                        "write the 4x4 attributes quell:view and quell:projection, or choose another preset");
        if (!(frame.size == image.size)) frame = Frame<typename P::reads>(image.size);
        io::load(frame, image, names);
        frame.number = number;
        return picture(quell::run(pipeline, frame, history, threads));
    }
    long long missing_samples() const override { return history.statistics().missing_samples; }

private:
    /// Signals of one component become grey.
    metrics::Picture picture(ImageView auto const& out) const {
        constexpr int last = P::Output::components - 1;
        metrics::Picture result{frame.size, {}};
        result.pixels.reserve(static_cast<std::size_t>(frame.size.pixels()));
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x)
                result.pixels.emplace_back(out.get(0, x, y), out.get(std::min(1, last), x, y), out.get(std::min(2, last), x, y));
        return result;
    }
};

/// A preset from a function without state that makes its pipeline: preset("atrous", [] { return presets::atrous(radiance); }).
template <ImageStorage Storage = Planar<>, class Make> Preset preset(std::string name, Make) {
    return {std::move(name), [](Extent size, int threads) -> std::unique_ptr<Denoiser> {
                constexpr auto pipeline = Make{}();
                return std::make_unique<DenoiserOf<std::remove_const_t<decltype(pipeline)>, Storage>>(pipeline, size, threads);
            }};
}

} // namespace quell::examples
