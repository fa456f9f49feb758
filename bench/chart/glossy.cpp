#include "baselines.hpp"

namespace quell::bench {
namespace {
/// The glossy preset with the virtual image where a flat mirror has it.
constexpr auto with_flat_mirror() {
    return Pipeline{glossy, Temporal{FirstValid{ImageMotion{}, SurfaceMotion{}}, WithMoments{RunningMean{.cap = 4.f}}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>>{.feedback = false}}};
}
} // namespace

void chart_glossy(Job const& job) {
    auto const effect = job.what.effect == "curved" ? tracer::Effect::curved : tracer::Effect::glossy;
    auto const own = vary_guided_atrous<0>(Named{"glossy", presets::glossy(glossy)})
                         .vary(
                             "cap", caps, [](auto& p) -> auto& { return stage<0>(p).blending.inner.cap; });
    chart_with_baselines(job, glossy, {effect}, baselines(glossy), Named{"mirror-clamp", presets::mirror_clamp(glossy)}, own, own.in_half(),
                         Named{"glossy-flat-mirror", with_flat_mirror()}, Named{"glossy-paper", presets::glossy_paper(glossy)});
}

} // namespace quell::bench
