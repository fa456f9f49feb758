// quell-chart: what each method costs and how close it comes, on every scene and effect:
//   quell-chart --scene all --size 480x270 --out out/chart      writes chart.csv and index.html
//   quell-chart --scene fence --few --tolerance 0.02            three frames scored
//   quell-chart --in 'dir/frame_%04d.exr' --reference 'dir/reference_%04d.exr'       quell-denoise's presets on files of any renderer
// References and masks are cached in ~/.cache/quell.
#include "chart_effect.hpp"
#include "file_sequence.hpp"

#include <support/program.hpp>
#include <tracer/scenes/scenes.hpp>

#include <iostream>

namespace {

using namespace quell::bench;

void chart(ChartRequest const& request) {
    auto const& effect = request.what.effect;
    if (effect == "shadow") return chart_shadow(request);
    if (effect == "indirect") return chart_indirect(request);
    if (effect == "blur") return chart_blur(request);
    if (effect == "composite") return chart_composite(request);
    if (effect == "upsampled") return chart_upsampled(request);
    chart_glossy(request);
}

void chart_all(ChartOptions const& options) {
    for (auto const& what : options.cases) static_cast<void>(quell::tracer::open_scene(what.scene)); // a misspelt name shows at once
    auto const sequences = file_sequences(options);
    Results results(options);
    auto const steps = static_cast<int>(options.scored_frames().size()) + options.frames + static_cast<int>(options.externals.size());
    auto all_steps = static_cast<long long>(options.cases.size()) * steps;
    for (auto const& sequence : sequences) all_steps += sequence.steps();
    quell::examples::Progress bar("quell-chart", all_steps, !options.quiet);
    long long done = 0;
    for (auto const& what : options.cases)
        chart({options, what, [&](std::string const& doing) { bar.show(done++, what.scene + " " + what.effect + " " + doing); }, results});
    for (auto const& sequence : sequences)
        chart_files(
            options, sequence, [&](std::string const& doing) { bar.show(done++, sequence.scene + " " + doing); }, results);
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
