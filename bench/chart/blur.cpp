#include "chart_effect.hpp"

namespace quell::bench {
namespace {
/// Get one sample per pixel, each at a time of its own.
constexpr std::tuple denoisers{
    Named{"none", presets::none(radiance)}, Named{"blur", presets::blur(radiance)}, Named{"blur-bent", presets::blur<BentPaths>(radiance)},
    Named{"blur-fixed-step", presets::blur_fixed_step(radiance)}, Named{"blur-one-step", presets::blur_one_step(radiance)}};
/// Get a picture of the middle of the open shutter.
constexpr std::tuple post_processes{Named{"gather-blur", presets::gather_blur(radiance)},
                                    Named{"tilemax-blur", presets::tilemax_blur(radiance)}};
} // namespace

void chart_blur(ChartOptions const& options) {
    tracer::RenderSettings const blurred{.size = options.size, .threads = options.threads, .shutter = 0.5f};
    auto frozen = blurred;
    frozen.frozen_at = 0.5f;
    auto const input = [&](int samples, char const* name) {
        auto settings = blurred;
        settings.samples_per_pixel = samples;
        return Feed{settings, std::tuple(Named{name, presets::none(radiance)}), true};
    };
    chart_feeds(options, radiance, tracer::Effect::blur, Feed{blurred, denoisers}, Feed{frozen, post_processes}, input(4, "none-4spp"),
                input(8, "none-8spp"), input(16, "none-16spp"));
}

} // namespace quell::bench
