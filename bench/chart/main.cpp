// quell-chart: what each method costs and how close it comes, on every scene and effect:
//   quell-chart --scene all --size 480x270 --out out/chart      writes chart.csv, chart.svg and index.html
//   quell-chart --scene fence --few --tolerance 0.02 --sweep    three frames scored; presets with one number changed too
// References and masks are cached in ~/.cache/quell.
#include "chart_effect.hpp"

#include <support/program.hpp>
#include <tracer/scenes/scenes.hpp>

#include <iostream>

namespace {

using namespace quell::bench;

void chart(Job const& job) {
    auto const& effect = job.what.effect;
    if (effect == "shadow") return chart_shadow(job);
    if (effect == "indirect") return chart_indirect(job);
    if (effect == "blur") return chart_blur(job);
    if (effect == "composite") return chart_composite(job);
    chart_glossy(job);
}

void chart_all(ChartOptions const& options) {
    for (auto const& what : options.cases) static_cast<void>(quell::tracer::open_scene(what.scene)); // a misspelt name shows at once
    Results results(options);
    auto const steps = static_cast<int>(options.scored_frames().size()) + options.frames + static_cast<int>(options.externals.size());
    quell::examples::Progress bar("quell-chart", static_cast<long long>(options.cases.size()) * steps, !options.quiet);
    long long done = 0;
    for (auto const& what : options.cases)
        chart({options, what, [&](std::string const& doing) { bar.show(done++, what.scene + " " + what.effect + " " + doing); }, results});
}

} // namespace

int main(int argc, char** argv) {
    return quell::examples::exit_code_of("quell-chart", [&] {
        auto const options = chart_options(argc, argv);
        if (options.wants_help) return;
        if (!options.list) return chart_all(options);
        for (auto const& name : quell::tracer::scene_names()) std::cout << name << '\n';
    });
}
