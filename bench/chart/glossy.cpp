#include "chart_presets.hpp"

void quell::bench::chart_glossy(ChartRequest const& request) {
    auto const effect = request.what.effect == "curved" ? tracer::Effect::curved : tracer::Effect::glossy;
    chart_presets(request, glossy, {effect});
}
