#include "chart_effect.hpp"

void quell::bench::chart_indirect(ChartOptions const& options) {
    chart_effect(options, indirect, tracer::Effect::indirect, Named{"dual-color", presets::dual_color(indirect)},
                 Named{"dual-cone", presets::dual_cone(indirect)});
}
