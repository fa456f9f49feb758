#include <denoise/alpha_signal.hpp>
#include <denoise/behind_volume.hpp>
#include <denoise/canvas.hpp>
#include <denoise/film_alpha.hpp>
#include <denoise/layers.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/map_file.hpp>
#include <denoise/sample_count.hpp>
#include <denoise/sequence_frames.hpp>

#include <quell/io/part_names.hpp>

#include <algorithm>
#include <limits>

namespace quell::examples {

namespace {

/// Whether the light of a file goes through it as one picture or as its signals, not as parts that it knows by name.
bool denoises_picture(Preset const& preset) { return preset.of_signals.size() == 1 && preset.of_signals[0].name == radiance.name; }

/// Attributes of the view's own part. In a part that several stereo views share, the camera is that of the default one, if of any.
std::map<std::string, io::Attribute, std::less<>> attributes_of_view(io::ExrOriginal const& file, io::SequenceNames const& names) {
    auto attributes = file.attributes_of(home_part(file.listed, names));
    auto const& eyes = file.listed.eyes;
    if (!names.eye.empty() && (eyes.empty() || eyes[0] != names.eye))
        for (auto const* const name : {"quell:view", "quell:projection", "quell:view_previous", "quell:projection_previous"})
            attributes.erase(name);
    return attributes;
}

} // namespace

void SequenceFrames::begin(io::ExrOriginal const& file) {
    settings.map = settings.map ? io::names_in_parts(*settings.map, file.listed) : recognised(file.listed);
    if (settings.field_of_view)
        for (auto& signal : settings.map->of_signals) signal.channels.depth.vertical_field_of_view = *settings.field_of_view;
    if (settings.shutter)
        for (auto& signal : settings.map->of_signals) signal.channels.shutter = settings.shutter;
    auto const others = file.canvas();
    if (!(file.listed.size == window)) canvas = others;
    window = file.listed.size;
    canvas = {std::min(canvas.x0, others.x0), std::min(canvas.y0, others.y0), std::max(canvas.x1, others.x1),
              std::max(canvas.y1, others.y1)};
    check_field_of_view(file.listed, *settings.map, canvas);
    if (settings.upsampling) check_upsampling(file.listed);
    on_canvas = names_on_canvas(*settings.map, window, canvas);
    if (!denoises_picture(settings.preset)) on_canvas.picture.clear();
    alpha = denoises_picture(settings.preset) ? examples::alpha_plane(file.listed, *settings.map).value_or("") : "";
    any = denoiser_of(settings.preset, {1, 1}, 1);
}

/// Outside of the display window there is no picture to enlarge.
void SequenceFrames::check_upsampling(io::ExrListing const& file) {
    if (!(canvas_size() == window))
        throw Error(file.name, "it holds pixels outside of its display window, which --upsample can't enlarge",
                    "leave out --upsample, or what lies outside of the display window");
    auto const planes = io::planes_of(Channels<Depth, Motion>{}, settings.map->of_signals[0].channels);
    if (settings.upsampling->resolves() && !file.has_all(planes)) settings.upsampling->alone = "the files lack depth or motion";
    static_cast<void>(settings.upsampling->enlarged(window));
}

bool SequenceFrames::is_inside(Region const& other) const {
    return other.x0 >= canvas.x0 && other.y0 >= canvas.y0 && other.x1 <= canvas.x1 && other.y1 <= canvas.y1;
}

std::vector<std::string> SequenceFrames::planes(io::ExrListing const& file) const {
    auto planes = split_planes(file, on_canvas);
    if (settings.is_anti_aliased())
        for (auto const& plane : planes_of_frame_around(file, on_canvas)) planes.push_back(plane);
    if (!alpha.empty()) planes.push_back(alpha);
    if (settings.upsampling && settings.upsampling->resolves())
        for (auto const& plane : io::planes_of(Channels<Depth, Motion>{}, on_canvas.of_signals[0].channels)) planes.push_back(plane);
    for (auto const& signal : on_canvas.of_signals) {
        auto const more = any->planes(signal.channels);
        planes.insert(planes.end(), more.begin(), more.end());
        for (auto const& plane : any->optional_planes(signal.channels))
            if (file.find(plane)) planes.push_back(plane);
    }
    return planes;
}

SeenFrame SequenceFrames::seen(io::ExrOriginal const& file, long long number) {
    SeenFrame frame{number, file.read(planes(file.listed), canvas), false, {}, {}};
    LayoutChanges::begin_frame();
    if (!on_canvas.view.empty()) frame.image.attributes = attributes_of_view(file, on_canvas);
    put_cameras_on_canvas(frame.image, window, canvas);
    frame.said_samples = samples_in(file.listed, on_canvas);
    frame.samples = believed_samples(frame.image, on_canvas, frame.said_samples);
    auto empty = fill_empty_guides(frame.image, on_canvas);
    // Diagnosis says what is wrong with guides, and has to see them.
    empty.noise = !settings.diagnose && fill_noisy_normals(frame.image, on_canvas);
    empty_passes.add(empty);
    frame.is_opaque = alpha.empty() || std::ranges::all_of(frame.image[alpha].values, [](float a) { return a == 1.f; });
    // Of other presets' signals, the files may hold no picture.
    if (!settings.diagnose && denoises_picture(settings.preset)) {
        untold_motion.tell(frame.image, on_canvas, number, frame.is_opaque, frame.guides);
        frame.is_next_told = untold_motion.tell_next(frame.image, on_canvas, number, frame.guides);
    }
    if (settings.is_refined()) frame.behind = names_behind_volume(frame.image, on_canvas);
    if (!settings.diagnose)
        frame.believed = doubted_albedo.names_for(frame.image, names_of(frame), settings.preset.by_albedo, number, frame.guides);
    auto const& names = names_of(frame);
    if (settings.is_anti_aliased()) frame.around = frame_around(frame.image, names, frame.samples, frame.guides);
    auto split_by = rule();
    if (!frame.is_opaque) {
        frame.film = film_contents(whole_picture(frame.image, names), frame.image[alpha].values);
        frame.around.reset(); // colours of transparent film are those of what is hit, times its alpha
    }
    // Single samples don't tell where the albedo of an only signal is wrong: then it is filtered as one, or not, as the whole picture says.
    bool const is_told = has_several_signals(names) || frame.samples > 1;
    // Anti-aliasing takes the mean of several samples, and noise of guides is taken off the signals' picture: it is never filtered as one
    // for that.
    if (frame.around && is_told)
        split_by.samples_of_guides = settings.is_refined() ? std::numeric_limits<float>::infinity() : frame.samples <= 1 ? 4.f : 2.f;
    frame.as_one = is_better_as_one(frame.image, names, split_by);
    frame.has_noisy_guides = settings.is_refined() && frame.around && !frame.as_one && is_better_as_one(frame.image, names, rule());
    return frame;
}

void SequenceFrames::tell_next(SeenFrame& seen) const {
    if (seen.is_next_told) return;
    seen.is_next_told = untold_motion.tell_next(seen.image, on_canvas, seen.number, seen.guides);
    if (seen.is_next_told && seen.around) seen.around = frame_around(seen.image, names_of(seen), seen.samples, seen.guides);
}

std::vector<std::string> SequenceFrames::remarks() const {
    auto all = empty_passes.remarks();
    for (auto const& line : doubted_albedo.remarks()) all.push_back(line);
    return all;
}

LightSplit const& SequenceFrames::split(SeenFrame& seen, bool as_one) const {
    auto& way = seen.ways[as_one ? 1 : 0];
    if (way) return *way;
    auto split_by = rule();
    if (seen.is_opaque && !split_by.carries_alpha) split_by.alpha.clear();
    if (!seen.is_opaque) split_by.film = alpha;
    return way.emplace(split_light(seen.image, names_of(seen), split_by, as_one));
}

/// Presets that denoise any signal can denoise alpha by itself; some can denoise a colour with its alpha.
SplitRule SequenceFrames::rule() const {
    auto const& preset = settings.preset;
    bool const can = preset.by_albedo && preset_of_alpha(preset) && !settings.keeps_alpha && settings.debug_views.empty();
    return {.by_albedo = preset.by_albedo, .alpha = can ? alpha : "", .carries_alpha = can && preset.two_sided_alpha};
}

/// The only signal, where it has no factor, or else the rest: as split_light() gives it.
bool SequenceFrames::has_alpha(std::size_t signal) const {
    bool const is_rest = signal == on_canvas.of_signals.size();
    return is_rest || (!has_several_signals(on_canvas) && on_canvas.of_signals[signal].factor.empty());
}

metrics::Picture SequenceFrames::displayed(LinearView const& whole) const {
    metrics::Picture part{settings.upsampling ? whole.size : window, {}};
    int const x0 = settings.upsampling ? 0 : canvas.x0, y0 = settings.upsampling ? 0 : canvas.y0;
    for (int y = 0; y < part.size.height; ++y)
        for (int x = 0; x < part.size.width; ++x) part.pixels.push_back(whole[index_of(whole.size, x - x0, y - y0)]);
    return part;
}

} // namespace quell::examples
