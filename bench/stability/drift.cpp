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

constexpr float light = 1000;

/// Frames with noise of a tenth around light of a thousand, on a small tile.
std::vector<io::ExrImage> noisy_frames(int count, std::uint32_t seed) {
    auto const even = even_frame(light, {.size = {48, 27}});
    std::mt19937 random(seed + 9);
    std::uniform_real_distribution<float> noise(0.9f, 1.1f);
    std::vector<io::ExrImage> frames(static_cast<std::size_t>(count), even);
    for (auto& frame : frames)
        for (auto const& each : signal_planes())
            if (each.name != "visibility.V")
                for (auto& value : plane(frame, each.name)) value *= noise(random);
    return frames;
}

/// The picture as if its light were half of what a display can show.
metrics::Picture dimmed(metrics::Picture picture, float part) {
    for (auto& pixel : picture.pixels) pixel *= 0.5f / (light * part);
    return picture;
}

/// Of a method whose part of the light is `part`. The frames come over and over, a round number of times in what is counted.
Means means(std::string const& name, examples::Preset const& preset, std::vector<io::ExrImage> const& noisy, float part, int frames,
            Results& results) {
    constexpr int counted = 500;
    auto const denoiser = examples::denoiser_of(preset, noisy.front().size, 1);
    auto const truth = even_picture(0.5f, noisy.front().size);
    auto const round = static_cast<int>(noisy.size());
    Means result;
    for (int i = 0; i < frames; ++i) {
        metrics::Picture const picture = denoiser->denoise(noisy[static_cast<std::size_t>(i % round)], {}, i);
        if (i % round == round - 1) record(results.frames, name, preset.name, i, truth, dimmed(picture, part)); // of one noise each time
        bool const early = i >= 100 && i < 100 + counted, late = i >= frames - counted;
        if (!early && !late) continue;
        double sum = 0;
        for (auto const& p : picture.pixels) sum += p.y;
        (early ? result.early : result.late) +=
            sum / (static_cast<double>(light * part) * static_cast<double>(picture.pixels.size()) * counted);
    }
    return result;
}

void drift(std::string const& name, Making const& making, Results& results) {
    auto const noisy = noisy_frames(100, making.seed);
    auto const add = [&](examples::Preset const& preset, float part) {
        auto const found = means(name, preset, noisy, part, making.long_run, results);
        // The same frames are counted early and late; of 129,600 samples of deviation 0.06, 1e-3 is six times the mean's.
        results.promises.push_back({name, preset.name, "late_less_early", std::abs(found.late - found.early), 1e-4});
        results.promises.push_back({name, preset.name, "late_bias", std::abs(found.late - 1), 1e-3});
    };
    add(examples::preset_of("surface"), 1);
    add(examples::preset_of("surface-clamp"), 1);
    add(examples::preset_of("svgf"), 1);
    add(examples::preset_of("general"), 1);
    add(svgf_in_half(), 1);
    add(examples::preset_of("glossy"), 0.25f);
    add(examples::preset_of("dual-cone"), 0.25f);
}

} // namespace

std::vector<Case> drift_cases() {
    return {{"drift", "10,000 frames in which nothing moves, of light of 1,000. No drift, in float and in half.", drift}};
}

} // namespace quell::stability
