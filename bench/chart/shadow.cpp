#include "chart_effect.hpp"

void quell::bench::chart_shadow(ChartOptions const& options) {
    chart_effect(options, visibility, tracer::Effect::shadow, Named{"shadow", presets::shadow(visibility)},
                 Named{"shadow-paper", presets::shadow_paper(visibility)});
}
