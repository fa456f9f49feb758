#include "../files.hpp"
#include "cases.hpp"
#include "own_presets.hpp"
#include "watch.hpp"

#include <tracer/lighting.hpp>

#include <algorithm>

namespace quell::stability {
namespace {

/// The lit part of the light, where there is light enough to tell; elsewhere a negative number.
std::vector<float> visibility_in(metrics::Picture const& share, metrics::Picture const& direct) {
    std::vector<float> result;
    for (std::size_t i = 0; i < share.pixels.size(); ++i) {
        float const light = tracer::luminance(direct.pixels[i]);
        result.push_back(light > 0.02f ? tracer::luminance(share.pixels[i]) / light : -1.f);
    }
    return result;
}

Shot shot_of(std::string const& scene) {
    return {.scene = scene, .signal = Signal::shadow, .scored_from = 28, .last = 34, .effect = tracer::Effect::shadow};
}

/// Several shadows of different motion in one pixel: no vector is right for all.
void several(std::string const& name, Making const& making, Results& results) {
    auto const sequence = traced(shot_of("fence-lights"), making);
    auto const clamped = record(results, name, examples::preset_of("surface-clamp"), sequence, making.threads);
    auto const followed = record(results, name, examples::preset_of("shadow"), sequence, making.threads);
    results.promises.push_back({name, "shadow", "worst_frame_over_surface-clamp", worst_ratio(followed, clamped), no_worse});
}

/// The slope of the line through (true, shown) visibility of the pixels that a moving shadow touches: 1 keeps all contrast, 0 none.
double contrast_kept(ScoredSequence const& sequence, Pictures const& pictures) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int i = sequence.scored_from; i <= sequence.last(); ++i) {
        auto const direct = bench::picture_in(sequence.frame(i), "direct.");
        auto const truth = visibility_in(sequence.reference(i), direct),
                   shown = visibility_in(pictures[static_cast<std::size_t>(i - sequence.scored_from)], direct);
        auto const mask = sequence.mask(i);
        for (std::size_t p = 0; p < truth.size(); ++p)
            if (mask[p] != 0 && truth[p] >= 0) n += 1, x += truth[p], y += shown[p], xx += truth[p] * truth[p], xy += truth[p] * shown[p];
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

void thin(std::string const& name, Making const& making, Results& results) {
    // Rods and beads of a pixel or two: in smaller pictures they would be less.
    auto finer = making;
    finer.size = {2 * making.size.width, 2 * making.size.height};
    auto const sequence = traced(shot_of("thinshadows"), finer);
    for (std::string const method : {"surface", "surface-clamp", "svgf", "general", "final-frame", "shadow"}) {
        auto const pictures = watch(examples::preset_of(method), sequence, {}, making.threads);
        record(results, name, method, sequence, pictures);
        // Kept: no more than a tenth is lost.
        results.promises.push_back({name, method, "contrast_over_reference", contrast_kept(sequence, pictures), 0.9, true});
    }
}

/// The part of the pixels well inside the light that are drawn with less than four fifths of it.
double wrongly_dark(ScoredSequence const& sequence, Pictures const& pictures) {
    constexpr int margin = 3;
    double lit = 0, dark = 0;
    int const width = sequence.size.width, height = sequence.size.height;
    for (int i = sequence.scored_from; i <= sequence.last(); ++i) {
        auto const direct = bench::picture_in(sequence.frame(i), "direct.");
        auto const truth = visibility_in(sequence.reference(i), direct),
                   shown = visibility_in(pictures[static_cast<std::size_t>(i - sequence.scored_from)], direct);
        auto const is_lit = [&](int x, int y) { return truth[static_cast<std::size_t>(y * width + x)] > 0.995f; };
        for (int y = margin; y < height - margin; ++y)
            for (int x = margin; x < width - margin; ++x) {
                bool inside = true;
                for (int j = -margin; j <= margin; ++j)
                    for (int k = -margin; k <= margin; ++k) inside = inside && is_lit(x + k, y + j);
                if (inside) lit += 1, dark += shown[static_cast<std::size_t>(y * width + x)] < 0.8f ? 1 : 0;
            }
    }
    return dark / lit;
}

void non_planar(std::string const& name, Making const& making, Results& results) {
    auto const sequence = traced(shot_of("apples"), making);
    auto const pictures = watch(examples::preset_of("shadow"), sequence, {}, making.threads);
    auto const with = record(results, name, "shadow", sequence, pictures);
    auto const without = record(results, name, shadow_without_falloff(), sequence, making.threads);
    results.promises.push_back({name, "shadow", "over_without_falloff", mean_ratio(with, without), no_worse});
    results.promises.push_back({name, "shadow", "lit_pixels_drawn_dark", wrongly_dark(sequence, pictures), 0.005});
}

} // namespace

std::vector<Case> shadow_cases() {
    return {{"several-shadows", "Shadows of three lights that move apart, in the same pixels. Bounded by the clamped baseline.", several},
            {"thin-shadows", "Rods and beads of a pixel or two. Their shadows keep their contrast.", thin},
            {"non-planar", "Shadows on cloth and fruit. The falloff helps, and no shadow lies on the wrong surface.", non_planar}};
}

} // namespace quell::stability
