#include "chart_effect.hpp"

namespace quell::bench {
namespace {
metrics::Picture share(tracer::Reference const& r) {
    auto picture = r[indirect];
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i] *= r[albedo].pixels[i];
    return picture;
}
} // namespace

void chart_indirect(ChartOptions const& options) {
    using FrameT =
        Frame<decltype(Channels<Albedo>{} | reads_of<decltype(presets::dual_cone(indirect)), decltype(presets::asvgf(indirect))>{})>;
    Methods<FrameT> methods;
    add(methods, options, "none", presets::none(indirect));
    add(methods, options, "surface", presets::surface(indirect));
    add(methods, options, "surface-clamp", presets::surface_clamp(indirect));
    add(methods, options, "svgf", presets::svgf(indirect));
    add(methods, options, "asvgf", presets::asvgf(indirect));
    add(methods, options, "dual-color", presets::dual_color(indirect));
    add(methods, options, "dual-cone", presets::dual_cone(indirect));
    chart_effect<FrameT, Indirect>(options, tracer::Effect::indirect, std::move(methods), share);
}

} // namespace quell::bench
