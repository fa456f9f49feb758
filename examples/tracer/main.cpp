// quell-trace: renders scenes to sequences of EXR files, with exactly the channels that the chosen effects need.

#include "effects.hpp"
#include "options.hpp"
#include "scenes/scenes.hpp"
#include "sequence_writer.hpp"

#include <support/output_folder.hpp>
#include <support/program.hpp>

#include <iostream>

using namespace quell;
using namespace quell::tracer;

namespace {

void print(std::string const& scene, TraceOptions const& options, RayCounts const& rays) {
    std::cout << scene << ": " << options.frames << " frames of " << to_string(options.rendered.size) << "; rays: " << rays.primary
              << " primary, " << rays.shadow << " shadow, " << rays.glossy << " glossy, " << rays.indirect << " indirect" << std::endl;
}

void trace_all(TraceOptions const& options) {
    auto const folders = examples::folders_of_scenes(options.out, options.scenes);
    std::vector<SceneDescription> scenes; // all of them, before the first is rendered: a misspelt name shows at once
    for (auto const& name : options.scenes) {
        scenes.push_back(open_scene(name, options.camera));
        if (options.primary_only) scenes.back().secondary_rays = false;
    }
    for (auto const& folder : folders) examples::make_output_folder(folder);
    examples::Progress progress("quell-trace", static_cast<long long>(scenes.size()) * options.frames, !options.quiet);
    long long done = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        SequenceWriter sequence{options, std::move(scenes[i]), folders[i], progress, done};
        auto const rays = with_channels([&](char const* effect) { return options.has(effect); },
                                        [&]<class Wanted>(Wanted) { return sequence.trace<Wanted>(); });
        if (!options.quiet) print(options.scenes[i], options, rays);
    }
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("quell-trace", [&] {
        auto const options = trace_options(argc, argv);
        if (!options) return;
        if (!options->list) return trace_all(*options);
        for (auto const& name : scene_names()) std::cout << name << '\n';
    });
}
