#include <denoise/behind_volume.hpp>
#include <denoise/composite.hpp>
#include <denoise/converted_history.hpp>
#include <denoise/layers.hpp>
#include <denoise/map_file.hpp>
#include <denoise/sequence_denoiser.hpp>

#include <quell/core/real.hpp>
#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/io/part_names.hpp>
#include <quell/resolve/repeated_residual.hpp>
#include <quell/resolve/residual_feedback.hpp>

#include <algorithm>
#include <chrono>
#include <limits>

namespace quell::examples {

namespace {

/// Adds the milliseconds that it lives to a sum.
class Timed {
    double& sum;
    std::chrono::steady_clock::time_point const begin = std::chrono::steady_clock::now();

public:
    explicit Timed(double& s) : sum(s) {}
    ~Timed() { sum += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count(); }
    Timed(Timed const&) = delete;
    Timed& operator=(Timed const&) = delete;
};

/// The change that a file's user can make to mend a mistake, where there is one beside that of the host's code.
std::string in_the_map(Mistake mistake) {
    switch (mistake) {
    case Mistake::motion_sign:
        return "; for files, set \"points\" of \"motion\" in --map";
    case Mistake::motion_unit:
        return "; for files, set \"unit\" of \"motion\" in --map";
    case Mistake::motion_y:
        return "; for files, set \"y\" of \"motion\" in --map";
    case Mistake::depth_is_ray_length:
        return "; for files, set \"along\" of \"depth\" to \"ray\" in --map";
    case Mistake::depth_of_misses:
        return "; for files, set \"miss_from\" in --map";
    case Mistake::signal_demodulated:
        return "; for files, write \"irradiance\" in place of \"radiance\" in --map";
    case Mistake::signal_has_albedo:
        return "; for files, write \"radiance\" in place of \"irradiance\" in --map";
    default:
        return {};
    }
}
std::string remedy_for_files(Finding const& finding) {
    auto text = in_the_map(finding.mistake);
    if (finding.evidence.starts_with(detail::camera_is_not_set))
        text += "; files have it in the attributes quell:view and quell:projection";
    for (auto const mistake : finding.also) text += in_the_map(mistake);
    return text;
}

void check_debug_views(Preset const& preset, std::vector<std::string> const& views) {
    if (views.empty()) return;
    if (!preset.watched)
        throw Error("--debug-view", "preset '" + preset.name + "' has none",
                    "choose one with a history, such as svgf; of trmv, its parts shadow, glossy and dual-cone");
    Denoiser const watched(preset.watched, {1, 1}, 1);
    for (auto const& view : views)
        if (!watched.has_debug_view(view))
            throw Error("--debug-view", "preset '" + preset.name + "' has no " + view,
                        "leave it out, or choose a preset that clamps, such as surface-clamp");
}

/// Whether the light of a file goes through it as one picture or as its signals, not as parts that it knows by name.
bool denoises_picture(Preset const& preset) { return preset.of_signals.size() == 1 && preset.of_signals[0].name == radiance.name; }

/// Vectors in parts of the display window's size are other parts of a canvas that is larger.
io::SequenceNames names_on_canvas(io::SequenceNames names, Extent size, Region const& canvas) {
    auto const whole = io::detail::size_of(canvas);
    std::array const parts{static_cast<float>(size.width) / static_cast<float>(whole.width),
                           static_cast<float>(size.height) / static_cast<float>(whole.height)};
    auto const scale = [&](auto channel, io::ChannelNames& channels) {
        auto sources = io::sources_of(channels, channel);
        for (std::size_t c = 0; c < 2; ++c) sources[c].scale *= parts[c], sources[c].offset *= parts[c];
        channels.sources.insert_or_assign(channel.name, sources);
    };
    for (auto& signal : names.of_signals)
        if (!(whole == size) && signal.channels.motion.unit != MotionConvention::Unit::pixel)
            scale(motion, signal.channels), scale(motion_next, signal.channels);
    return names;
}

/// A field of view is that of the display window.
void check_field_of_view(io::ExrListing const& file, io::SequenceNames const& map, Region const& canvas) {
    bool const has_camera = file.attributes.contains("quell:view") && file.attributes.contains("quell:projection");
    if (io::detail::size_of(canvas) == file.size || has_camera) return;
    for (auto const& signal : map.of_signals)
        if (signal.channels.depth.along == io::DepthConvention::Along::ray)
            throw Error(file.name, "its data window is not its display window, and only the map says what the camera sees",
                        "write the attributes quell:view and quell:projection, or leave out what lies outside of the display window");
}

/// Attributes of the view's own part. In a part that several stereo views share, the camera is that of the default one, if of any.
std::map<std::string, io::Attribute, std::less<>> attributes_of_view(io::ExrOriginal const& file, io::SequenceNames const& names) {
    auto attributes = file.attributes_of(home_part(file.listed, names));
    auto const& eyes = file.listed.eyes;
    if (!names.eye.empty() && (eyes.empty() || eyes[0] != names.eye))
        for (auto const* const name : {"quell:view", "quell:projection", "quell:view_previous", "quell:projection_previous"})
            attributes.erase(name);
    return attributes;
}

/// Cameras are of the display window. This changes their projections so that the canvas is what they show.
void put_cameras_on_canvas(io::ExrImage& image, Extent size, Region const& canvas) {
    auto const part = [](int of, int whole) { return static_cast<float>(of) / static_cast<float>(whole); };
    float const x = part(size.width, image.size.width), y = part(size.height, image.size.height);
    glm::mat4 to_canvas(1.f);
    to_canvas[0][0] = x, to_canvas[3][0] = x - 1.f - 2.f * part(canvas.x0, image.size.width);
    to_canvas[1][1] = y, to_canvas[3][1] = 1.f - y + 2.f * part(canvas.y0, image.size.height);
    if (image.size == size) return;
    for (auto const* const name : {"quell:projection", "quell:projection_previous"})
        if (auto const* const projection = image.attribute<glm::mat4>(name)) image.attributes[name] = to_canvas * *projection;
}

} // namespace

SequenceDenoiser::SequenceDenoiser(SequenceSettings settings_) : settings(std::move(settings_)) {
    check_debug_views(settings.preset, settings.debug_views);
}

void SequenceDenoiser::begin(io::ExrOriginal const& file) {
    settings.map = settings.map ? io::names_in_parts(*settings.map, file.listed) : recognised(file.listed);
    if (settings.field_of_view)
        for (auto& signal : settings.map->of_signals) signal.channels.depth.vertical_field_of_view = *settings.field_of_view;
    if (settings.shutter)
        for (auto& signal : settings.map->of_signals) signal.channels.shutter = settings.shutter;
    auto const others = file.canvas();
    if (!(file.listed.size == size)) canvas = others;
    size = file.listed.size;
    canvas = {std::min(canvas.x0, others.x0), std::min(canvas.y0, others.y0), std::max(canvas.x1, others.x1),
              std::max(canvas.y1, others.y1)};
    check_field_of_view(file.listed, *settings.map, canvas);
    if (settings.upsampling) check_upsampling(file.listed);
    on_canvas = names_on_canvas(*settings.map, size, canvas);
    if (!denoises_picture(settings.preset)) on_canvas.picture.clear();
    alpha = denoises_picture(settings.preset) ? alpha_plane(file.listed, *settings.map).value_or("") : "";
    any = denoiser_of(settings.preset, {1, 1}, 1);
    denoisers.resize(on_canvas.of_signals.size() + 1);
}

/// Outside of the display window there is no picture to enlarge.
void SequenceDenoiser::check_upsampling(io::ExrListing const& file) {
    if (!(io::detail::size_of(canvas) == size))
        throw Error(file.name, "it holds pixels outside of its display window, which --upsample can't enlarge",
                    "leave out --upsample, or what lies outside of the display window");
    auto const planes = io::planes_of(Channels<Depth, Motion>{}, settings.map->of_signals[0].channels);
    if (settings.upsampling->resolves() && !file.has_all(planes)) settings.upsampling->alone = "the files lack depth or motion";
    static_cast<void>(settings.upsampling->enlarged(size));
}

/// The picture and its alpha are all that is left of the frame.
void SequenceDenoiser::upsample(DenoisedFrame& frame) {
    if (!upsampler) upsampler.emplace(size, *settings.upsampling, settings.threads);
    auto const& front = window.front();
    upsampler->next(front.image, on_canvas.of_signals[0].channels, front.number, frame.picture, frame.alpha);
    frame.canvas = {0, 0, frame.picture.size.width, frame.picture.size.height};
    frame.signals.clear(), frame.guides.clear(), frame.added = {};
}

Purpose SequenceDenoiser::purpose_of(std::size_t signal) const {
    if (!settings.debug_views.empty()) return Purpose::watched;
    return !rule().alpha.empty() && has_alpha(signal) ? Purpose::with_alpha : Purpose::picture;
}

Denoiser& SequenceDenoiser::denoiser(std::size_t signal) {
    auto& made = denoisers[signal];
    if (made) return *made;
    auto const whole = io::detail::size_of(canvas);
    made = std::make_unique<Denoiser>(way_of(settings.preset, purpose_of(signal)), whole, settings.threads);
    if (!settings.diagnose && !checks) made->check_first_frames(), checks = true;
    if (settings.diagnose)
        made->diagnose(signal < on_canvas.of_signals.size() ? on_canvas.of_signals[signal].factor : std::vector<io::Source>());
    return *made;
}

bool SequenceDenoiser::is_inside(Region const& other) const {
    return other.x0 >= canvas.x0 && other.y0 >= canvas.y0 && other.x1 <= canvas.x1 && other.y1 <= canvas.y1;
}

void SequenceDenoiser::release_scratch() {
    window.clear();
    for (auto const& each : denoisers)
        if (each) each->release_scratch();
    for (auto const& each : choices)
        if (each) each->release_scratch();
    if (whole) whole->release_scratch();
    if (guides) guides->release_scratch();
    if (upsampler) upsampler->release_scratch();
}

void SequenceDenoiser::forget() {
    earlier.forget();
    earlier_milliseconds = milliseconds() - other_milliseconds;
    denoisers.clear();
    choices = {};
    whole.reset();
    guides.reset();
    upsampler.reset();
    window.clear();
    last.reset();
    lacking.reset();
    detail_before.reset();
    film.forget();
}

/// Each mistake once: it is most often in every frame, and guides are the same for all signals.
void SequenceDenoiser::collect(std::vector<Finding> const& findings) {
    for (auto const& finding : findings)
        if (known.insert(finding.mistake).second)
            found.push_back({finding.mistake, finding.evidence, finding.remedy + remedy_for_files(finding), finding.also, finding.or_else});
}

std::vector<std::string> SequenceDenoiser::planes(io::ExrListing const& file) const {
    auto planes = split_planes(file, on_canvas);
    if (anti_aliases())
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

std::vector<std::pair<std::string, DebugImage>> SequenceDenoiser::debug_images(std::string const& view) {
    std::vector<std::pair<std::string, DebugImage>> all;
    auto const& split = *window.front().ways[window.front().as_one ? 1 : 0];
    for (std::size_t s = 0; s < split.signals.size(); ++s) {
        if (!split.active[s]) continue;
        auto images = denoisers[s]->debug_images(view);
        auto const signal = has_several_signals(on_canvas) ? split.signals[s].name + "." : std::string();
        for (auto& image : images) {
            auto const part = images.size() > 1 ? image.signal + "." : std::string();
            all.emplace_back(signal + part + view, std::move(image));
        }
    }
    return all;
}

double SequenceDenoiser::milliseconds() const {
    double sum = earlier_milliseconds + other_milliseconds;
    for (auto const& denoiser : denoisers)
        if (denoiser) sum += denoiser->milliseconds();
    if (guides) sum += guides->milliseconds();
    if (upsampler) sum += upsampler->milliseconds();
    return whole ? sum + whole->milliseconds() : sum;
}

double SequenceDenoiser::bytes_per_pixel() const {
    double sum = 0;
    for (auto const& denoiser : denoisers)
        if (denoiser) sum += denoiser->bytes_per_pixel();
    for (auto const& choice : choices)
        if (choice) sum += static_cast<double>(choice->bytes()) / static_cast<double>(io::detail::size_of(canvas).pixels());
    if (guides) sum += guides->bytes_per_pixel();
    if (upsampler) sum += upsampler->bytes_per_pixel();
    if (lacking) sum += sizeof(glm::vec3);
    if (detail_before) sum += sizeof(glm::vec3);
    return whole ? sum + whole->bytes_per_pixel() : sum;
}

void SequenceDenoiser::read(FramePattern const& in, long long number) {
    io::ExrOriginal const file(in.path(number));
    if (denoisers.empty()) begin(file);
    if (!(file.listed.size == size))
        throw Error(file.listed.name, "it is " + to_string(file.listed.size) + " but the frames before it are " + to_string(size),
                    "denoise frames of one size, or each size by itself (--first, --last)");
    if (!is_inside(file.canvas())) {
        if (!window.empty())
            throw Error(file.listed.name, "it holds more around its display window than the frames before it", "denoise it without them");
        forget();
        begin(file);
        ++changes;
    }
    window.push_back(seen(file, number));
}

SequenceDenoiser::Seen SequenceDenoiser::seen(io::ExrOriginal const& file, long long number) const {
    Seen frame{number, file.read(planes(file.listed), canvas), false, {}, {}};
    frame.samples = samples_in(file.listed);
    if (refines()) frame.behind = names_behind_volume(frame.image, on_canvas);
    auto const& names = names_of(frame);
    if (anti_aliases()) frame.around = frame_around(frame.image, names, frame.samples);
    if (!on_canvas.view.empty()) frame.image.attributes = attributes_of_view(file, on_canvas);
    put_cameras_on_canvas(frame.image, size, canvas);
    auto split_by = rule();
    // Anti-aliasing takes the mean of several samples.
    bool const is_opaque = alpha.empty() || std::ranges::all_of(frame.image[alpha].values, [](float a) { return a == 1.f; });
    if (!is_opaque) frame.around.reset(); // colours of transparent film are those of what is hit, times its alpha
    if (frame.around) split_by.samples_of_guides = frame.around->policy.by_surface ? 4.f : 2.f;
    // Noise of guides is taken off the signals' picture: it is never filtered as one for that.
    if (frame.around && refines()) split_by.samples_of_guides = std::numeric_limits<float>::infinity();
    frame.as_one = is_better_as_one(frame.image, names, split_by);
    frame.has_noisy_guides = refines() && frame.around && !frame.as_one && is_better_as_one(frame.image, names, rule());
    return frame;
}

LightSplit const& SequenceDenoiser::split(Seen& seen, bool as_one) const {
    auto& way = seen.ways[as_one ? 1 : 0];
    if (!way) way = split_light(seen.image, names_of(seen), rule(), as_one);
    return *way;
}

/// Where the picture is filtered as one from this frame on, or by its signals, their histories become that of the picture, or the other way
/// round.
void SequenceDenoiser::hand_over(FramePattern const& in) {
    for (auto const& each : denoisers)
        if (each) each->drop_ahead();
    if (!std::filesystem::exists(in.path(*last))) return;
    auto const before = seen(io::ExrOriginal(in.path(*last)), *last);
    auto const shares = signal_shares(before.image, names_of(before), rule());
    auto const signals = on_canvas.of_signals.size();
    if (was_as_one) {
        auto const whole = denoiser(signals).remembered();
        for (std::size_t s = 0; s < signals && whole; ++s) denoiser(s).remember(part_of_history(*whole, shares, s));
        return;
    }
    std::vector<std::optional<HistoryContents>> parts;
    for (auto const& each : denoisers) {
        parts.push_back(each ? each->remembered() : std::nullopt);
        if (parts.back() && parts.back()->number != last) parts.back().reset(); // it had no light in the last frame
    }
    if (auto whole = whole_history(parts, shares)) denoiser(signals).remember(*whole);
}

/// A frame that is missing, broken or larger ends the window, and is dealt with when it is its turn: those before it are written whole.
void SequenceDenoiser::read_ahead(FramePattern const& in, long long number) {
    if (!looks_ahead(settings.preset) || !settings.debug_views.empty()) return;
    auto const farthest =
        anti_aliases() && settings.later_frames > 0 ? std::max(settings.later_frames, AntiAliased::most_frames) : settings.later_frames;
    for (auto later = window.back().number + 1; later <= number + farthest; ++later) {
        if (!std::filesystem::exists(in.path(later))) return;
        try {
            read(in, later);
        } catch (Error const&) {
            return;
        }
    }
}

/// Between a signal's light with its history, and by itself; null where its preset can't choose. It is not told the number of samples: this
/// history has seen later frames, and with the rule for 16 samples ten of ten scenes had more error.
quell_library::HistoryChoice* SequenceDenoiser::choice_for(std::size_t signal) {
    auto const purpose = purpose_of(signal);
    if (!can_choose_history(way_of(settings.preset, purpose))) return nullptr;
    auto& choice = choices[purpose == Purpose::with_alpha ? 1 : 0];
    if (!choice) choice = denoiser(signal).make_choice(way_of(quell_library::judge_of(settings.preset), purpose));
    return choice.get();
}

/// Whether light that was filtered out is given back. Shares are those of known numbers of samples. Light in a volume, which is a signal
/// without a colour, lies on no surface over which it could be smoothed, but where the frame is seen through it.
bool SequenceDenoiser::gives_light_back(Seen& seen) const {
    if (seen.samples < 1) return false;
    if (seen.behind) return true;
    for (std::size_t s = 0; s < on_canvas.of_signals.size() && has_several_signals(on_canvas); ++s)
        if (on_canvas.of_signals[s].factor.empty() && split(seen, false).active[s]) return false;
    return true;
}

/// What the filter took out of a signal's light by mistake.
/// @param alone the light by its frame alone
void SequenceDenoiser::feed_back_residual(io::ExrImage const& image, io::ChannelNames const& names, int count,
                                          metrics::Picture const& alone, metrics::Picture& light) {
    auto const planes = io::planes_of(Channels<Normal, Depth>{}, names);
    if (!image.has_all(planes)) return;
    Frame<Channels<Normal, Depth>> guides(image.size);
    io::load_channels(Channels<Normal, Depth>{}, guides, image, names);
    auto const samples = picture_of(image, io::sources_of(names, radiance), std::numeric_limits<float>::quiet_NaN());
    Timed const timed(other_milliseconds);
    quell::feed_back_residual({.samples = static_cast<float>(count), .shares = settings.feedback}, Threads<>{.count = settings.threads},
                              samples.pixels, guides[normal].view(), guides[depth].view(), alone.pixels, light.pixels);
}

DenoisedFrame SequenceDenoiser::next_frame(FramePattern const& in, long long number, bool is_wanted) {
    auto const show = [&](Seen const& seen) { earlier.start(seen.number), earlier.place() = seen.around; };
    while (!window.empty() && window.front().number != number) {
        if (window.front().number != last) show(window.front()), earlier.finish();
        window.pop_front();
    }
    if (window.empty()) read(in, number);
    read_ahead(in, number);
    auto& front = window.front();
    show(front);
    bool const as_one = front.as_one;
    if (last && *last + 1 == number && as_one != was_as_one) hand_over(in);
    for (auto& seen : window) {
        if (seen.number > number + settings.later_frames) break; // it is there for its guides
        for (std::size_t s = 0; auto const& signal : split(seen, as_one).signals)
            if (auto const signal_number = s++; split(seen, as_one).active[signal_number])
                denoiser(signal_number).look_ahead(seen.image, signal.channels, seen.number);
    }
    auto const& image = front.image;
    auto const& split = *front.ways[as_one ? 1 : 0];
    found.clear();
    DenoisedFrame frame;
    frame.canvas = canvas;
    bool const gives_back = refines() && is_wanted && gives_light_back(front);
    auto const denoised = [&](std::size_t s) {
        auto const& channels = split.signals[s].channels;
        auto* const choice = refines() && is_wanted ? choice_for(s) : nullptr;
        auto result = denoiser(s).denoise(image, channels, number, choice);
        if (gives_back) {
            auto const alone = choice != nullptr ? denoiser(s).alone(*choice) : std::nullopt;
            feed_back_residual(image, channels, front.samples, alone.value_or(result), result);
        }
        auto const counted = denoiser(s).statistics();
        missing += counted.missing_samples;
        // Guides are the same for all signals.
        if (std::ranges::find(split.active, true) - split.active.begin() == static_cast<std::ptrdiff_t>(s))
            repaired += counted.repaired_guides;
        collect(denoiser(s).findings());
        return result;
    };
    AntiAliasing anti_aliasing{front.around, earlier.before(), {}, settings.threads};
    for (std::size_t k = 1; k < std::min(window.size(), AntiAliased::most_frames + std::size_t{1}); ++k)
        anti_aliasing.after.push_back(window[k].around);
    frame.picture = composite(image, split, denoised, missing, frame.signals, [&](std::size_t s, metrics::Picture const* light) {
        Timed const timed(other_milliseconds);
        return anti_aliasing.product(s, light);
    });
    if (front.has_noisy_guides) take_off_noise_of_guides(frame, split);
    if (refines() && is_wanted) give_back_repeated(frame, split);
    if (accumulates_guides(settings.preset)) accumulate_guides(frame);
    if (!has_several_signals(on_canvas)) frame.signals.clear(); // it is the picture
    if (!alpha.empty()) denoise_alpha(frame, front, split);
    add_as_in_file(frame, image, split);
    if (settings.upsampling) upsample(frame);
    was_as_one = as_one, last = number, earlier.finish();
    return frame;
}

/// Where its surfaces were in the frame before; nothing where the file doesn't say.
std::optional<Frame<Channels<Motion>>> SequenceDenoiser::motion_of(Seen const& seen) const {
    auto const& channels = on_canvas.of_signals[0].channels;
    if (!seen.image.has_all(io::planes_of(Channels<Motion>{}, channels))) return std::nullopt;
    std::optional<Frame<Channels<Motion>>> vectors(std::in_place, seen.image.size);
    io::load_channels(Channels<Motion>{}, *vectors, seen.image, channels);
    return vectors;
}

/// What noisy guides add to the picture in their finest detail. It goes by the file and by the picture as one, so that it is the same in
/// frames that are denoised for those after them.
metrics::Picture SequenceDenoiser::detail_of_guides(RepeatedDetail const& rule, Seen const& seen, LightSplit const& light,
                                                    metrics::Picture const& as_one) const {
    auto const& colours = seen.around->colours;
    auto const signals = colours.size() - 1;
    metrics::Picture detail{seen.image.size, std::vector<glm::vec3>(as_one.pixels.size(), glm::vec3(0.f))};
    auto const add = [&](metrics::Picture const& part) {
        for (std::size_t i = 0; i < detail.pixels.size(); ++i) detail.pixels[i] += part.pixels[i];
    };
    for (std::size_t s = 0; s < signals; ++s) {
        if (colours[s].pixels.empty() || !light.active[s]) continue;
        auto product = picture_of(seen.image, io::sources_of(light.signals[s].channels, radiance), 0.f);
        for (std::size_t i = 0; i < product.pixels.size(); ++i) product.pixels[i] *= colours[s].pixels[i];
        limit_detail(rule, as_one, product); // of few bright samples
        add(detail_of_colour(rule, colours[s], product));
    }
    if (!colours[signals].pixels.empty()) add(finest_detail(rule, colours[signals]));
    limit_detail(rule, as_one, detail);
    return detail;
}

/// The picture as one has no noise of guides, and lacks their texture. Of what the signals have more in their finest detail, that part is
/// taken off which guides do not repeat from frame to frame. It is taken off the rest too, so that the signals stay the picture's.
void SequenceDenoiser::take_off_noise_of_guides(DenoisedFrame& frame, LightSplit const& light) {
    if (!whole) whole = std::make_unique<Denoiser>(way_of(settings.preset), io::detail::size_of(canvas), settings.threads);
    auto& front = window.front();
    auto const number = front.number;
    for (auto& seen : window) {
        if (seen.number > number + settings.later_frames) break;
        auto const& channels = split(seen, true).signals.back().channels;
        whole->look_ahead(seen.image, channels, seen.number);
    }
    auto const as_one = whole->denoise(front.image, split(front, true).signals.back().channels, number);
    Timed const timed(other_milliseconds);
    auto const vectors = motion_of(front);
    if (!vectors) return;
    RepeatedDetail const rule;
    auto guides = detail_of_guides(rule, front, light, as_one);
    bool const follows = detail_before && detail_before->first + 1 == number;
    auto const shares =
        repeated_share(rule, guides, as_one, (*vectors)[motion].view(), follows ? detail_before->second : metrics::Picture{});
    auto difference = frame.picture;
    for (std::size_t i = 0; i < difference.pixels.size(); ++i) difference.pixels[i] -= as_one.pixels[i];
    auto const detail = finest_detail(rule, std::move(difference));
    auto& rest = frame.signals.back().pixels;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        auto const noise = (1.f - shares[i]) * detail.pixels[i];
        frame.picture.pixels[i] -= noise, rest[i] -= noise;
    }
    detail_before.emplace(number, std::move(guides));
}

/// What this picture and the one before both lack of their samples. It is added to the rest too, so that the signals stay the picture's.
void SequenceDenoiser::give_back_repeated(DenoisedFrame& frame, LightSplit const& split) {
    auto const& front = window.front();
    auto const vectors = motion_of(front);
    if (!vectors) return;
    std::vector<bool> is_missing(front.image.pixels());
    auto const samples_of = [&](std::size_t s) {
        auto samples =
            picture_of(front.image, io::sources_of(split.signals[s].channels, radiance), std::numeric_limits<float>::quiet_NaN());
        for (std::size_t i = 0; i < is_missing.size(); ++i)
            is_missing[i] = is_missing[i] || !detail::is_light(vec3<float>(samples.pixels[i]));
        return samples;
    };
    long long not_finite = 0;
    std::vector<metrics::Picture> parts;
    auto samples = composite(front.image, split, samples_of, not_finite, parts);
    for (std::size_t i = 0; i < is_missing.size(); ++i)
        if (is_missing[i]) samples.pixels[i] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    Timed const timed(other_milliseconds);
    bool const follows = lacking && lacking->first + 1 == front.number && lacking->second.size() == samples.pixels.size();
    auto const given = frame.picture.pixels;
    lacking.emplace(front.number, quell::give_back_repeated({.samples = static_cast<float>(std::max(front.samples, 1))}, samples.pixels,
                                                            (*vectors)[motion].view(), follows ? lacking->second : std::vector<glm::vec3>(),
                                                            frame.picture.pixels));
    auto& rest = frame.signals.back().pixels;
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] += frame.picture.pixels[i] - given[i];
}

/// Frames that follow want those before, whether or not they are shown.
void SequenceDenoiser::accumulate_guides(DenoisedFrame& frame) {
    if (!guides) guides.emplace(settings.preset, settings.threads);
    frame.guides = guides->next(window.front().image, on_canvas, window.front().number);
}

/// Layers are added up with what the file adds: of what a split takes of that, or scales down, the rest has the difference.
void SequenceDenoiser::add_as_in_file(DenoisedFrame& frame, io::ExrImage const& image, LightSplit const& split) const {
    auto const& added = on_canvas.added;
    for (std::size_t c = 0; c < added.size(); ++c)
        for (auto const& plane : added[c].sum) // the offset is added once
            frame.added[c].push_back({&image[plane].values, added[c].scale, frame.added[c].empty() ? added[c].offset : 0.f});
    if (added.empty() || io::planes_of(split.added) == io::planes_of(added)) return;
    auto const taken = picture_of(image, split.added, 0.f), whole = picture_of(image, added, 0.f);
    auto& rest = frame.signals.back().pixels;
    for (std::size_t i = 0; i < rest.size(); ++i)
        if (auto const off = taken.pixels[i] - whole.pixels[i]; is_finite(off.x) && is_finite(off.y) && is_finite(off.z)) rest[i] += off;
}

SplitRule SequenceDenoiser::rule() const {
    bool const can = settings.preset.two_sided_alpha && !settings.keeps_alpha && settings.debug_views.empty();
    return {.by_albedo = settings.preset.by_albedo, .alpha = can ? alpha : ""};
}

/// The only signal, where it has no factor, or else the rest: as split_light() gives it.
bool SequenceDenoiser::has_alpha(std::size_t signal) const {
    bool const is_rest = signal == on_canvas.of_signals.size();
    return is_rest || (!has_several_signals(on_canvas) && on_canvas.of_signals[signal].factor.empty());
}

void SequenceDenoiser::denoise_alpha(DenoisedFrame& frame, Seen const& seen, LightSplit const& split) {
    auto const& given = seen.image[alpha].values;
    frame.alpha = rule().alpha.empty() ? given : split.kept_alpha;
    if (split.alpha_with)
        for (std::size_t i = 0; i < frame.alpha.size(); ++i) frame.alpha[i] += denoiser(*split.alpha_with).alpha()[i];
    if (split.shares_alpha) limit_alpha(frame.alpha, given, seen.image.size);
    bool const is_opaque = std::ranges::all_of(given, [](float a) { return a == 1.f; });
    alpha_stays = alpha_stays || (!is_opaque && rule().alpha.empty() && !settings.keeps_alpha);
    auto const& channels = on_canvas.of_signals[0].channels;
    auto const planes = io::planes_of(Channels<Motion>{}, channels);
    Frame<Channels<Motion>> vectors(seen.image.size);
    // A preset that reads no motion has no history.
    if (seen.image.has_all(planes))
        io::load_channels(Channels<Motion>{}, vectors, seen.image, channels);
    else
        film.forget();
    film.clear_empty(frame, given, vectors);
}

metrics::Picture SequenceDenoiser::next(FramePattern const& in, long long number) { return displayed(next_whole(in, number).picture); }

metrics::Picture SequenceDenoiser::displayed(metrics::Picture const& whole) const {
    if (settings.upsampling || whole.size == size) return whole;
    metrics::Picture part{size, {}};
    for (int y = 0; y < size.height; ++y) {
        auto const begin = whole.pixels.begin() + static_cast<std::ptrdiff_t>(y - canvas.y0) * whole.size.width - canvas.x0;
        part.pixels.insert(part.pixels.end(), begin, begin + size.width);
    }
    return part;
}

void DenoisedFrame::added_at(std::size_t pixel, int component, std::vector<float>& values) const {
    values.clear();
    bool finite = true;
    for (auto const& planes : added)
        for (auto const& plane : planes) finite = finite && is_finite((*plane.values)[pixel]);
    for (auto const& plane : added[static_cast<std::size_t>(component)])
        if (finite) values.push_back((*plane.values)[pixel] * plane.scale + plane.offset);
}

} // namespace quell::examples
