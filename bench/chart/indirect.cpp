#include "baselines.hpp"

#include <quell/presets/published.hpp>

void quell::bench::chart_indirect(Job const& job) {
    auto const trust = [](auto& p) -> auto& { return stage<1>(p).motion.rest.trust; };
    auto const cones = Named{"dual-cone", presets::dual_cone(indirect)}
                           .vary(
                               "levels", {1, 2, 3, 4, 5}, [](auto& p) -> auto& { return stage<3>(p).kernel.levels; })
                           .vary(
                               "cap", {4, 8, 16, 24, 48}, [](auto& p) -> auto& { return stage<1>(p).blending.inner.inner.inner.cap; })
                           .vary("trust", {0.1, 0.25, 0.5, 1}, trust);
    auto const colors = vary_guided_atrous<0>(Named{"dual-color", presets::dual_color(indirect)})
                            .vary(
                                "cap", caps, [](auto& p) -> auto& { return stage<0>(p).blending.inner.cap; });
    chart_with_baselines(job, indirect, {tracer::Effect::indirect}, baselines(indirect), colors, cones, cones.in_half());
}
