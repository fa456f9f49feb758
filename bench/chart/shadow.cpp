#include "chart_presets.hpp"

void quell::bench::chart_shadow(ChartRequest const& request) { chart_presets(request, visibility, {tracer::Effect::shadow}); }
