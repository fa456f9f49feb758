#include "chart_effect.hpp"

namespace quell::bench {
namespace {
metrics::Picture share(tracer::Reference const& r) {
    auto picture = r[direct];
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i] *= r[visibility].pixels[i];
    return picture;
}
} // namespace

void chart_shadow(ChartOptions const& options) {
    using FrameT =
        Frame<decltype(Channels<Direct>{} | reads_of<decltype(presets::shadow(visibility)), decltype(presets::asvgf(visibility))>{})>;
    Methods<FrameT> methods;
    add(methods, options, "none", presets::none(visibility));
    add(methods, options, "surface", presets::surface(visibility));
    add(methods, options, "surface-clamp", presets::surface_clamp(visibility));
    add(methods, options, "svgf", presets::svgf(visibility));
    add(methods, options, "asvgf", presets::asvgf(visibility));
    add(methods, options, "shadow", presets::shadow(visibility));
    add(methods, options, "shadow-paper", presets::shadow_paper(visibility));
    chart_effect<FrameT, Visibility>(options, tracer::Effect::shadow, std::move(methods), share);
}

} // namespace quell::bench
