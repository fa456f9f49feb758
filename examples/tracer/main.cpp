// quell-trace: renders scenes to sequences of EXR files, with exactly the channels that the chosen effects need.

#include "frame_sink.hpp"
#include "gltf/gltf.hpp"
#include "mask.hpp"
#include "reference.hpp"
#include "render.hpp"
#include "scenes/scenes.hpp"

#include <support/output_folder.hpp>
#include <support/png.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>
#include <support/size_in.hpp>

#include <quell/io/frame_image.hpp>
#include <quell/io/write_exr.hpp>
#include <quell/presets/general.hpp>

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <iostream>
#include <set>

using namespace quell;
using namespace quell::tracer;
using quell::examples::Progress;

namespace {

// What is written for an effect, what its converged reference is made of, and the masks of the pixels that it touches.

struct Composite {
    static constexpr auto name = "composite";
    using channels = union_of<decltype(presets::none(radiance))::reads, decltype(presets::surface_clamp(radiance, Demodulate{}))::reads,
                              decltype(presets::svgf(radiance, Demodulate{}))::reads>;
    using reference = Channels<Radiance>;
    static constexpr std::array masks{Effect::shadow, Effect::glossy, Effect::curved, Effect::indirect};
};
struct Shadow {
    static constexpr auto name = "shadow";
    using channels =
        Channels<Normal, Depth, Position, Motion, Direct, Visibility, Light, LightPrevious, Blocker, BlockerPrevious, ReceiverPrevious>;
    using reference = Channels<Direct, Visibility>;
    static constexpr std::array masks{Effect::shadow};
};
struct GlossyReflection {
    static constexpr auto name = "glossy";
    using channels = Channels<Normal, Depth, Position, Roughness, Motion, ReceiverPrevious, Glossy, GlossyHit, GlossyHitPrevious>;
    using reference = Channels<Glossy>;
    static constexpr std::array masks{Effect::glossy, Effect::curved};
};
struct IndirectLight {
    static constexpr auto name = "indirect";
    using channels = Channels<Albedo, Normal, Depth, Motion, Indirect, IndirectDirection>;
    using reference = Channels<Albedo, Indirect>;
    static constexpr std::array masks{Effect::indirect};
};
struct Blur {
    static constexpr auto name = "blur";
    using channels = Channels<Radiance, Albedo, Normal, Depth, Motion, Sweep, SweepBend, Time>;
    using reference = Channels<Radiance>;
    static constexpr std::array masks{Effect::blur};
};
/// Points of the frame before, shaded anew. Written with `composite` alone, whose light they are of: it takes rays of its own.
struct TemporalGradient {
    static constexpr auto name = "gradient";
    using channels = decltype(Composite::channels{} | Channels<GradientOf<Radiance>>{});
    using reference = Composite::reference;
    static constexpr std::array<Effect, 0> masks{};
};

/// Calls f(effect) for each.
void for_each_effect(auto&& f) { f(Composite{}), f(Shadow{}), f(GlossyReflection{}), f(IndirectLight{}), f(Blur{}), f(TemporalGradient{}); }

struct Options {
    std::vector<std::string> scenes, effects;
    std::string out, size = "480x270", jitter_name{name_of(Jitter::none)};
    int frames = 48, first = 0, spp = 1, reference = 0, threads = 0, shutter_keys = default_shutter_keys;
    std::uint32_t seed = 0;
    Jitter jitter = Jitter::none;
    std::optional<float> shutter, fov;
    std::vector<float> eye, target, dolly;
    float orbit = 0;
    bool masks = false, primary_only = false, quiet = false, list = false;

    [[nodiscard]] bool has(std::string const& effect) const { return std::ranges::find(effects, effect) != effects.end(); }
};

void describe(CLI::App& app, Options& o) {
    app.add_option("--scene", o.scenes, "A built-in scene's name, a .gltf or .glb file, or all; may be given several times (default: room)")
        ->take_all();
    app.add_option("--out", o.out, "Folder for frame.0000.exr and so on; of several scenes, each gets a folder of its own in there");
    app.add_option("--size", o.size, "Pixels (default: " + o.size + ")")->take_last();
    app.add_option("--frames", o.frames, "How many frames (default: " + std::to_string(o.frames) + ")");
    app.add_option("--first", o.first, "Number of the first frame (default: 0)");
    app.add_option("--spp", o.spp, "Samples per pixel (default: 1)");
    app.add_option("--jitter", o.jitter_name,
                   "Where primary rays go through the pixel: none (its centre), frame (one offset for all, another in each frame; the "
                   "camera says it) or pixel (each sample at a place of its own, spread as Cycles' pixel filter) (default: " +
                       o.jitter_name + ")")
        ->take_last();
    app.add_option(
        "--reference", o.reference,
        "Write converged frames too, reference.0000.exr and so on: at most so many samples per pixel, fewer where two halves agree");
    app.add_flag(
        "--masks", o.masks,
        "Write masks of the pixels that the effects touch too: mask_shadow.0000.png and so on, also glossy, curved, indirect and blur");
    app.add_flag("--primary-only", o.primary_only,
                 "Trace no shadows, reflections and indirect light: unshadowed direct light and ambient light");
    app.add_option("--shutter", o.shutter, "Part of the frame time during which the shutter is open (default: 0.5 for blur, otherwise 0)");
    app.add_option("--shutter-keys", o.shutter_keys,
                   "Moments of the open shutter between which everything moves in a straight line: 2 to " +
                       std::to_string(most_shutter_keys) + " (default: " + std::to_string(o.shutter_keys) + ")");
    app.add_option(
           "--effects", o.effects,
           "Which channels to write: any of composite,shadow,glossy,indirect,blur; or gradient, which asvgf wants (default: composite)")
        ->delimiter(',');
    app.add_option("--eye", o.eye, "Where the camera stands: x,y,z")->delimiter(',');
    app.add_option("--target", o.target, "What it looks at: x,y,z")->delimiter(',');
    app.add_option("--fov", o.fov, "Vertical field of view in degrees");
    app.add_option("--orbit", o.orbit, "Degrees per frame around the target");
    app.add_option("--dolly", o.dolly, "Movement of eye and target per frame: x,y,z")->delimiter(',');
    examples::add_threads(app, o.threads);
    app.add_option("--seed", o.seed, "Another seed, other noise (default: 0)");
    app.add_flag("--quiet", o.quiet, "Print nothing but errors");
    app.add_flag("--list", o.list, "Print the names of the built-in scenes");
}

[[noreturn]] void refuse(std::string const& option, std::string const& found, std::string const& remedy) {
    throw Error(option, found, remedy);
}

std::optional<glm::vec3> vector_in(char const* option, std::vector<float> const& numbers) {
    if (numbers.empty()) return std::nullopt;
    if (numbers.size() != 3) refuse(option, std::to_string(numbers.size()) + " numbers", "give three, as in 0,1.5,4");
    return glm::vec3(numbers[0], numbers[1], numbers[2]);
}

Jitter jitter_in(std::string const& name) {
    std::string names;
    for (auto const jitter : jitters) {
        if (name == name_of(jitter)) return jitter;
        names += (names.empty() ? "" : ", ") + std::string(name_of(jitter));
    }
    refuse("--jitter", "there is no jitter '" + name + "'", "choose from: " + names);
}

/// Checks what the command line says and fills in what it leaves out.
void complete(Options& o) {
    if (o.out.empty()) refuse("command line", "--out is missing", "say which folder the frames go to");
    if (o.frames < 1) refuse("--frames", std::to_string(o.frames), "give at least 1");
    constexpr long long most = 1 << 24;
    if (o.first < -most || o.first + static_cast<long long>(o.frames) > most)
        refuse("--first", std::to_string(o.first) + " and " + std::to_string(o.frames) + " frames",
               "give numbers from -" + std::to_string(most) + " to " + std::to_string(most) +
                   ": beyond them, time is the same for several frames");
    if (o.spp < 1) refuse("--spp", std::to_string(o.spp), "give at least 1");
    o.jitter = jitter_in(o.jitter_name);
    if (o.reference < 0 || o.reference == 1) refuse("--reference", std::to_string(o.reference), "give at least 2 samples per pixel");
    std::string names;
    for_each_effect([&](auto effect) { names += (names.empty() ? "" : ", ") + std::string(effect.name); });
    for (auto const& effect : o.effects)
        if ((", " + names + ",").find(" " + effect + ",") == std::string::npos)
            refuse("--effects", "there is no effect '" + effect + "'", "choose from: " + names);
    if (o.effects.empty()) o.effects = {Composite::name};
    for (auto const& effect : o.effects)
        if (o.has(TemporalGradient::name) && effect != TemporalGradient::name && effect != Composite::name)
            refuse("--effects", std::string(TemporalGradient::name) + " with " + effect,
                   "trace it by itself, or with " + std::string(Composite::name));
    if (!o.shutter) o.shutter = o.has(Blur::name) ? 0.5f : 0.f;
    if (o.has(Blur::name) && !(*o.shutter > 0))
        refuse("--shutter", std::to_string(*o.shutter), "give more than 0: without time there is no blur");
    if (o.shutter_keys < 2 || o.shutter_keys > most_shutter_keys)
        refuse("--shutter-keys", std::to_string(o.shutter_keys), "give 2 to " + std::to_string(most_shutter_keys));
    if (o.scenes.empty()) o.scenes = {"room"};
    if (std::ranges::find(o.scenes, "all") != o.scenes.end()) o.scenes = scene_names();
}

/// One scene on its way to disk.
struct Sequence {
    Options const& options;
    PreparedScene scene;
    std::filesystem::path folder;
    Progress& progress;
    long long& frames_done;

    [[nodiscard]] RenderSettings settings(int frame) const {
        return {.size = examples::size_in(options.size),
                .frame = frame,
                .samples_per_pixel = options.spp,
                .seed = options.seed,
                .threads = options.threads,
                .shutter = *options.shutter,
                .shutter_keys = options.shutter_keys,
                .jitter = options.jitter};
    }

    [[nodiscard]] Camera camera_at(int frame, Extent size) const {
        auto camera = scene.description().camera_at(static_cast<float>(frame), size);
        camera.jitter = camera_jitter(options.jitter, frame);
        return camera;
    }

    void write(char const* name, int frame, io::ExrImage image) const {
        io::put_camera(image, camera_at(frame, image.size));
        io::put_camera(image, camera_at(frame - 1, image.size), "_previous");
        examples::store([&] { io::write_exr(folder / numbered(name, frame, "exr"), image); });
    }

    /// Traces all frames with one set of channels, known when this is compiled.
    template <class Wanted> RayCounts trace() {
        RayCounts rays;
        for (int frame = options.first; frame < options.first + options.frames; ++frame) {
            progress.show(frames_done++, folder.filename().string());
            auto const how = settings(frame);
            Frame<Wanted> traced(how.size);
            traced.shutter = how.shutter;
            FrameSink<Frame<Wanted>> sink{traced};
            rays += render<Wanted>(scene, how, sink);
            write("frame", frame, io::image_of(traced));
            if (options.reference > 0) write_reference(how);
            if (options.masks) write_masks(how);
        }
        return rays;
    }

    void write_reference(RenderSettings const& how) {
        io::ExrImage image{.size = how.size};
        for_each_effect([&]<class Chosen>(Chosen) {
            if (!options.has(Chosen::name)) return;
            ReferenceSettings const until{.most_samples = options.reference, .samples_per_pass = std::min(options.reference / 2, 16)};
            auto const converged = tracer::reference<typename Chosen::reference>(scene, how, until);
            for_each_channel(typename Chosen::reference{}, [&](auto channel) { put(image, channel, converged); });
        });
        write("reference", how.frame, std::move(image));
    }

    void write_masks(RenderSettings const& how) {
        std::set<Effect> touching; // each once, whatever the number of effects that ask for it
        for_each_effect([&]<class Chosen>(Chosen) {
            if (options.has(Chosen::name)) touching.insert(Chosen::masks.begin(), Chosen::masks.end());
        });
        for (auto const effect : touching) {
            metrics::Picture picture{how.size, {}};
            for (auto const entry : effect_mask(scene, how, effect)) picture.pixels.emplace_back(entry != 0 ? 1.f : 0.f);
            examples::store(
                [&] { examples::write_png(folder / numbered("mask_" + std::string(name_of(effect)), how.frame, "png"), picture); });
        }
    }

    /// As in frame.0000.exr.
    static std::string numbered(std::string const& name, int frame, char const* ending) {
        char number[16];
        std::snprintf(number, sizeof number, ".%04d.", frame);
        return name + number + ending;
    }

    /// Adds a channel of the reference, unless another effect did already.
    template <class C> static void put(io::ExrImage& image, C channel, Reference const& converged) {
        auto const names = io::own_names(channel);
        if (image.find(names[0])) return;
        for (int c = 0; c < C::components; ++c) {
            io::Plane plane{.name = names[static_cast<std::size_t>(c)], .type = io::SampleType::half, .values = {}};
            for (auto const& pixel : converged[channel].pixels) plane.values.push_back(pixel[c]);
            image.planes.push_back(std::move(plane));
        }
    }
};

/// What is written besides where the shutter is open: how shadows and reflections move meanwhile.
template <class Set>
using EffectSweeps =
    union_of<std::conditional_t<Set::template has<Time> && Set::template has<Visibility>, Channels<SweepOf<Visibility>>, Channels<>>,
             std::conditional_t<Set::template has<Time> && Set::template has<Glossy>, Channels<SweepOf<Glossy>>, Channels<>>>;

/// Calls f with the set of all channels of the chosen effects. There is one instance of f for each set that may come of it.
template <class Set> RayCounts with_channels(Options const&, auto&& f, Set) {
    if constexpr (Set::size > 0)
        // In one order, so that equal sets are the same type.
        return f(common_to<AllChannels, Set>{} | without<Set, AllChannels>{} | EffectSweeps<Set>{});
    else
        return {};
}
/// Not with every set: there would be twice as many.
template <class Set> RayCounts with_channels(Options const& o, auto&& f, Set set, TemporalGradient) {
    if constexpr (contained_in<Set, TemporalGradient::channels>) {
        if (o.has(TemporalGradient::name)) return with_channels(o, f, TemporalGradient::channels{});
    }
    return with_channels(o, f, set);
}
template <class Set, class Effect, class... Rest> RayCounts with_channels(Options const& o, auto&& f, Set set, Effect, Rest... rest) {
    if (o.has(Effect::name)) return with_channels(o, f, set | typename Effect::channels{}, rest...);
    return with_channels(o, f, set, rest...);
}

void print(std::string const& scene, Options const& options, RayCounts const& rays) {
    std::cout << scene << ": " << options.frames << " frames of " << options.size << "; rays: " << rays.primary << " primary, "
              << rays.shadow << " shadow, " << rays.glossy << " glossy, " << rays.indirect << " indirect" << std::endl;
}

void trace_all(Options const& options) {
    CameraChoice const camera{vector_in("--eye", options.eye), vector_in("--target", options.target), options.fov, options.orbit,
                              vector_in("--dolly", options.dolly).value_or(glm::vec3(0.f))};
    auto const folders = examples::folders_of_scenes(options.out, options.scenes);
    std::vector<SceneDescription> scenes; // all of them, before the first is rendered: a misspelt name shows at once
    for (auto const& name : options.scenes) {
        scenes.push_back(open_scene(name, camera));
        if (options.primary_only) scenes.back().secondary_rays = false;
    }
    static_cast<void>(examples::size_in(options.size));
    for (auto const& folder : folders) examples::make_output_folder(folder);
    Progress progress("quell-trace", static_cast<long long>(scenes.size()) * options.frames, !options.quiet);
    long long frames_done = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Sequence sequence{options, PreparedScene(std::move(scenes[i])), folders[i], progress, frames_done};
        auto const rays = with_channels(
            options, [&]<class Wanted>(Wanted) { return sequence.trace<Wanted>(); }, Channels<>{}, Composite{}, Shadow{},
            GlossyReflection{}, IndirectLight{}, Blur{}, TemporalGradient{});
        if (!options.quiet) print(options.scenes[i], options, rays);
    }
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("quell-trace", [&] {
        CLI::App app("Renders scenes to sequences of EXR files: noisy signals, guides and converged references.", "quell-trace");
        Options options;
        describe(app, options);
        if (!examples::parse(app, argc, argv)) return;
        if (options.list) {
            for (auto const& name : scene_names()) std::cout << name << '\n';
            return;
        }
        complete(options);
        trace_all(options);
    });
}
