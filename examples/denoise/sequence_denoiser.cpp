#include <denoise/composite.hpp>
#include <denoise/converted_history.hpp>
#include <denoise/file_remedies.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/sequence_denoiser.hpp>

#include <quell/core/real.hpp>

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

/// Tells what came back of what frames in a row lack.
void tell_repeated(StageAccount& why, LinearView const& before, LinearView const& after, ResidualLinks::Refusal refusal) {
    auto& [trust, same] = refusal;
    double sum = 0;
    for (float& part : same) sum += static_cast<double>(part), part = 1.f - trust * (1.f - part);
    double const left_out = sum / static_cast<double>(std::max<std::size_t>(same.size(), 1)), shared = 1. - static_cast<double>(trust);
    why.refused(same);
    StageRow row{"picture", Stage::repeated, why.changed(Stage::repeated, before, after), 1. - (1. - shared) * (1. - left_out)};
    row.is_broken = row.refused > 0.;
    if (row.is_broken) row.reason = shared > left_out ? noise_is_shared : noise_is_the_same;
    why.add(std::move(row));
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

} // namespace

SequenceDenoiser::SequenceDenoiser(SequenceSettings settings) : frames(std::move(settings)), links(frames.settings.threads) {
    check_debug_views(frames.settings.preset, frames.settings.debug_views);
}

/// The picture and its alpha are all that is left of the frame.
void SequenceDenoiser::upsample(DenoisedFrame& frame, SeenFrame& seen) {
    if (!upsampler) upsampler.emplace(frames.size(), *frames.settings.upsampling, frames.settings.threads);
    upsampler->next(seen, frames.guide_names(), frame.picture, frame.alpha);
    frame.canvas = {0, 0, frame.picture.size.width, frame.picture.size.height};
    frame.signals.clear(), frame.guides.clear(), frame.added = {};
}

void SequenceDenoiser::begin(io::ExrOriginal const& file) {
    frames.begin(file);
    denoisers.resize(frames.names().of_signals.size() + 1);
}

Purpose SequenceDenoiser::purpose_of(std::size_t signal) const {
    if (!frames.settings.debug_views.empty()) return Purpose::watched;
    return frames.carries_alpha() && frames.has_alpha(signal) ? Purpose::with_alpha : Purpose::picture;
}

Denoiser& SequenceDenoiser::denoiser(std::size_t signal) {
    auto& made = denoisers[signal];
    if (made) return *made;
    auto const whole = frames.canvas_size();
    made = std::make_unique<Denoiser>(way_of(frames.settings.preset, purpose_of(signal)), whole, frames.settings.threads);
    made->put_behind(frames.settings.stages);
    if (!frames.settings.diagnose && !checks) made->check_first_frames(), checks = true;
    if (frames.settings.diagnose)
        made->diagnose(signal < frames.names().of_signals.size() ? frames.names().of_signals[signal].factor : std::vector<io::Source>());
    return *made;
}

void SequenceDenoiser::release_scratch() {
    window.clear();
    current.reset();
    if (ahead) ahead->seen.image = {}, ahead->seen.ways = {}, ahead->seen.guides = {};
    for (auto const& each : denoisers)
        if (each) each->release_scratch();
    for (auto const& each : choices)
        if (each) each->release_scratch();
    if (whole) whole->release_scratch();
    alpha.release_scratch(), links.release_scratch();
    if (guides) guides->release_scratch();
    if (upsampler) upsampler->release_scratch();
}

void SequenceDenoiser::forget() {
    earlier.forget();
    earlier_milliseconds = milliseconds() - other_milliseconds;
    denoisers.clear();
    choices = {};
    whole.reset();
    alpha.forget();
    guides.reset();
    upsampler.reset();
    window.clear();
    last.reset();
    current.reset();
    ahead.reset();
    refiner.forget(), links.forget();
    film.forget();
}

/// Each mistake once: it is most often in every frame, and guides are the same for all signals.
void SequenceDenoiser::collect(std::vector<Finding> const& findings, std::vector<Finding>& into) {
    for (auto const& finding : findings)
        if (known.insert(finding.mistake).second)
            into.push_back({finding.mistake, finding.evidence, finding.remedy + remedy_for_files(finding), finding.also, finding.or_else});
}

std::vector<std::pair<std::string, DebugImage>> SequenceDenoiser::debug_images(std::string const& view) {
    std::vector<std::pair<std::string, DebugImage>> all;
    auto const& split = *current->seen.ways[current->seen.as_one ? 1 : 0];
    for (std::size_t s = 0; s < split.signals.size(); ++s) {
        if (!split.active[s]) continue;
        auto images = denoisers[s]->debug_images(view);
        auto const signal = has_several_signals(frames.names()) ? split.signals[s].name + "." : std::string();
        for (auto& image : images) {
            auto const part = images.size() > 1 ? image.signal + "." : std::string();
            all.emplace_back(signal + part + view, std::move(image));
        }
    }
    return all;
}

double SequenceDenoiser::milliseconds() const {
    double sum = earlier_milliseconds + other_milliseconds + alpha.milliseconds();
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
        if (choice) sum += static_cast<double>(choice->bytes()) / static_cast<double>(frames.canvas_size().pixels());
    if (guides) sum += guides->bytes_per_pixel();
    if (upsampler) sum += upsampler->bytes_per_pixel();
    sum += refiner.bytes_per_pixel() + links.bytes_per_pixel() + alpha.bytes_per_pixel();
    if (ahead) // its picture, what that lacks, and its signals
        sum +=
            static_cast<double>((2 + ahead->frame.signals.size()) * sizeof(glm::vec3) + (frames.alpha_plane().empty() ? 0 : sizeof(float)));
    return whole ? sum + whole->bytes_per_pixel() : sum;
}

/// @param is_ahead whether frames before it are not finished
void SequenceDenoiser::read(FramePattern const& in, long long number, bool is_ahead) {
    io::ExrOriginal const file(in.path(number));
    if (denoisers.empty()) begin(file);
    if (!(file.listed.size == frames.size()))
        throw Error(file.listed.name, "it is " + to_string(file.listed.size) + " but the frames before it are " + to_string(frames.size()),
                    "denoise frames of one size, or each size by itself (--first, --last)");
    if (!frames.is_inside(file.canvas())) {
        if (is_ahead)
            throw Error(file.listed.name, "it holds more around its display window than the frames before it", "denoise it without them");
        forget();
        begin(file);
        ++changes;
    }
    window.push_back(frames.seen(file, number));
    if (window.size() > 1) frames.tell_next(window[window.size() - 2]);
}

/// Where the picture is filtered as one from this frame on, or by its signals, their histories become that of the picture, or the other way
/// round.
void SequenceDenoiser::hand_over(FramePattern const& in) {
    for (auto const& each : denoisers)
        if (each) each->drop_ahead();
    alpha.drop_ahead();
    if (!std::filesystem::exists(in.path(*last))) return;
    auto const before = frames.seen(io::ExrOriginal(in.path(*last)), *last);
    auto const shares = signal_shares(before.image, frames.names_of(before), frames.rule());
    auto const signals = frames.names().of_signals.size();
    if (was_as_one) {
        auto const whole = denoiser(signals).remembered();
        for (std::size_t s = 0; s <= signals && whole; ++s) denoiser(s).remember(part_of_history(*whole, shares, s));
        return;
    }
    std::vector<std::optional<HistoryContents>> parts;
    for (auto const& each : denoisers) {
        parts.push_back(each ? each->remembered() : std::nullopt);
        if (parts.back() && parts.back()->number != last) parts.back().reset(); // it had no light in the last frame
    }
    // Signals without alpha have none in their history.
    auto const carried = frames.carries_alpha() && !frames.has_alpha(0) ? alpha.with_light() : std::vector<float>();
    if (auto whole = whole_history(parts, shares, carried)) denoiser(signals).remember(*whole);
}

/// A frame that is missing, broken or larger ends the window, and is dealt with when it is its turn: those before it are written whole.
void SequenceDenoiser::read_ahead(FramePattern const& in, long long number) {
    for (auto later = window.back().number + 1; later <= number + frames.settings.frames_ahead(); ++later) {
        if (!std::filesystem::exists(in.path(later))) return;
        try {
            read(in, later, true);
        } catch (Error const&) {
            return;
        }
    }
}

/// Between a signal's light with its history, and by itself; null where its preset can't choose.
quell_library::HistoryChoice* SequenceDenoiser::choice_for(std::size_t signal) {
    auto const purpose = purpose_of(signal);
    if (!can_choose_history(way_of(frames.settings.preset, purpose))) return nullptr;
    auto& choice = choices[purpose == Purpose::with_alpha ? 1 : 0];
    if (!choice) choice = denoiser(signal).make_choice(way_of(quell_library::judge_of(frames.settings.preset), purpose));
    choice->tell_samples(static_cast<float>(window.front().samples));
    return choice.get();
}

/// Why light that was filtered out is not given back; empty: it is. Shares are those of known numbers of samples. Light in a volume, which
/// is a signal without a colour, lies on no surface over which it could be smoothed, but where the frame is seen through it. Into the alpha
/// of a film that is not opaque nothing would come back, so that colours would no longer be those of what covers it.
std::string SequenceDenoiser::against_giving_back(SeenFrame& seen) const {
    if (seen.samples < 1) return "the file does not say how many samples a pixel has";
    if (!seen.is_opaque) return "the film is not opaque";
    if (seen.behind) return {};
    for (std::size_t s = 0; s < frames.names().of_signals.size() && has_several_signals(frames.names()); ++s)
        if (frames.names().of_signals[s].factor.empty() && frames.split(seen, false).active[s])
            return "light in a volume lies on no surface";
    return {};
}

std::string SequenceDenoiser::name_of(std::size_t signal) const {
    auto const& signals = frames.names().of_signals;
    return !has_several_signals(frames.names()) ? "picture" : signal < signals.size() ? signals[signal].name : rest_name;
}

/// @param light  what was chosen of what is there with history and without
/// @param factor of the light
void SequenceDenoiser::tell_history(StageAccount& why, std::size_t signal, quell_library::HistoryChoice& choice, LinearView const& light,
                                    LinearView const& factor) {
    auto const refused = 1. - static_cast<double>(choice.trust());
    StageRow row{name_of(signal), Stage::history, 0, refused, refused > 0. ? noise_is_shared : "", refused > 0.};
    if (why.is_gathered()) {
        auto const with = denoiser(signal).with_history(choice), alone = denoiser(signal).alone(choice);
        if (with && alone) row.share = why.chosen(*with, *alone, light, factor);
        if (!with) row.share = 1., row.reason = "no frame before is known";
    }
    why.add(std::move(row));
}

DenoisedFrame SequenceDenoiser::next_frame(FramePattern const& in, long long number, bool is_wanted) {
    current.reset();
    bool const is_there = ahead && ahead->seen.number == number;
    current = is_there ? std::exchange(ahead, std::nullopt) : denoised(in, number, is_wanted);
    ahead.reset();
    auto& seen = current->seen;
    if (seen.image.planes.empty()) seen = frames.seen(io::ExrOriginal(in.path(number)), number); // its memory was given back
    if (is_wanted && sees_next(seen)) denoise_ahead(in, number + 1);
    found = current->found, missing += current->missing, repaired += current->repaired;
    return finished(*current);
}

/// Whether the picture of the frame after takes part in this frame's.
bool SequenceDenoiser::sees_next(SeenFrame const& seen) const {
    return frames.settings.is_refined() && frames.settings.later_frames > 0 &&
           seen.image.has_all(io::planes_of(Channels<Motion, MotionNext>{}, frames.guide_names()));
}

/// A frame that is missing or broken is dealt with when it is its turn.
void SequenceDenoiser::denoise_ahead(FramePattern const& in, long long number) {
    if (!std::filesystem::exists(in.path(number))) return;
    try {
        if (window.empty()) read(in, number, true);
        ahead = denoised(in, number, true);
    } catch (Error const&) {
        return;
    }
}

/// The next frame, but for what the one after it tells of its picture.
SequenceDenoiser::DenoisedSignals SequenceDenoiser::denoised(FramePattern const& in, long long number, bool is_wanted) {
    auto const show = [&](SeenFrame const& seen) { earlier.start(seen.number), earlier.place() = seen.around; };
    for (; !window.empty() && window.front().number != number; window.pop_front()) show(window.front()), earlier.finish();
    if (window.empty()) read(in, number, false);
    read_ahead(in, number);
    auto& front = window.front();
    show(front);
    bool const as_one = front.as_one;
    if (last && *last + 1 == number && as_one != was_as_one) hand_over(in);
    for (auto& seen : window) {
        if (seen.number > number + frames.settings.later_frames) break; // it is there for its guides
        for (std::size_t s = 0; auto const& signal : frames.split(seen, as_one).signals)
            if (auto const signal_number = s++; frames.split(seen, as_one).active[signal_number]) {
                LayoutChanges::Of const of(signal.name);
                denoiser(signal_number).look_ahead(seen.image, signal.channels, seen.number, seen.guides);
            }
        alpha.look_ahead(frames.settings.preset, frames.canvas_size(), frames.settings.threads, seen, frames.split(seen, as_one));
    }
    auto const& image = front.image;
    auto const& split = *front.ways[as_one ? 1 : 0];
    DenoisedSignals made;
    auto& frame = made.frame;
    frame.canvas = frames.region();
    bool const is_refined = frames.settings.is_refined() && is_wanted;
    auto const against = is_refined ? against_giving_back(front) : std::string();
    auto& why = made.why = StageAccount(frames.settings.accounts && is_wanted);
    why.add_samples(front.said_samples, front.samples);
    auto const denoised_signal = [&](std::size_t s) {
        auto const& channels = split.signals[s].channels;
        LayoutChanges::Of const of(split.signals[s].name);
        auto* const choice = frames.settings.is_judged() && is_wanted ? choice_for(s) : nullptr;
        auto result = denoiser(s).denoise(image, channels, number, choice);
        auto const factor = why.is_gathered() ? picture_of(image, split.signals[s].factor, 1.f) : ReadPicture();
        if (choice != nullptr) tell_history(why, s, *choice, result, factor);
        if (is_refined && against.empty()) {
            auto const count = static_cast<float>(front.samples);
            bool const is_steady = denoiser(s).statistics().frames > 1 && choice == nullptr;
            auto const before = why.before(result);
            Timed const timed(other_milliseconds);
            auto const trust = links.feed_back(
                denoiser(s), is_steady ? ResidualFeedbackShares::beside_history(count) : ResidualFeedbackShares::of_samples(count), result);
            why.add_feedback(name_of(s), why.changed(Stage::feedback, before, result, factor), trust);
        } else if (is_refined)
            why.add({name_of(s), Stage::feedback, 0, 1, against});
        auto const counted = denoiser(s).statistics();
        made.missing += counted.missing_samples;
        // Guides are the same for all signals.
        if (std::ranges::find(split.active, true) - split.active.begin() == static_cast<std::ptrdiff_t>(s))
            made.repaired += counted.repaired_guides;
        collect(denoiser(s).findings(), made.found);
        return ReadPicture(std::move(result));
    };
    AntiAliasing anti_aliasing{front.around, earlier.before(), {}, frames.settings.threads, front.has_noisy_guides};
    for (std::size_t k = 1; k < std::min(window.size(), AntiAliased::most_frames + std::size_t{1}); ++k)
        anti_aliasing.after.push_back(window[k].around);
    frame.picture = composite(image, split, denoised_signal, made.missing, frame.signals, [&](std::size_t s, LinearView const* light) {
        Timed const timed(other_milliseconds);
        return anti_aliasing.product(s, light, name_of(s), why);
    });
    if (front.has_noisy_guides) {
        auto const whole_picture = denoised_as_one(front);
        Timed const timed(other_milliseconds);
        auto const before = why.before(frame.picture);
        refiner.take_off_noise_of_guides(front, frames.guide_names(), frames.names_of(front), split, whole_picture, frame);
        why.add({"picture", Stage::guide_noise, why.changed(Stage::guide_noise, before, frame.picture)});
    }
    if (frames.settings.is_refined() && front.is_opaque && is_wanted) {
        Timed const timed(other_milliseconds);
        made.samples = samples_of_picture(front, frames.guide_names(), split);
    }
    if (!frames.alpha_plane().empty()) frame.alpha = denoised_alpha(front, split);
    if (!front.is_opaque) made.shown = shown_from_now_on(window, frames.settings.later_frames, frames.guide_names());
    was_as_one = as_one, last = number, earlier.finish();
    made.seen = std::move(front);
    window.pop_front();
    return made;
}

/// What comes out of it, in the order of frames.
DenoisedFrame SequenceDenoiser::finished(DenoisedSignals& signals) {
    auto& seen = signals.seen;
    auto& frame = signals.frame;
    if (!signals.samples.empty()) {
        LayoutChanges::Of const of("picture");
        Timed const timed(other_milliseconds);
        auto const& names = frames.guide_names();
        std::optional<PictureOfSamples> after;
        if (ahead && !ahead->samples.empty()) after.emplace(PictureOfSamples{ahead->samples, ahead->frame.picture});
        auto const given = std::exchange(frame.picture, LinearPicture(frame.picture.size));
        auto refusal = links.give_back_repeated({signals.samples, given, seen.guide(motion, names), seen.guide(motion_next, names)},
                                                seen.number, seen.samples, after ? &*after : nullptr, frame.picture);
        tell_repeated(signals.why, given, frame.picture, std::move(refusal));
        change_signals(frame, given);
    }
    signals.why.finish(frame.picture, frames.settings.is_refined() ? "nothing to do, or the files lack what it wants"
                                                                   : "left out: by --quick, --stages or the preset");
    if (accumulates_guides(frames.settings.preset)) accumulate_guides(frame, seen);
    if (!has_several_signals(frames.names())) frame.signals.clear(); // it is the picture
    if (!frames.alpha_plane().empty()) film.clear_empty(frame, signals.shown, seen.guide(motion, frames.guide_names()));
    add_as_in_file(frame, seen.image, frames.split(seen, seen.as_one));
    if (frames.settings.upsampling) upsample(frame, seen);
    return std::move(frame);
}

/// The picture of a frame of the window, which is its first, denoised as one.
LinearPicture SequenceDenoiser::denoised_as_one(SeenFrame& front) {
    if (!whole) whole = std::make_unique<Denoiser>(way_of(frames.settings.preset), frames.canvas_size(), frames.settings.threads);
    for (auto& seen : window) {
        if (seen.number > front.number + frames.settings.later_frames) break;
        whole->look_ahead(seen.image, frames.split(seen, true).signals.back().channels, seen.number, seen.guides);
    }
    return whole->denoise(front.image, frames.split(front, true).signals.back().channels, front.number);
}

/// Frames that follow want those before, whether or not they are shown.
void SequenceDenoiser::accumulate_guides(DenoisedFrame& frame, SeenFrame& seen) {
    if (!guides) guides.emplace(frames.settings.preset, frames.settings.threads);
    frame.guides = guides->next(seen.image, frames.names(), seen.number, seen.guides);
}

/// Layers are added up with what the file adds: of what a split takes of that, or scales down, the rest has the difference.
void SequenceDenoiser::add_as_in_file(DenoisedFrame& frame, io::ExrImage const& image, LightSplit const& split) const {
    auto const& added = frames.names().added;
    for (std::size_t c = 0; c < added.size(); ++c)
        for (auto const& plane : added[c].sum) // the offset is added once
            frame.added[c].push_back({&image[plane].values, added[c].scale, frame.added[c].empty() ? added[c].offset : 0.f});
    if (added.empty() || io::planes_of(split.added) == io::planes_of(added)) return;
    auto const taken = picture_of(image, split.added, 0.f), whole = picture_of(image, added, 0.f);
    auto& rest = frame.signals.back();
    for (std::size_t i = 0; i < rest.pixels(); ++i)
        if (auto const off = taken[i] - whole[i]; all_finite(off)) rest[i] += off;
}

std::vector<float> SequenceDenoiser::denoised_alpha(SeenFrame const& seen, LightSplit const& split) {
    alpha_stays = alpha_stays || (!seen.is_opaque && !frames.carries_alpha() && !frames.settings.keeps_alpha);
    auto const& given = seen.image[frames.alpha_plane()].values;
    if (split.kept_alpha.empty()) return given;
    auto values = split.kept_alpha;
    if (split.alpha_with)
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += denoiser(*split.alpha_with).alpha()[i];
    return alpha.complete(std::move(values), given, seen, split);
}

metrics::Picture SequenceDenoiser::next(FramePattern const& in, long long number) { return displayed(next_whole(in, number).picture); }

} // namespace quell::examples
