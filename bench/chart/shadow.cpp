#include "baselines.hpp"

#include <quell/presets/published.hpp>

void quell::bench::chart_shadow(Job const& job) {
    auto const alpha = [](auto& p) -> auto& { return stage<3>(p).blending.inner.inner.inner.inner.alpha; };
    auto const shadow = Named{"shadow", presets::shadow(visibility)}
                            .vary(
                                "radius", {3, 7, 15, 25}, [](auto& p) -> auto& { return stage<2>(p).kernel.radius; })
                            .vary("alpha", {0.05, 0.1, 0.2, 0.4, 0.6}, alpha)
                            .vary(
                                "sigmas", {0.5, 1, 2, 3}, [](auto& p) -> auto& { return stage<3>(p).blending.range.sigmas; });
    chart_with_baselines(job, visibility, {tracer::Effect::shadow}, baselines(visibility), shadow, shadow.in_half(),
                         Named{"shadow-paper", presets::shadow_paper(visibility)});
}
