#include "small_chart.hpp"

#include "chart/chart_effect.hpp"

#include <cstdlib>

void quell::bench::chart_small(ChartOptions const& options) {
    ::setenv("QUELL_CACHE", (options.out / "cache").c_str(), 1);
    Charted const surface{"surface", presets::surface(visibility)};
    tracer::RenderSettings const rendered{.size = options.size, .seed = options.seed, .threads = options.threads};
    Feed const feed{rendered, std::tuple(Charted{"none", presets::none(visibility)}, surface)};
    Feed const scored_only{rendered, std::tuple(Charted{"input", presets::none(visibility)}), true};
    Results results(options);
    for (auto const& what : options.cases)
        chart_feeds(ChartRequest{options, what, [](std::string const&) {}, results}, visibility, {tracer::Effect::shadow}, feed,
                    scored_only);
}
