#include "chart_effect.hpp"

namespace quell::bench {
namespace {
metrics::Picture share(tracer::Reference const& r) { return r[glossy]; }

/// The glossy preset with the virtual image where a flat mirror has it.
constexpr auto with_flat_mirror() {
    return Pipeline{glossy, Temporal{FirstValid{ImageMotion{}, SurfaceMotion{}}, WithMoments{RunningMean{.cap = 4.f}}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>>{.feedback = false}}};
}
} // namespace

void chart_glossy(ChartOptions const& options, bool curved) {
    using FrameT =
        Frame<reads_of<decltype(presets::glossy(glossy)), decltype(presets::glossy_paper(glossy)), decltype(presets::asvgf(glossy))>>;
    Methods<FrameT> methods;
    add(methods, options, "none", presets::none(glossy));
    add(methods, options, "surface", presets::surface(glossy));
    add(methods, options, "surface-clamp", presets::surface_clamp(glossy));
    add(methods, options, "mirror-clamp", presets::mirror_clamp(glossy));
    add(methods, options, "svgf", presets::svgf(glossy));
    add(methods, options, "asvgf", presets::asvgf(glossy));
    add(methods, options, "glossy", presets::glossy(glossy));
    add(methods, options, "glossy-flat-mirror", with_flat_mirror());
    add(methods, options, "glossy-paper", presets::glossy_paper(glossy));
    chart_effect<FrameT, Glossy>(options, curved ? tracer::Effect::curved : tracer::Effect::glossy, std::move(methods), share);
}

} // namespace quell::bench
