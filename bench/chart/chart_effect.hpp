#pragma once

#include "method.hpp"

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>
#include <quell/metrics/stability.hpp>
#include <tracer/gltf/gltf.hpp>

#include <algorithm>
#include <cstdio>

namespace quell::bench {

/// Sums over the scored frames of one method.
struct Errors {
    double rmse = 0, ssim = 0, flip = 0, flip_median = 0, mask_rmse = 0, mask_ssim = 0, mask_flip = 0;
    int frames = 0, masked_frames = 0;
    metrics::Flicker flicker;

    void add(int frame, metrics::Picture const& reference, metrics::Picture const& output, metrics::Mask const& mask) {
        auto const wanted = metrics::displayed(reference), shown = metrics::displayed(output);
        auto const difference = metrics::flip(wanted, shown);
        rmse += metrics::rmse(wanted, shown), ssim += metrics::ssim(wanted, shown);
        flip += difference.mean(), flip_median += difference.weighted_median(), ++frames;
        if (std::ranges::any_of(mask, [](auto m) { return m != 0; })) {
            mask_rmse += metrics::rmse(wanted, shown, mask), mask_ssim += metrics::ssim(wanted, shown, mask);
            mask_flip += difference.mean(mask), ++masked_frames;
        }
        if (frame >= 31 && frame <= 34) flicker.add(wanted, shown);
    }
};

/// Runs all methods side by side over a scene and prints a row of chart.csv for each (SCENES.md). Errors are those of the effect's share of
/// the picture, displayed.
/// @tparam FrameT  with every channel that any of the methods reads
/// @tparam Signals of the reference: Visibility, Glossy or Indirect
/// @param share makes the effect's share of the picture from the reference's pictures
template <class FrameT, ChannelTag Signal>
void chart_effect(ChartOptions const& options, tracer::Effect effect, Methods<FrameT> methods,
                  metrics::Picture (*share)(tracer::Reference const&)) {
    tracer::PreparedScene scene(tracer::open_scene(options.scene));
    FrameT frame(options.size);
    std::vector<Errors> errors(methods.size());
    std::vector<int> const scored = options.every_scored_frame ? std::vector{24, 28, 31, 32, 33, 34, 36, 40} : std::vector{24, 32, 40};
    for (int i = 0; i < options.frames; ++i) {
        tracer::RenderSettings settings{.size = options.size, .frame = i, .threads = options.threads};
        tracer::FrameSink<FrameT> sink{frame};
        tracer::render<typename FrameT::channels>(scene, settings, sink);
        frame.camera = scene.description().camera_at(static_cast<float>(i), options.size);
        frame.number = i;
        bool const score = std::ranges::find(scored, i) != scored.end();
        metrics::Picture reference;
        metrics::Mask mask;
        if (score) {
            reference = share(tracer::reference<Channels<Signal>>(scene, settings, {.tolerance = options.tolerance}));
            mask = tracer::effect_mask(scene, settings, effect);
        }
        for (std::size_t m = 0; m < methods.size(); ++m) {
            auto const picture = methods[m]->run(frame);
            if (score) errors[m].add(i, reference, picture, mask);
        }
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
        auto const& e = errors[m];
        auto& times = methods[m]->milliseconds;
        times.erase(times.begin(), times.begin() + std::min<std::ptrdiff_t>(8, static_cast<std::ptrdiff_t>(times.size()) - 1));
        std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
        double const n = std::max(1, e.frames), k = std::max(1, e.masked_frames);
        std::printf("%s,%s,%s,%d,%d,%d,%d,%.2f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.1f\n", options.scene.c_str(),
                    options.effect.c_str(), methods[m]->name.c_str(), options.size.width, options.size.height, options.frames,
                    options.threads, times[times.size() / 2], e.rmse / n, e.ssim / n, e.flip / n, e.flip_median / n, e.mask_rmse / k,
                    e.mask_ssim / k, e.mask_flip / k, e.flicker.frames > 1 ? e.flicker.mean() : 0., methods[m]->bytes_per_pixel());
        std::fflush(stdout);
    }
}

/// Adds a method to a list.
template <class FrameT, class P> void add(Methods<FrameT>& methods, ChartOptions const& options, std::string name, P const& pipeline) {
    methods.push_back(std::make_unique<MethodOf<FrameT, P>>(std::move(name), pipeline, options.size, options.threads));
}

void chart_shadow(ChartOptions const& options);
void chart_glossy(ChartOptions const& options, bool curved);
void chart_indirect(ChartOptions const& options);

} // namespace quell::bench
