#include "cases.hpp"
#include "watch.hpp"

#include <tracer/lighting.hpp>
#include <tracer/scenes/scenes.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace quell::stability {
namespace {

constexpr int event = static_cast<int>(tracer::event_frame);

/// One method against another, in every frame.
void never_worse(std::string const& name, ScoredSequence const& sequence, std::string const& method, std::string const& than, int threads,
                 Results& results) {
    auto const a = record(results, name, examples::preset_of(method), sequence, threads);
    auto const other = watch(examples::preset_of(than), sequence, {}, threads);
    auto const b = record(results, name, than + "-beside-" + method, sequence, other);
    results.promises.push_back({name, method, "worst_frame_over_" + than, worst_ratio(a, b), no_worse});
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
    std::map<std::string, FrameErrors> kept;
    for (std::string const method : {"surface", "surface-clamp", "svgf", "general", "dual-color", "dual-cone"}) {
        auto const& preset = examples::preset_of(method);
        kept[method] = record(results, name, preset, sequence, making.threads);
        auto const forgetful = watch(preset, sequence, {Memory::Kind::none}, making.threads);
        auto const none = record(results, name, method + "-no-history", sequence, forgetful);
        results.promises.push_back({name, method, "strip_over_no_history", mean_ratio(kept[method], none), no_worse});
    }
    results.promises.push_back({name, "dual-color", "strip_over_svgf", mean_ratio(kept["dual-color"], kept["svgf"]), no_worse});
}

/// The mean luminance of the 5x5 around a pixel: references have noise of their own.
float around(metrics::Picture const& picture, int x, int y) {
    float sum = 0;
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
            sum += tracer::luminance(picture.pixels[static_cast<std::size_t>((y + j) * picture.size.width + x + i)]);
    return sum / 25;
}

/// Whether the 5x5 around a pixel shows the same objects in both frames.
bool same_around(io::ExrImage const& a, io::ExrImage const& b, int x, int y) {
    auto const &ids = a["instance.ID"].values, &others = b["instance.ID"].values;
    for (int j = -2; j <= 2; ++j) {
        auto const row = (y + j) * a.size.width + x - 2;
        if (!std::equal(ids.begin() + row, ids.begin() + row + 5, others.begin() + row)) return false;
    }
    return true;
}

/// How many frames a method lags behind light that fades on what stands still: where the truth has fallen by a tenth or more within a few
/// frames, what is shown too brightly, in units of what the truth falls by in a frame. Of light that fades evenly, an exponential history
/// of alpha lags by 1 / alpha - 1.
double lag_in_frames(ScoredSequence const& sequence, Pictures const& pictures) {
    constexpr int step = 4;
    double excess = 0, fall = 0;
    for (int i = sequence.scored_from + step; i <= sequence.last(); ++i)
        for (int y = 2; y < sequence.size.height - 2; ++y)
            for (int x = 2; x < sequence.size.width - 2; ++x) {
                if (!same_around(sequence.frame(i - step), sequence.frame(i), x, y)) continue;
                float const was = around(sequence.reference(i - step), x, y), is = around(sequence.reference(i), x, y);
                if (is > 0.9f * was) continue;
                excess += around(pictures[static_cast<std::size_t>(i - sequence.scored_from)], x, y) - is;
                fall += (was - is) / step;
            }
    return excess / fall;
}

void bright_box(std::string const& name, Making const& making, Results& results) {
    auto const sequence = traced({.scene = "boxes", .signal = Signal::indirect, .scored_from = 24, .last = 36}, making);
    for (std::string const method : {"surface", "surface-clamp", "svgf", "general", "dual-color", "dual-cone"}) {
        auto const pictures = watch(examples::preset_of(method), sequence, {}, making.threads);
        record(results, name, method, sequence, pictures);
        // A ghost of which a tenth is left after ten frames has a lag of 10 / log(10) frames.
        results.promises.push_back({name, method, "frames_until_a_tenth", std::log(10.) * lag_in_frames(sequence, pictures), 10});
    }
}

} // namespace

std::vector<Case> uncovering_cases() {
    return {{"leaves", "Dense leaves open suddenly. Never worse than surface motion.", leaves},
            {"pan", "The camera turns: in the strip that comes into the image nothing is smeared, and a second source helps.", pan},
            {"bright-box", "A bright box slides over a dark region. Its ghost decays.", bright_box}};
}

} // namespace quell::stability
