#include <denoise/debug_view.hpp>
#include <denoise/map_file.hpp>
#include <denoise/options.hpp>
#include <denoise/presets.hpp>
#include <denoise/renderer_maps.hpp>
#include <denoise/scores.hpp>
#include <denoise/stage_account.hpp>
#include <support/program.hpp>

#include <quell/core/error.hpp>
#include <quell/core/instruction_set.hpp>
#include <quell/core/real.hpp>
#include <quell/version.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>

namespace quell::examples {

namespace {

// Which code of the program this is, and what code the program has.
#if !defined(QUELL_ISA)
#define QUELL_TEXT_OF(a) #a
#define QUELL_TEXT(a) QUELL_TEXT_OF(a)
#define QUELL_ISA QUELL_TEXT(QUELL_INSTRUCTION_SET)
#endif
#if !defined(QUELL_ISAS)
#define QUELL_ISAS QUELL_ISA
#endif

/// What --map and exit codes mean.
std::string footer() {
    return "\nFiles of quell-trace and of Blender's Cycles are recognised, and most of the renderers that --map lists. A map in JSON names "
           "the "
           "channels of any other's:\n" +
           std::string(map_example) + R"(
Every member may be left out. A name stands for a layer (beauty.R beauty.G beauty.B), a list for whole names, a number for itself everywhere.
"scale" and "offset": n * scale + offset; "first_of": the first that the file has; "miss_from", "miss_to": depths without a surface.
"points" is to_previous or from_previous, "unit" pixel, uv or ndc, "y" down or up, "jitter" left_out or left_in.
"radiance" is divided by its albedo before it is denoised, "irradiance" already is. docs/programs.md has all of it.

Exit codes: 0 done, 2 unusable arguments or input, 1 anything else.)";
}

/// The names of all presets, a line a group.
std::string preset_groups() {
    std::string text = "by group:";
    std::optional<PresetGroup> group;
    for (auto const& preset : presets()) {
        text += preset.group == group ? ", " + preset.name : "\n  " + std::string(to_string(preset.group)) + ": " + preset.name;
        group = preset.group;
    }
    return text + "\n";
}

void describe(CLI::App& app, DenoiseOptions& options) {
    app.add_option("--in", options.in, "Noisy frames, e.g. 'dir/frame.%04d.exr' or 'dir/frame.####.exr'");
    app.add_option("--out", options.out, "Denoised frames, e.g. 'dir/out.%04d.exr': all of the input, with the picture denoised");
    app.add_option(
           "--layers", options.layers,
           "Which layers to write: any of all, picture (the denoised image and its alpha), signals (what each denoised signal adds to "
           "it), guides (mean_albedo and mean_normal, of the preset accumulated), and names of the input's layers, channels or parts "
           "(default: all)")
        ->delimiter(',');
    app.add_option("--preset", options.preset,
                   "How to denoise; --list names them (default: what suits the files' channels: blur where they have "
                   "sweeps and times, trmv where they have what shadows and reflections move by, else final-frame)");
    app.add_option("--signal", options.signal,
                   "Denoise one signal of the files by itself: one of a map's or of Blender's (diffuse), a channel of quell's "
                   "(visibility, glossy, indirect, direct) or a layer; it takes its own place in the output (default: the picture)");
    app.add_option("--first", options.first, "Number of the first frame (default: the first that there is)");
    app.add_option("--last", options.last, "Number of the last frame (default: the last that there is)");
    app.add_option("--frames", options.frames, "The frames in place of --first and --last: numbers and ranges, as in 1-48,60 or 1-99x2");
    app.add_option("--chunk", options.chunk, "A part of the frames, for a farm's jobs: 2/6 is the second of six in a row");
    app.add_flag("--skip-existing", options.skip_existing, "Leave out frames whose output is there already and is whole");
    app.add_option("--reference", options.reference, "Converged frames, e.g. 'dir/ref.%04d.exr': prints " + Scores::header() + " as CSV");
    app.add_option("--map", options.map,
                   "How another renderer names its channels: a JSON file, see below, or else one of " + names_of_renderers());
    app.add_option("--field-of-view", options.field_of_view,
                   "Vertical degrees that the camera sees, for depths that are the length of rays, in files without a camera");
    app.add_option("--shutter", options.shutter,
                   "Part of the frame time during which the shutter is open (default: what the map says, or else the files, or else 0.5)");
    app.add_option("--warmup", options.warmup,
                   "Frames before the first, and before each gap in the list, to denoise without writing them (default: so many that "
                   "frames come out as from the whole sequence, as far as the preset remembers; fewer where there are none)");
    app.add_option(
        "--extra-frames", options.extra_frames,
        "Later frames that each one is denoised with, 0 to 8 (default: 2 with the presets final-frame and general, the only ones that "
        "make use of them; 0 is what a host has in real time)");
    app.add_option("--upsample", options.upsample,
                   "Write the picture alone, so many times larger than the input, 1 to 4 (1 smooths edges at the same size): put together "
                   "from samples of several frames where the files say how these are jittered, else enlarged bicubically, which stderr "
                   "says");
    add_threads(app, options.threads);
    app.add_flag("--keep-alpha", options.keep_alpha, "Leave the film's alpha as it is (default: denoised by the weights of the picture)");
    app.add_flag(
        "--quick", options.quick,
        "The preset's own result, with final-frame and general in about a quarter of the time: without light with history and "
        "without, as each frame's samples speak for (final-frame), without light that comes back, and without colours and emission "
        "from the samples of frames around");
    app.add_option("--stages", options.stages,
                   "What is done besides, in place of what the preset has: any of " + stage_names() +
                       " (default: light and colours with general, evidence too with final-frame)")
        ->delimiter(',');
    app.add_flag("--diagnose", options.diagnose,
                 "Say on stderr what the renderer seems to have got wrong (motion, cameras, depth, normals, albedo, samples) and in which "
                 "frame that first shows");
    app.add_option("--debug-view", options.debug_views,
                   "Write what happened in each pixel beside the output, as EXR and PNG: any of " + debug_view_names() +
                       " (clamp of presets that clamp only); slower")
        ->delimiter(',');
    app.add_flag(
        "--why", options.why,
        "Write beside the output what was done behind the preset, as NAME.why.csv, and as NAME.why.png the stage that changed each "
        "pixel most: " +
            legend_of_stages());
    app.set_version_flag("--version", "quell-denoise " + std::string(version) + " for " QUELL_ISA,
                         "Print the version and the instruction set that runs");
    app.add_option(
           "--device", options.device,
           "What denoises: cpu, or cuda, an NVIDIA GPU, where this program was built for it: without later frames, as a host does in "
           "real time, and without what --quick leaves out but anti-aliased colours")
        ->capture_default_str();
    app.add_option("--isa", options.isa,
                   "Instruction set to run, of those that this program is compiled for: " QUELL_ISAS
                   " (default: the best that the machine has)");
    app.add_flag("--quiet", options.quiet, "Say nothing on stderr but errors");
    app.add_flag("--json", options.json, "Print a summary for scripts on stdout: one JSON object, with the rows of --reference in it");
    app.add_flag("--list", options.list, "Print the names of the presets");
    app.add_flag(
        "--plan", options.plan,
        "Print the passes of --preset, or of the preset that suits --in, with what each reads and writes, and the memory that they take; "
        "denoise nothing");
    app.footer("Presets, " + preset_groups() + footer());
}

void check_debug_views(DenoiseOptions const& options) {
    for (auto const& view : options.debug_views)
        if (!is_debug_view(view)) throw Error("--debug-view", "there is no view '" + view + "'", "choose any of: " + debug_view_names());
    if (!options.debug_views.empty() && options.out.empty())
        throw Error("--debug-view", "--out is missing", "say where the result goes: views are written beside it");
}

void check_stages(DenoiseOptions const& options) {
    if (!options.stages) return;
    if (options.quick) throw Error("--stages", "--quick is there too, which is none", "leave one of the two out");
    for (auto const& name : *options.stages)
        if (!is_stage(name)) throw Error("--stages", "there is no '" + name + "'", "choose any of: " + stage_names());
}

/// A file that is named as another format than it has misleads every program that opens it.
void check_format(std::string const& out) {
    auto const ending = CLI::detail::to_lower(std::filesystem::path(out).extension().string());
    for (auto const* other : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".hdr", ".tga", ".bmp", ".webp"})
        if (ending == other) throw Error("--out", "'" + out + "' is named as another format than EXR", "end the name with .exr");
}

void check_output(DenoiseOptions const& options) {
    check_format(options.out);
    if (!options.frames.empty() && (options.first || options.last))
        throw Error("--frames", "--first or --last is there too", "leave one or the other out");
    for (auto const& [name, is_there] :
         {std::pair{"--skip-existing", options.skip_existing}, {"--layers", !options.layers.empty()}, {"--why", options.why}})
        if (is_there && options.out.empty()) throw Error(name, "--out is missing", "say where the result goes");
}

void check_beside_device(DenoiseOptions const& options) {
    check_device(options.device);
    if (options.device == "cpu") return;
    for (auto const& [name, is_there] : {std::pair{"--extra-frames", options.extra_frames.value_or(0) != 0},
                                         {"--debug-view", !options.debug_views.empty()},
                                         {"--stages", options.stages.has_value()},
                                         {"--diagnose", options.diagnose}})
        if (is_there) throw Error(name, "--device " + options.device + " does not know it", "leave one of the two out");
}

/// The picture alone is enlarged.
void check_upsample(DenoiseOptions const& options) {
    if (!options.upsample) return;
    if (!(*options.upsample >= 1.f && *options.upsample <= 4.f))
        throw Error("--upsample", std::to_string(*options.upsample), "give a ratio from 1 to 4, such as 1.5 or 2");
    for (auto const& [name, is_there] : {std::pair{"--signal", !options.signal.empty()},
                                         {"--layers", !options.layers.empty()},
                                         {"--debug-view", !options.debug_views.empty()}})
        if (is_there)
            throw Error("--upsample", std::string(name) + " is there too, and only the picture is enlarged", "leave one of the two out");
}

void check(DenoiseOptions const& options) {
    if (!options.isa.empty() && options.isa != QUELL_ISA)
        throw Error("--isa", "this program has no code for '" + options.isa + "'", "choose one of: " QUELL_ISAS);
    check_beside_device(options);
    check_stages(options);
    if (options.list) return;
    check_upsample(options);
    if (options.plan && options.in.empty() && options.preset.empty())
        throw Error("--plan", "neither --preset nor --in is there", "say of which preset, or which files it is to suit");
    if (options.plan) return;
    if (options.in.empty()) throw Error("command line", "--in is missing", "say where the frames are, as in --in 'dir/frame.%04d.exr'");
    if (options.out.empty() && options.reference.empty() && !options.diagnose)
        throw Error("command line", "none of --out, --reference and --diagnose is there",
                    "say where the result goes, what to compare it with, or that mistakes are to be looked for");
    check_debug_views(options);
    if (options.field_of_view && !(*options.field_of_view > 0.f && *options.field_of_view < 180.f))
        throw Error("--field-of-view", std::to_string(*options.field_of_view), "give degrees between 0 and 180");
    if (options.shutter && !(is_finite(*options.shutter) && *options.shutter >= 0))
        throw Error("--shutter", std::to_string(*options.shutter), "give a part of the frame time, such as 0.5");
    if (options.extra_frames && (*options.extra_frames < 0 || *options.extra_frames > 8))
        throw Error("--extra-frames", std::to_string(*options.extra_frames), "give 0 to 8 frames");
    if (options.warmup.value_or(0) < 0) throw Error("--warmup", std::to_string(*options.warmup), "give 0 or more frames");
    check_output(options);
}

} // namespace

std::optional<DenoiseOptions> denoise_options(int argc, char const* const* argv) {
    CLI::App app("Denoises a sequence of EXR files, from quell-trace or from another renderer.", "quell-denoise");
    DenoiseOptions options;
    describe(app, options);
    if (!parse(app, argc, argv)) return std::nullopt;
    check(options);
    return options;
}

} // namespace quell::examples
