#pragma once

#include "contest.hpp"
#include "external.hpp"
#include "results.hpp"

#include <quell/io/frame_image.hpp>
#include <support/progress.hpp>
#include <tracer/gltf/gltf.hpp>
#include <tracer/mask.hpp>
#include <tracer/reference.hpp>

#include <exception>
#include <functional>

namespace quell::bench {

/// What an effect's chart is asked for.
struct ChartRequest {
    ChartOptions const& options;
    SceneEffect const& what;
    std::function<void(std::string const& doing)> const& progress; ///< called before each frame and each reference
    Results& results;
};

/// The effect's share of the picture, as a Composite puts it together from the denoised signal.
template <ChannelTag Signal> metrics::Picture share(tracer::Reference const& reference, Signal signal) {
    auto picture = reference[signal];
    for_each_channel(typename quell::detail::Share<Signal>::factor{}, [&](auto factor) {
        auto const& pixels = reference[factor].pixels;
        std::ranges::transform(picture.pixels, pixels, picture.pixels.begin(), std::multiplies{});
    });
    return picture;
}

/// The pixels that any of these effects touches.
inline metrics::Mask mask_of(tracer::PreparedScene& scene, tracer::RenderSettings const& settings,
                             std::vector<tracer::Effect> const& effects) {
    metrics::Mask sum(static_cast<std::size_t>(settings.size.pixels()), 0);
    for (auto const effect : effects)
        std::ranges::transform(sum, tracer::effect_mask(scene, settings, effect), sum.begin(), [](int a, int b) { return (a | b) != 0; });
    return sum;
}

/// What the scored frames should be, and where the effects are in them.
template <ChannelTag Signal>
std::vector<Wanted> wanted_frames(ChartRequest const& request, Signal signal, tracer::PreparedScene& scene, tracer::RenderSettings settings,
                                  std::vector<tracer::Effect> const& effects) {
    settings.seed = 0; // the same for any noise
    // What moves is a small part of some blurred pictures; indirect light takes a hundred times the samples.
    bool const slow = std::ranges::find(effects, tracer::Effect::indirect) != effects.end();
    double const usual = settings.shutter > 0 ? 0.005 : slow ? 0.03 : 0.01;
    std::vector<Wanted> all;
    for (int const frame : request.options.scored_frames()) {
        request.progress("reference of frame " + std::to_string(frame));
        settings.frame = frame;
        auto const reference = tracer::reference<Channels<Signal>>(
            scene, settings, {.tolerance = request.options.tolerance > 0 ? request.options.tolerance : usual});
        all.push_back({frame, metrics::displayed(share(reference, signal)), mask_of(scene, settings, effects)});
    }
    return all;
}

/// A frame as quell-trace writes it. R, G, B are the effect's noisy share of the picture.
template <ChannelTag Signal, class FrameT> io::ExrImage image_of(tracer::PreparedScene const& scene, FrameT const& frame, Signal) {
    auto image = io::image_of(frame);
    io::put_camera(image, scene.description().camera_at(static_cast<float>(*frame.number - 1), frame.size), "_previous");
    if constexpr (!FrameT::channels::template has<Radiance>) {
        auto const none = whole(presets::none(Signal{}));
        History<std::remove_const_t<decltype(none)>> history(frame.size, none);
        io::put(image, radiance, quell::run(none, frame, history));
    }
    return image;
}

/// Renders the sequence and runs all methods on it, side by side. What other programs get are the first contest's frames.
template <class FrameT>
void run_contests(ChartRequest const& request, ChannelTag auto signal, tracer::PreparedScene& scene, std::vector<Contest<FrameT>>& contests,
                  Judge const& judge, ExternalRuns& others) {
    auto const& options = request.options;
    FrameT frame(options.size);
    for (int i = 0; i < options.frames; ++i) {
        request.progress("frame " + std::to_string(i));
        for (auto& contest : contests) {
            if (contest.scored_frames_only && !options.scores(i)) continue;
            if (!(frame.size == contest.rendered.size)) frame = FrameT(contest.rendered.size);
            contest.render(scene, i, frame);
            if (!options.externals.empty() && &contest == &contests.front()) others.write(i, image_of(scene, frame, signal));
            contest.run(frame, options.scores(i) ? &judge : nullptr);
        }
    }
}

/// Charts the methods of all feeds over a scene. Errors are those of the effect's share of the picture, displayed. Reference and masks
/// are those of the first feed's frames.
template <ChannelTag Signal, class... Feeds>
void chart_feeds(ChartRequest const& request, Signal signal, std::vector<tracer::Effect> const& effects, Feeds const&... feeds) {
    // Albedo and so on are what other programs expect.
    using FrameT = Frame<decltype(reads_of<Feeds...>{} | Channels<Albedo, Normal, Depth, Motion>{})>;
    std::vector<Contest<FrameT>> contests;
    (contests.emplace_back(request.options, feeds), ...);
    tracer::PreparedScene scene(tracer::open_scene(request.what.scene));
    SceneEffect const shown{std::filesystem::path(request.what.scene).stem().string(), request.what.effect};
    Judge const judge(request.options, shown, wanted_frames(request, signal, scene, contests.front().rendered, effects),
                      request.options.pictured_frame());
    ExternalRuns others;
    run_contests(request, signal, scene, contests, judge, others);
    std::vector<Row> rows;
    for (auto const& contest : contests) contest.put_rows(judge, rows);
    std::exception_ptr failed;
    try {
        for (auto const& external : request.options.externals) {
            request.progress(external.name);
            rows.push_back(others.run(external, judge));
        }
    } catch (...) { // of another program: what was charted before is kept
        failed = std::current_exception();
    }
    request.results.add(std::move(rows));
    if (failed) std::rethrow_exception(failed);
}

void chart_shadow(ChartRequest const& request);
void chart_glossy(ChartRequest const& request); ///< curved too
void chart_indirect(ChartRequest const& request);
void chart_blur(ChartRequest const& request);
void chart_composite(ChartRequest const& request);
void chart_upsampled(ChartRequest const& request); ///< frames of half the width and height beside those of the whole

} // namespace quell::bench
