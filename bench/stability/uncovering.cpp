#include "cases.hpp"
#include "watch.hpp"

#include <tracer/scenes/scenes.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>

namespace quell::stability {
namespace {

constexpr int event = static_cast<int>(tracer::event_frame);

/// One method against another, in every frame.
void never_worse(std::string const& name, Sequence const& sequence, std::string const& method, std::string const& than, int threads,
                 Results& results) {
    auto const a = errors(sequence, watch(examples::preset_of(method), sequence, {}, threads));
    auto const b = errors(sequence, watch(examples::preset_of(than), sequence, {}, threads));
    record(results, name, method, a);
    record(results, name, than + "-beside-" + method, b);
    results.promises.push_back({name, method, "worst_frame_over_" + than, worst_ratio(a, b), 1});
}

void leaves(std::string const& name, Making const& making, Results& results) {
    auto const shot = [](Signal signal) { return Shot{.scene = "leaves", .signal = signal, .scored_from = event - 1, .last = event + 8}; };
    auto const indirect = traced(shot(Signal::indirect), making), shadow = traced(shot(Signal::shadow), making);
    never_worse(name, indirect, "dual-color", "surface", making.threads, results);
    never_worse(name, indirect, "dual-cone", "surface", making.threads, results);
    never_worse(name, shadow, "shadow", "surface", making.threads, results);
}

/// The pixels whose past is outside the image.
metrics::Mask unseen(io::ExrImage const& frame) {
    auto const &x = frame["motion.X"].values, &y = frame["motion.Y"].values;
    metrics::Mask mask;
    for (int row = 0; row < frame.size.height; ++row)
        for (int column = 0; column < frame.size.width; ++column) {
            auto const i = mask.size();
            float const px = static_cast<float>(column) + 0.5f + x[i], py = static_cast<float>(row) + 0.5f + y[i];
            bool const inside =
                px >= 0 && py >= 0 && px <= static_cast<float>(frame.size.width) && py <= static_cast<float>(frame.size.height);
            mask.push_back(inside ? 0 : 1);
        }
    return mask;
}

/// In the strip that comes into the image there is no past: whatever is taken for it must be better than nothing.
void pan(std::string const& name, Making const& making, Results& results) {
    auto sequence = traced({.scene = "pan", .signal = Signal::indirect, .scored_from = event, .last = event + 8}, making);
    for (int i = event; i <= sequence.last(); ++i) sequence.masks.push_back(unseen(sequence.frame(i)));
    std::map<std::string, Errors> kept;
    for (std::string const method : {"surface", "surface-clamp", "svgf", "dual-color", "dual-cone"}) {
        auto const& preset = examples::preset_of(method);
        kept[method] = errors(sequence, watch(preset, sequence, {}, making.threads));
        auto const none = errors(sequence, watch(preset, sequence, {Memory::Kind::none}, making.threads));
        record(results, name, method, kept[method]);
        record(results, name, method + "-no-history", none);
        results.promises.push_back({name, method, "strip_over_no_history", mean_ratio(kept[method], none), 1});
    }
    results.promises.push_back({name, "dual-color", "strip_over_svgf", mean_ratio(kept["dual-color"], kept["svgf"]), 1});
}

float luminance(glm::vec3 colour) { return glm::dot(colour, glm::vec3{0.2126f, 0.7152f, 0.0722f}); }

/// The brightest object that moves, by its number.
float bright_mover(io::ExrImage const& frame) {
    auto const colours = picture_of(frame, "albedo");
    auto const &id = frame["instance.ID"].values, &x = frame["motion.X"].values;
    std::map<float, std::pair<double, int>> sums;
    for (std::size_t i = 0; i < id.size(); ++i)
        if (std::abs(x[i]) > 0.1f) sums[id[i]].first += luminance(colours.pixels[i]), ++sums[id[i]].second;
    auto const mean = [](auto const& entry) { return entry.second.first / entry.second.second; };
    return std::ranges::max_element(sums, {}, mean)->first;
}

/// How long ago each pixel showed an object, frame by frame.
struct Ages {
    float object;
    std::vector<int> frames; ///< 0: now; very many: never

    void add(io::ExrImage const& frame) {
        auto const& id = frame["instance.ID"].values;
        if (frames.empty()) frames.assign(id.size(), 1 << 20);
        for (std::size_t i = 0; i < id.size(); ++i) frames[i] = id[i] == object ? 0 : frames[i] + 1;
    }
};

/// What is left of an object's light where it was, as a part of what it would be were it still there, by the frames since it left.
std::vector<double> ghost(Sequence const& sequence, Pictures const& pictures, float object, int oldest) {
    Ages ages{object, {}};
    std::vector<double> excess(static_cast<std::size_t>(oldest) + 1), contrast(excess);
    for (int i = sequence.first; i <= sequence.last(); ++i) {
        ages.add(sequence.frame(i));
        if (i < sequence.scored_from) continue;
        auto const &truth = sequence.reference(i).pixels, &shown = pictures[static_cast<std::size_t>(i - sequence.scored_from)].pixels;
        double bright = 0, pixels = 0;
        for (std::size_t p = 0; p < truth.size(); ++p)
            if (ages.frames[p] == 0) bright += luminance(truth[p]), ++pixels;
        for (std::size_t p = 0; p < truth.size(); ++p) {
            auto const age = static_cast<std::size_t>(ages.frames[p]);
            if (age == 0 || age >= excess.size()) continue;
            excess[age] += luminance(shown[p]) - luminance(truth[p]);
            contrast[age] += bright / pixels - luminance(truth[p]);
        }
    }
    for (std::size_t age = 1; age < excess.size(); ++age) excess[age] = contrast[age] > 0 ? excess[age] / contrast[age] : 0;
    return excess;
}

void bright_box(std::string const& name, Making const& making, Results& results) {
    constexpr int oldest = 24;
    auto const sequence = traced({.scene = "boxes", .signal = Signal::indirect, .scored_from = 22, .last = 38}, making);
    float const box = bright_mover(sequence.frame(30));
    for (std::string const method : {"surface", "surface-clamp", "svgf", "dual-color", "dual-cone"}) {
        auto const pictures = watch(examples::preset_of(method), sequence, {}, making.threads);
        record(results, name, method, errors(sequence, pictures));
        auto const left = ghost(sequence, pictures, box, oldest);
        auto const last = std::find_if(left.rbegin(), left.rend() - 1, [](double part) { return part > 0.1; });
        // As long as the first tenth of a mean over five frames, the cap of svgf, takes to go: log(0.1) / log(0.8).
        results.promises.push_back({name, method, "frames_until_a_tenth", static_cast<double>(left.rend() - last), 11});
    }
}

} // namespace

std::vector<Case> uncovering_cases() {
    return {{"leaves", "Dense leaves open suddenly. Never worse than surface motion.", true, leaves},
            {"pan", "The camera turns: in the strip that comes into the image nothing is smeared, and a second source helps.", true, pan},
            {"bright-box", "A bright box slides over a dark region. Its ghost decays.", false, bright_box}};
}

} // namespace quell::stability
