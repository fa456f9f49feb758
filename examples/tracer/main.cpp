// quell-trace: renders scenes to sequences of EXR files, with exactly the channels that the chosen effects need.

#include "effects.hpp"
#include "mask.hpp"
#include "options.hpp"
#include "reference.hpp"
#include "scenes/scenes.hpp"
#include "trace_frame.hpp"

#include <quell/io/frame_image.hpp>
#include <quell/io/write_exr.hpp>
#include <support/frame_pattern.hpp>
#include <support/output_folder.hpp>
#include <support/png.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>

#include <iostream>
#include <set>

using namespace quell;
using namespace quell::tracer;

namespace {

/// Adds a channel of the reference, unless another effect did already.
template <class C> void put(io::ExrImage& image, C channel, Reference const& converged) {
    auto const names = io::own_names(channel);
    if (image.find(names[0])) return;
    for (int c = 0; c < C::components; ++c) {
        io::Plane plane{.name = names[static_cast<std::size_t>(c)], .type = io::SampleType::half, .values = {}};
        for (auto const& pixel : converged[channel].pixels) plane.values.push_back(pixel[c]);
        image.planes.push_back(std::move(plane));
    }
}

/// One scene on its way to disk.
class SequenceWriter {
public:
    /// @param done counts the frames of all sequences, for the progress
    SequenceWriter(TraceOptions const& options_, SceneDescription description, std::filesystem::path folder_, examples::Progress& progress_,
                   long long& done_)
        : options(options_), scene(std::move(description)), folder(std::move(folder_)), progress(progress_), done(done_) {}

    /// Traces all frames with one set of channels, known when this is compiled.
    template <class Wanted> RayCounts trace() {
        RayCounts rays;
        for (int number = options.first; number < options.first + options.frames; ++number) {
            progress.show(done++, folder.filename().string());
            Frame<Wanted> frame(options.rendered.size);
            rays += trace_frame(scene, settings(number), frame);
            write("frame", number, io::image_of(frame));
            if (options.reference > 0) write_reference(number);
            if (options.masks) write_masks(number);
        }
        return rays;
    }

private:
    TraceOptions const& options;
    PreparedScene scene;
    std::filesystem::path folder;
    examples::Progress& progress;
    long long& done;

    [[nodiscard]] RenderSettings settings(int frame) const {
        auto settings = options.rendered;
        settings.frame = frame;
        return settings;
    }

    void write(char const* name, int frame, io::ExrImage image) const {
        io::put_camera(image, camera_of(scene, settings(frame)));
        io::put_camera(image, camera_of(scene, settings(frame - 1)), "_previous");
        io::write_exr(folder / examples::frame_file_name(name, frame, "exr"), image);
    }

    void write_reference(int frame) {
        io::ExrImage image{.size = options.rendered.size};
        ReferenceSettings const until{.max_samples = options.reference, .samples_per_pass = std::min(options.reference / 2, 16)};
        for_each_effect([&]<class Chosen>(Chosen) {
            if (!options.has(Chosen::name)) return;
            auto const converged = reference<typename Chosen::reference>(scene, settings(frame), until);
            for_each_channel(typename Chosen::reference{}, [&](auto channel) { put(image, channel, converged); });
        });
        write("reference", frame, std::move(image));
    }

    void write_masks(int frame) {
        std::set<Effect> touching; // each once, whatever the number of effects that ask for it
        for_each_effect([&]<class Chosen>(Chosen) {
            if (options.has(Chosen::name)) touching.insert(Chosen::masks.begin(), Chosen::masks.end());
        });
        for (auto const effect : touching) {
            metrics::Picture picture{options.rendered.size, {}};
            for (auto const entry : effect_mask(scene, settings(frame), effect)) picture.pixels.emplace_back(entry != 0 ? 1.f : 0.f);
            auto const file = folder / examples::frame_file_name("mask_" + std::string(name_of(effect)), frame, "png");
            examples::write_png(file, picture);
        }
    }
};

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
