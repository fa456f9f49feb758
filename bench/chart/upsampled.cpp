#include "chart_presets.hpp"

#include <quell/presets/resolve.hpp>

namespace quell::bench {
namespace {

/// Each frame enlarged by itself: no sample of another one is ever among its depths.
constexpr Resolve<> alone{.depth_tolerance = -2.f};

/// Presets with temporal anti-aliasing behind them, or another way to the output's size.
auto with(std::string const& ending, Resolve<> const& resolve, bool competes) {
    auto const charted = [&](std::string const& name, auto const& pipeline) {
        Charted made{name + ending, presets::resolve(pipeline, resolve)};
        made.competes = competes;
        return made;
    };
    return std::tuple(charted("none", presets::none(radiance)), charted("general", presets::general(radiance, Demodulate{})));
}

} // namespace

void chart_upsampled(ChartRequest const& request) {
    using tracer::Effect;
    tracer::RenderSettings full{.size = request.options.size, .seed = request.options.seed, .threads = request.options.threads};
    full.jitter = tracer::Jitter::pixel; // as the reference, which is of the first feed's frames
    auto const of = [&](int part, tracer::Jitter jitter) {
        auto settings = full;
        settings.size = {(full.size.width + part - 1) / part, (full.size.height + part - 1) / part};
        settings.jitter = jitter;
        return settings;
    };
    chart_feeds(
        request, radiance, {Effect::shadow, Effect::glossy, Effect::indirect},
        Feed{full, std::tuple(Charted{"none", presets::none(radiance)}, Charted{"general", presets::general(radiance, Demodulate{})})},
        Feed{of(1, tracer::Jitter::frame), with("-anti-aliased", {}, true)},
        Feed{of(2, tracer::Jitter::none), with("-half-bicubic", alone, false)},
        Feed{of(2, tracer::Jitter::frame), with("-half-upsampled", {}, true)});
}

} // namespace quell::bench
