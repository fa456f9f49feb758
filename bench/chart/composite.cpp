#include "chart_presets.hpp"

void quell::bench::chart_composite(ChartRequest const& request) {
    using tracer::Effect;
    chart_presets(request, radiance, {Effect::shadow, Effect::glossy, Effect::indirect}, Demodulate{});
}
