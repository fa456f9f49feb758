#include "chart_effect.hpp"

namespace quell::bench {
namespace {
/// The glossy preset with the virtual image where a flat mirror has it.
constexpr auto with_flat_mirror() {
    return Pipeline{glossy, Temporal{FirstValid{ImageMotion{}, SurfaceMotion{}}, WithMoments{RunningMean{.cap = 4.f}}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>>{.feedback = false}}};
}
} // namespace

void chart_glossy(ChartOptions const& options, bool curved) {
    chart_effect(options, glossy, curved ? tracer::Effect::curved : tracer::Effect::glossy,
                 Named{"mirror-clamp", presets::mirror_clamp(glossy)}, Named{"glossy", presets::glossy(glossy)},
                 Named{"glossy-flat-mirror", with_flat_mirror()}, Named{"glossy-paper", presets::glossy_paper(glossy)});
}

} // namespace quell::bench
