#pragma once

#include "method.hpp"

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>
#include <quell/metrics/stability.hpp>
#include <tracer/gltf/gltf.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <tuple>

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

/// A pipeline to chart, by the name that its row has.
template <class P> struct Named {
    char const* name;
    P pipeline;
};
template <class P> Named(char const*, P) -> Named<P>;

/// The effect's share of the picture, as a Composite puts it together from the denoised signal.
template <ChannelTag Signal> metrics::Picture share(tracer::Reference const& reference) {
    auto picture = reference[Signal{}];
    for_each_channel(typename quell::detail::Share<Signal>::factor{}, [&](auto factor) {
        auto const& pixels = reference[factor].pixels;
        std::ranges::transform(picture.pixels, pixels, picture.pixels.begin(), std::multiplies{});
    });
    return picture;
}

/// Prints a method's row of chart.csv (SCENES.md). Its time is the median after the first eight frames.
template <class FrameT> void print_row(ChartOptions const& options, Method<FrameT> const& method, Errors const& e) {
    auto times = method.milliseconds;
    times.erase(times.begin(), times.begin() + std::min<std::ptrdiff_t>(8, static_cast<std::ptrdiff_t>(times.size()) - 1));
    std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
    double const n = std::max(1, e.frames), k = std::max(1, e.masked_frames);
    std::printf("%s,%s,%s,%d,%d,%d,%d,%.2f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.1f\n", options.scene.c_str(), options.effect.c_str(),
                method.name.c_str(), options.size.width, options.size.height, options.frames, options.threads, times[times.size() / 2],
                e.rmse / n, e.ssim / n, e.flip / n, e.flip_median / n, e.mask_rmse / k, e.mask_ssim / k, e.mask_flip / k,
                e.flicker.frames > 1 ? e.flicker.mean() : 0., method.bytes_per_pixel());
    std::fflush(stdout);
}

/// Runs methods side by side over a scene and prints a row for each. Errors are those of the effect's share of the picture, displayed.
template <ChannelTag Signal, class... Ps>
void chart_methods(ChartOptions const& options, Signal, tracer::Effect effect, Named<Ps> const&... named) {
    using FrameT = Frame<reads_of<Composite<Ps>...>>;
    Methods<FrameT> methods;
    (methods.push_back(std::make_unique<MethodOf<FrameT, Ps>>(named.name, named.pipeline, options.size, options.threads)), ...);
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
            reference = share<Signal>(tracer::reference<Channels<Signal>>(scene, settings, {.tolerance = options.tolerance}));
            mask = tracer::effect_mask(scene, settings, effect);
        }
        for (std::size_t m = 0; m < methods.size(); ++m) {
            auto const picture = methods[m]->run(frame);
            if (score) errors[m].add(i, reference, picture, mask);
        }
    }
    for (std::size_t m = 0; m < methods.size(); ++m) print_row(options, *methods[m], errors[m]);
}

/// The methods that serve any signal.
template <ChannelTag Signal>
constexpr std::tuple baselines{Named{"none", presets::none(Signal{})}, Named{"surface", presets::surface(Signal{})},
                               Named{"surface-clamp", presets::surface_clamp(Signal{})}, Named{"svgf", presets::svgf(Signal{})},
                               Named{"asvgf", presets::asvgf(Signal{})}};

/// Charts the baselines, and the methods that are for this effect only.
/// @param signal visibility, glossy or indirect
template <ChannelTag Signal, class... Ps>
void chart_effect(ChartOptions const& options, Signal signal, tracer::Effect effect, Named<Ps> const&... own) {
    std::apply([&](auto const&... named) { chart_methods(options, signal, effect, named..., own...); }, baselines<Signal>);
}

void chart_shadow(ChartOptions const& options);
void chart_glossy(ChartOptions const& options, bool curved);
void chart_indirect(ChartOptions const& options);

} // namespace quell::bench
