#include "chart_presets.hpp"

void quell::bench::chart_indirect(ChartRequest const& request) { chart_presets(request, indirect, {tracer::Effect::indirect}); }
