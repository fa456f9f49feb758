#include "chart_presets.hpp"

void quell::bench::chart_glossy(Job const& job) {
    auto const effect = job.what.effect == "curved" ? tracer::Effect::curved : tracer::Effect::glossy;
    chart_presets(job, glossy, {effect}, {}, Charted{"glossy", presets::glossy(glossy)}.in_half());
}
