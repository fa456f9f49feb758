// quell-fit: the smallest composition of pipelines that keeps a sequence to a bound, as a header:
//   quell-fit --scene fence --rmse 0.05 --out fit.hpp
//   quell-fit --in 'dir/frame.%04d.exr' --reference 'dir/reference.%04d.exr' --ms 20 --out fit.hpp
// References of scenes are cached in ~/.cache/quell.
#include "contenders.hpp"
#include "fit.hpp"

#include <quell/io/replace_file.hpp>
#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <tracer/scenes/scenes.hpp>

#include <fstream>
#include <iostream>

namespace {

using namespace quell::bench;

std::vector<Contender> all_contenders() {
    std::vector<Contender> all;
    for (auto const& some : {rest_contenders(), blur_contenders(), shadow_contenders(), glossy_contenders(), indirect_contenders()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

void fit_and_write(FitOptions const& options) {
    if (!options.out.empty()) quell::examples::make_folder_for(options.out);
    auto const contenders = all_contenders();
    auto const sequence = options.scene.empty() ? file_sequence(options) : scene_sequence(options);
    std::ofstream nowhere;
    auto const fitted = fit(*sequence, contenders, options, options.quiet ? nowhere : std::cout);
    if (options.out.empty()) return;
    quell::io::replace_file(options.out, header_text(fitted.composition, fitted.origin));
}

} // namespace

int main(int argc, char** argv) {
    return quell::examples::exit_code_of("quell-fit", [&] {
        auto const options = fit_options(argc, argv);
        if (options.wants_help) return;
        if (!options.list) return fit_and_write(options);
        for (auto const& name : quell::tracer::scene_names()) std::cout << name << '\n';
    });
}
