#include "chart_presets.hpp"

void quell::bench::chart_composite(Job const& job) {
    using tracer::Effect;
    chart_presets(job, radiance, {Effect::shadow, Effect::glossy, Effect::indirect}, std::tuple(Demodulate{}),
                  Charted{"trmv", presets::trmv()}.in_half());
}
