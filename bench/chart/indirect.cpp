#include "chart_presets.hpp"

void quell::bench::chart_indirect(Job const& job) {
    chart_presets(job, indirect, {tracer::Effect::indirect}, {}, Charted{"dual-cone", presets::dual_cone(indirect)}.in_half());
}
