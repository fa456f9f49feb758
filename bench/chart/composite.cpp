#include "baselines.hpp"

void quell::bench::chart_composite(Job const& job) {
    using tracer::Effect;
    Named const trmv{"trmv", presets::trmv()};
    chart_with_baselines(job, radiance, {Effect::shadow, Effect::glossy, Effect::indirect}, baselines(radiance, Demodulate{}), trmv,
                         trmv.in_half());
}
