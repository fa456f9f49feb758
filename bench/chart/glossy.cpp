#include "baselines.hpp"

#include <quell/presets/published.hpp>

namespace quell::bench {
void chart_glossy(Job const& job) {
    auto const effect = job.what.effect == "curved" ? tracer::Effect::curved : tracer::Effect::glossy;
    auto const own = vary_guided_atrous<1>(Named{"glossy", presets::glossy(glossy)})
                         .vary(
                             "cap", caps, [](auto& p) -> auto& { return stage<1>(p).blending.inner.inner.cap; });
    chart_with_baselines(job, glossy, {effect}, baselines(glossy), Named{"mirror-clamp", presets::mirror_clamp(glossy)}, own, own.in_half(),
                         Named{"glossy-flat-mirror", presets::glossy<FlatMirror>(glossy)},
                         Named{"glossy-paper", presets::glossy_paper(glossy)});
}

} // namespace quell::bench
