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

/// Methods, and how the frames are rendered that they get.
template <class... Ps> struct Feed {
    using reads = reads_of<Composite<Ps>...>;
    tracer::RenderSettings rendered; ///< but for the frame's number
    std::tuple<Named<Ps>...> methods;
    bool scored_frames_only = false; ///< for what has no history and whose time doesn't matter
};
template <class... Ps> Feed(tracer::RenderSettings, std::tuple<Named<Ps>...>, bool = false) -> Feed<Ps...>;

/// A feed's methods at work, and how they do.
template <class FrameT> struct Contest {
    tracer::RenderSettings rendered;
    bool scored_frames_only;
    Methods<FrameT> methods{};
    std::vector<Errors> errors{};

    template <class... Ps>
    Contest(ChartOptions const& options, Feed<Ps...> const& feed)
        : rendered(feed.rendered), scored_frames_only(feed.scored_frames_only), errors(sizeof...(Ps)) {
        auto const add = [&]<class P>(Named<P> const& named) {
            methods.push_back(std::make_unique<MethodOf<FrameT, P>>(named.name, named.pipeline, options.size, options.threads));
        };
        std::apply([&](auto const&... named) { (add(named), ...); }, feed.methods);
    }

    /// Renders a frame and lets the methods denoise it; `judge(errors, picture)` is called with what each has made.
    void run(tracer::PreparedScene& scene, int number, FrameT& frame, auto const& judge) {
        auto settings = rendered;
        settings.frame = number;
        tracer::FrameSink<FrameT> sink{frame};
        tracer::render<typename FrameT::channels>(scene, settings, sink);
        frame.camera = scene.description().camera_at(static_cast<float>(number), frame.size);
        frame.number = number;
        for (std::size_t m = 0; m < methods.size(); ++m) judge(errors[m], methods[m]->run(frame));
    }
};

/// Runs the methods of all feeds side by side over a scene and prints a row for each. Errors are those of the effect's share of the
/// picture, displayed; reference and mask are those of the first feed's frames.
template <ChannelTag Signal, class... Feeds>
void chart_feeds(ChartOptions const& options, Signal, tracer::Effect effect, Feeds const&... feeds) {
    using FrameT = Frame<reads_of<Feeds...>>;
    std::vector<Contest<FrameT>> contests;
    (contests.emplace_back(options, feeds), ...);
    tracer::PreparedScene scene(tracer::open_scene(options.scene));
    FrameT frame(options.size);
    std::vector<int> const scored = options.every_scored_frame ? std::vector{24, 28, 31, 32, 33, 34, 36, 40} : std::vector{24, 32, 40};
    for (int i = 0; i < options.frames; ++i) {
        bool const score = std::ranges::find(scored, i) != scored.end();
        metrics::Picture reference;
        metrics::Mask mask;
        if (score) {
            auto settings = contests.front().rendered;
            settings.frame = i;
            reference = share<Signal>(tracer::reference<Channels<Signal>>(scene, settings, {.tolerance = options.tolerance}));
            mask = tracer::effect_mask(scene, settings, effect);
        }
        for (auto& contest : contests)
            if (score || !contest.scored_frames_only)
                contest.run(scene, i, frame, [&](Errors& errors, metrics::Picture const& picture) {
                    if (score) errors.add(i, reference, picture, mask);
                });
    }
    for (auto const& contest : contests)
        for (std::size_t m = 0; m < contest.methods.size(); ++m) print_row(options, *contest.methods[m], contest.errors[m]);
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
    Feed const feed{{.size = options.size, .threads = options.threads}, std::tuple_cat(baselines<Signal>, std::tuple(own...))};
    chart_feeds(options, signal, effect, feed);
}

void chart_shadow(ChartOptions const& options);
void chart_glossy(ChartOptions const& options, bool curved);
void chart_indirect(ChartOptions const& options);
void chart_blur(ChartOptions const& options);

} // namespace quell::bench
