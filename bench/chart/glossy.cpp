#include "baselines.hpp"

namespace quell::bench {
namespace {
/// The glossy preset with the virtual image where a flat mirror has it.
constexpr auto with_flat_mirror() {
    using Forgetful = ForgetChanged<RunningMean>;
    return Pipeline{glossy, Spatial{ChangeDetector<>{.levels = 1}},
                    Temporal{FirstValid{ImageMotion{}, SurfaceMotion{}}, WithMoments{Forgetful{{.cap = 4.f}, 2.f, 0.3f}}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>>{.feedback = false}}};
}
} // namespace

void chart_glossy(Job const& job) {
    auto const effect = job.what.effect == "curved" ? tracer::Effect::curved : tracer::Effect::glossy;
    auto const own = vary_guided_atrous<1>(Named{"glossy", presets::glossy(glossy)})
                         .vary(
                             "cap", caps, [](auto& p) -> auto& { return stage<1>(p).blending.inner.inner.cap; });
    chart_with_baselines(job, glossy, {effect}, baselines(glossy), Named{"mirror-clamp", presets::mirror_clamp(glossy)}, own, own.in_half(),
                         Named{"glossy-flat-mirror", with_flat_mirror()}, Named{"glossy-paper", presets::glossy_paper(glossy)});
}

} // namespace quell::bench
