#include "options.hpp"
#include "effects.hpp"
#include "scenes/scenes.hpp"

#include <support/program.hpp>
#include <support/size_in.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>

namespace quell::tracer {
namespace {

/// Beyond this number, either way, time is the same for several frames.
constexpr int last_frame = 1 << 24;
constexpr int max_samples = 1 << 20;

void describe_output(CLI::App& app, TraceOptions& o) {
    app.add_option("--scene", o.scenes, "A built-in scene's name, a .gltf or .glb file, or all; may be given several times (default: room)")
        ->take_all();
    app.add_option("--out", o.out, "Folder for frame.0000.exr and so on; of several scenes, each gets a folder of its own in there");
    app.add_option_function<std::string>(
           "--size", [&](std::string const& text) { o.rendered.size = examples::size_in(text); },
           "Pixels (default: " + to_string(o.rendered.size) + ")")
        ->take_last();
    app.add_option("--frames", o.frames, "How many frames (default: " + std::to_string(o.frames) + ")")
        ->check(CLI::Range(1, 2 * last_frame));
    app.add_option("--first", o.first, "Number of the first frame (default: 0)")->check(CLI::Range(-last_frame, last_frame));
    app.add_option(
           "--effects", o.effects,
           "Which channels to write: any of composite,shadow,glossy,indirect,blur; or gradient, which asvgf wants (default: composite)")
        ->delimiter(',')
        ->check(CLI::IsMember(all_effect_names()));
    app.add_option(
        "--reference", o.reference,
        "Write converged frames too, reference.0000.exr and so on: at most so many samples per pixel, fewer where two halves agree");
    app.add_flag(
        "--masks", o.masks,
        "Write masks of the pixels that the effects touch too: mask_shadow.0000.png and so on, also glossy, curved, indirect and blur");
    app.add_flag("--quiet", o.quiet, "Print nothing but errors");
    app.add_flag("--list", o.list, "Print the names of the built-in scenes");
}

void describe_rendering(CLI::App& app, TraceOptions& o) {
    auto& rendered = o.rendered;
    std::vector<std::string> jitter_names;
    for (auto const jitter : jitters) jitter_names.emplace_back(name_of(jitter));
    app.add_option("--spp", rendered.samples_per_pixel, "Samples per pixel (default: 1)")->check(CLI::Range(1, max_samples));
    app.add_option(
           "--guide-spp", rendered.guide_samples,
           "Samples per pixel of normal, albedo, roughness and motion, where samples see different points (a lens, a pane, --jitter "
           "pixel): more than --spp, if it is more")
        ->check(CLI::Range(1, max_samples));
    app.add_option_function<std::string>(
           "--jitter",
           [&](std::string const& name) {
               rendered.jitter = *std::ranges::find(jitters, name, [](Jitter jitter) { return name_of(jitter); });
           },
           "Where primary rays go through the pixel: none (its centre), frame (one offset for all, another in each frame; the camera says "
           "it) or pixel (each sample at a place of its own, spread as Cycles' pixel filter) (default: none)")
        ->take_last()
        ->check(CLI::IsMember(jitter_names));
    app.add_flag("--primary-only", o.primary_only,
                 "Trace no shadows, reflections and indirect light: unshadowed direct light and ambient light");
    app.add_option("--shutter", o.shutter, "Part of the frame time during which the shutter is open (default: 0.5 for blur, otherwise 0)")
        ->check(CLI::Range(0.f, 1.f));
    app.add_option("--shutter-keys", rendered.shutter_keys,
                   "Moments of the open shutter between which everything moves in a straight line (default: " +
                       std::to_string(rendered.shutter_keys) + ")")
        ->check(CLI::Range(2, max_shutter_keys));
    examples::add_threads(app, rendered.threads);
    app.add_option("--seed", rendered.seed, "Another seed, other noise (default: 0)");
}

/// An option of three numbers.
void add_vector(CLI::App& app, std::string const& name, std::string const& text, std::function<void(glm::vec3)> const& take) {
    auto const understand = [=](std::vector<float> const& numbers) {
        if (numbers.size() != 3) throw Error(name, std::to_string(numbers.size()) + " numbers", "give three, as in 0,1.5,4");
        take({numbers[0], numbers[1], numbers[2]});
    };
    app.add_option_function<std::vector<float>>(name, understand, text)->delimiter(',');
}

void describe_camera(CLI::App& app, CameraChoice& camera) {
    add_vector(app, "--eye", "Where the camera stands: x,y,z", [&](glm::vec3 at) { camera.eye = at; });
    add_vector(app, "--target", "What it looks at: x,y,z", [&](glm::vec3 at) { camera.target = at; });
    app.add_option("--fov", camera.field_of_view, "Vertical field of view in degrees");
    app.add_option("--orbit", camera.orbit, "Degrees per frame around the target");
    add_vector(app, "--dolly", "Movement of eye and target per frame: x,y,z", [&](glm::vec3 by) { camera.dolly = by; });
}

/// What no option can tell of itself.
void check(TraceOptions const& o) {
    if (o.out.empty()) throw Error("command line", "--out is missing", "say which folder the frames go to");
    if (o.first + o.frames > last_frame)
        throw Error("--first", std::to_string(o.first) + " and " + std::to_string(o.frames) + " frames",
                    "give numbers up to " + std::to_string(last_frame) + ": beyond it, time is the same for several frames");
    if (o.reference != 0 && (o.reference < 2 || o.reference > max_samples))
        throw Error("--reference", std::to_string(o.reference), "give 2 to " + std::to_string(max_samples) + " samples per pixel");
    for (auto const& effect : o.effects)
        if (o.has(GradientEffect::name) && effect != GradientEffect::name && effect != CompositeEffect::name)
            throw Error("--effects", std::string(GradientEffect::name) + " with " + effect,
                        "trace it by itself, or with " + std::string(CompositeEffect::name));
    if (o.has(BlurEffect::name) && !(o.rendered.shutter > 0))
        throw Error("--shutter", std::to_string(o.rendered.shutter), "give more than 0: without time there is no blur");
    detail::check(o.rendered); // what isn't a number is in no range, nor out of it
}

} // namespace

bool TraceOptions::has(std::string const& effect) const { return std::ranges::find(effects, effect) != effects.end(); }

std::optional<TraceOptions> trace_options(int argc, char const* const* argv) {
    CLI::App app("Renders scenes to sequences of EXR files: noisy signals, guides and converged references.", "quell-trace");
    TraceOptions options;
    describe_output(app, options);
    describe_rendering(app, options);
    describe_camera(app, options.camera);
    if (!examples::parse(app, argc, argv)) return std::nullopt;
    if (options.list) return options;
    if (options.effects.empty()) options.effects = {CompositeEffect::name};
    if (options.scenes.empty()) options.scenes = {"room"};
    if (std::ranges::find(options.scenes, "all") != options.scenes.end()) options.scenes = scene_names();
    options.rendered.shutter = options.shutter.value_or(options.has(BlurEffect::name) ? 0.5f : 0.f);
    check(options);
    return options;
}

} // namespace quell::tracer
