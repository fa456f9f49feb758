#include "cases.hpp"
#include "own_presets.hpp"
#include "still.hpp"
#include "watch.hpp"

#include <cmath>
#include <random>

namespace quell::stability {
namespace {

/// Means of the picture over early and late frames, as parts of the truth.
struct Means {
    double early = 0, late = 0;
};

/// Noise of a tenth around light of a thousand, on a small tile, for many frames.
Means means(examples::Preset const& preset, float part) {
    constexpr int frames = 10000, counted = 500;
    constexpr float light = 1000;
    Making const small{.size = {48, 27}};
    auto const even = even_frame(light, small);
    auto frame = even;
    auto const denoiser = preset.make(small.size, 1);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> noise(0.9f, 1.1f);
    Means result;
    for (int i = 0; i < frames; ++i) {
        for (auto const& each : signal_planes())
            if (each.name != "visibility.V")
                for (std::size_t p = 0; p < even.pixels(); ++p) plane(frame, each.name)[p] = light * each.part * noise(random);
        auto const picture = denoiser->denoise(frame, {}, i);
        bool const early = i >= 100 && i < 100 + counted, late = i >= frames - counted;
        if (!early && !late) continue;
        double sum = 0;
        for (auto const& p : picture.pixels) sum += p.y;
        (early ? result.early : result.late) += sum / (static_cast<double>(light * part) * static_cast<double>(even.pixels()) * counted);
    }
    return result;
}

void drift(std::string const& name, Making const&, Results& results) {
    auto const add = [&](examples::Preset const& preset, float part) {
        auto const found = means(preset, part);
        // Both are means over 648,000 samples of deviation 0.06: 5e-4 is six times their deviation.
        results.promises.push_back({name, preset.name, "late_less_early", std::abs(found.late - found.early), 5e-4});
        results.promises.push_back({name, preset.name, "late_bias", std::abs(found.late - 1), 1e-3});
    };
    add(examples::preset_of("surface"), 1);
    add(examples::preset_of("surface-clamp"), 1);
    add(examples::preset_of("svgf"), 1);
    add(svgf_in_half(), 1);
    add(examples::preset_of("glossy"), 0.25f);
    add(examples::preset_of("dual-cone"), 0.25f);
}

} // namespace

std::vector<Case> drift_cases() {
    return {{"drift", "10,000 frames in which nothing moves, of light of 1,000. No drift, in float and in half.", true, drift}};
}

} // namespace quell::stability
