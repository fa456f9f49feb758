#include <denoise/composite.hpp>
#include <denoise/sequence_denoiser.hpp>

namespace quell::examples {

namespace {

/// The change that a file's user can make to mend a mistake, where there is one beside that of the host's code.
std::string in_the_map(Mistake mistake) {
    switch (mistake) {
    case Mistake::motion_sign:
        return "; for files, set \"points\" of \"motion\" in --map";
    case Mistake::motion_unit:
        return "; for files, set \"unit\" of \"motion\" in --map";
    case Mistake::motion_y:
        return "; for files, set \"y\" of \"motion\" in --map";
    case Mistake::depth_of_misses:
        return "; for files, set \"miss_from\" in --map";
    case Mistake::signal_demodulated:
        return "; for files, write \"irradiance\" in place of \"radiance\" in --map";
    default:
        return {};
    }
}
std::string remedy_for_files(Finding const& finding) {
    auto text = in_the_map(finding.mistake);
    for (auto const mistake : finding.also) text += in_the_map(mistake);
    return text;
}

void check_debug_views(Preset const& preset, std::vector<std::string> const& views) {
    if (views.empty()) return;
    if (!preset.make_watched)
        throw Error("--debug-view", "preset '" + preset.name + "' has none",
                    "choose one with a history, such as svgf; of trmv, its parts shadow, glossy and dual-cone");
    auto const watched = preset.make_watched({1, 1});
    for (auto const& view : views)
        if (!watched->has_debug_view(view))
            throw Error("--debug-view", "preset '" + preset.name + "' has no " + view,
                        "leave it out, or choose a preset that clamps, such as surface-clamp");
}

} // namespace

SequenceDenoiser::SequenceDenoiser(SequenceSettings settings_) : settings(std::move(settings_)) {
    check_debug_views(settings.preset, settings.debug_views);
}

void SequenceDenoiser::begin(io::ExrFile const& file) {
    if (!settings.map) settings.map = io::recognise(file);
    if (settings.shutter)
        for (auto& signal : settings.map->of_signals) signal.channels.shutter = settings.shutter;
    size = file.size;
    auto const& preset = settings.preset;
    for (std::size_t s = 0; s < settings.map->of_signals.size(); ++s)
        denoisers.push_back(!settings.debug_views.empty() ? preset.make_watched(size) : preset.make(size, settings.threads));
    for (auto const& denoiser : denoisers)
        if (settings.diagnose) denoiser->diagnose();
}

/// Each mistake once: it is most often in every frame, and guides are the same for all signals.
void SequenceDenoiser::collect(std::vector<Finding> const& findings) {
    for (auto const& finding : findings)
        if (known.insert(finding.mistake).second)
            found.push_back({finding.mistake, finding.evidence, finding.remedy + remedy_for_files(finding), finding.also, finding.or_else});
}

std::vector<std::string> SequenceDenoiser::planes(io::ExrFile const& file) const {
    auto planes = composite_planes(*settings.map);
    for (std::size_t s = 0; s < denoisers.size(); ++s) {
        auto const& channels = settings.map->of_signals[s].channels;
        auto const more = denoisers[s]->planes(channels);
        planes.insert(planes.end(), more.begin(), more.end());
        for (auto const& plane : denoisers[s]->optional_planes(channels))
            if (file.find(plane)) planes.push_back(plane);
    }
    return planes;
}

std::vector<std::pair<std::string, DebugImage>> SequenceDenoiser::debug_images(std::string const& view) {
    std::vector<std::pair<std::string, DebugImage>> all;
    for (std::size_t s = 0; s < denoisers.size(); ++s) {
        auto images = denoisers[s]->debug_images(view);
        auto const signal = denoisers.size() > 1 ? settings.map->of_signals[s].name + "." : std::string();
        for (auto& image : images) {
            auto const part = images.size() > 1 ? image.signal + "." : std::string();
            all.emplace_back(signal + part + view, std::move(image));
        }
    }
    return all;
}

double SequenceDenoiser::milliseconds() const {
    double sum = 0;
    for (auto const& denoiser : denoisers) sum += denoiser->milliseconds();
    return sum;
}

double SequenceDenoiser::bytes_per_pixel() const {
    double sum = 0;
    for (auto const& denoiser : denoisers) sum += denoiser->bytes_per_pixel();
    return sum;
}

void SequenceDenoiser::read(FramePattern const& in, long long number) {
    io::ExrFile const file(in.path(number));
    if (denoisers.empty()) begin(file);
    if (!(file.size == size))
        throw Error(file.name, "it is " + to_string(file.size) + " but the frames before it are " + to_string(size),
                    "denoise frames of one size, or each size by itself (--first, --last)");
    auto image = file.read(planes(file));
    for (std::size_t s = 0; s < denoisers.size(); ++s) denoisers[s]->look_ahead(image, settings.map->of_signals[s].channels, number);
    window.push_back({number, std::move(image)});
}

/// A frame that is missing or broken ends the window, and is complained of when it is its turn: those before it are written whole.
void SequenceDenoiser::read_ahead(FramePattern const& in, long long number) {
    if (!settings.preset.looks_ahead || !settings.debug_views.empty()) return;
    for (auto later = window.back().number + 1; later <= number + settings.later_frames; ++later) {
        if (!std::filesystem::exists(in.path(later))) return;
        try {
            read(in, later);
        } catch (Error const&) {
            return;
        }
    }
}

metrics::Picture SequenceDenoiser::next(FramePattern const& in, long long number) {
    while (!window.empty() && window.front().number != number) window.pop_front();
    if (window.empty()) read(in, number);
    read_ahead(in, number);
    auto const& image = window.front().image;
    found.clear();
    return composite(
        image, *settings.map,
        [&](std::size_t s) {
            auto result = denoisers[s]->denoise(image, settings.map->of_signals[s].channels, number);
            missing += denoisers[s]->missing_samples();
            collect(denoisers[s]->findings());
            return result;
        },
        missing);
}

} // namespace quell::examples
