#include "chart_presets.hpp"

void quell::bench::chart_shadow(Job const& job) {
    chart_presets(job, visibility, {tracer::Effect::shadow}, {}, Charted{"shadow", presets::shadow(visibility)}.in_half());
}
