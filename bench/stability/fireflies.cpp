#include "cases.hpp"
#include "own_presets.hpp"
#include "still.hpp"
#include "watch.hpp"

#include <quell/metrics/picture.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

namespace quell::stability {
namespace {

constexpr float light = 0.2f;

/// A method and how much of the light planes it sees.
struct Watched {
    examples::Preset preset;
    float part;
};

std::vector<Watched> all_methods() {
    std::vector<Watched> list;
    for (std::string const name : {"surface", "surface-clamp", "svgf", "general", "final-frame", "dual-color"})
        list.push_back({examples::preset_of(name), 1});
    list.push_back({svgf_without_fireflies(), 1});
    list.push_back({examples::preset_of("glossy"), 0.25f});
    list.push_back({examples::preset_of("dual-cone"), 0.25f});
    return list;
}

double sum_of(metrics::Picture const& picture) {
    double sum = 0;
    for (auto const& p : picture.pixels) sum += p.x;
    return sum;
}

double brightest(metrics::Picture const& picture) {
    double most = 0;
    for (auto const& p : metrics::displayed(picture).pixels) most = std::max<double>(most, p.x);
    return most;
}

/// One sample of ten thousand, once.
void firefly(std::string const& name, Making const& making, Results& results) {
    constexpr int flash = 12, last = 60;
    constexpr float energy = 1e4f;
    auto const even = even_frame(light, making);
    auto lit = even;
    auto const middle = static_cast<std::size_t>(making.size.height / 2 * making.size.width + making.size.width / 2);
    for (auto const& each : signal_planes())
        if (each.name != "visibility.V") plane(lit, each.name)[middle] += energy * each.part;
    for (auto const& [preset, part] : all_methods()) {
        auto const denoiser = examples::denoiser_of(preset, making.size, making.threads);
        auto const truth = even_picture(light * part, making.size);
        double most = 0, usual = 0, base = 0;
        int alive = 0;
        for (int i = 0; i <= last; ++i) {
            metrics::Picture const picture = denoiser->denoise(i == flash ? lit : even, {}, i);
            if (i >= flash - 1) record(results.frames, name, preset.name, i, truth, picture);
            if (i == flash - 1) usual = sum_of(picture), base = brightest(picture);
            if (i < flash) continue;
            most = std::max(most, sum_of(picture) - usual);
            if (i > flash && brightest(picture) > base + 0.1) alive = i - flash;
        }
        results.promises.push_back({name, preset.name, "energy_over_input", most / static_cast<double>(energy * part), 1.01});
        results.promises.push_back({name, preset.name, "frames_alive", static_cast<double>(alive), 2});
    }
}

/// Samples of which one in fifty holds all of the light.
void variance(std::string const& name, Making const& making, Results& results) {
    auto const even = even_frame(light, making);
    std::mt19937 random(making.seed + 3);
    ScoredSequence sequence{making.size, 0, 32, std::vector(64, even), {}, {}};
    for (auto& frame : sequence.frames) {
        std::vector<float> factors(frame.pixels());
        for (auto& factor : factors) factor = random() % 50 == 0 ? 50.f : 0.f;
        for (auto const& each : signal_planes())
            if (each.name != "visibility.V")
                for (std::size_t i = 0; i < factors.size(); ++i) plane(frame, each.name)[i] *= factors[i];
    }
    for (auto const& [preset, part] : all_methods()) {
        auto const truth = even_picture(light * part, making.size);
        double worst = 0;
        int number = sequence.scored_from;
        for (auto const& picture : watch(preset, sequence, {}, making.threads)) {
            worst = std::max(worst, sum_of(picture));
            record(results.frames, name, preset.name, number++, truth, picture);
        }
        worst /= static_cast<double>(light * part) * static_cast<double>(making.size.pixels());
        results.promises.push_back({name, preset.name, "worst_frame_energy_over_truth", worst, 1.25});
    }
}

/// Frames in each of which a part p of the samples, other ones each time, has all of the light.
std::vector<io::ExrImage> skewed_frames(io::ExrImage const& even, double p, int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::size_t> pixels(even.pixels());
    std::iota(pixels.begin(), pixels.end(), 0);
    auto const lit = static_cast<std::size_t>(p * static_cast<double>(pixels.size()));
    std::vector<io::ExrImage> frames(static_cast<std::size_t>(count), even);
    for (auto& frame : frames) {
        std::ranges::shuffle(pixels, random);
        std::vector<float> factors(pixels.size());
        for (std::size_t i = 0; i < lit; ++i) factors[pixels[i]] = static_cast<float>(pixels.size()) / static_cast<float>(lit);
        for (auto const& each : signal_planes())
            if (each.name != "visibility.V")
                for (std::size_t i = 0; i < factors.size(); ++i) plane(frame, each.name)[i] *= factors[i];
    }
    return frames;
}

/// The light of a picture of which a part p of the samples has all, over that of an even one: no method may lose any.
void energy(std::string const& name, Making const& making, Results& results) {
    constexpr int settled = 32;
    auto const even = even_frame(light, making);
    struct Skew {
        double p, limit;
        std::vector<io::ExrImage> frames;
    };
    std::vector<Skew> skews{{0.5, 0.005, {}}, {0.2, 0.005, {}}, {0.05, 0.005, {}}, {0.01, 0.02, {}}};
    for (auto& skew : skews) skew.frames = skewed_frames(even, skew.p, 96, making.seed + 11);
    for (auto const& preset : examples::presets()) {
        if (preset.name.starts_with("shadow")) continue; // of visibility, which is 0 or 1
        auto const truth = sum_of(examples::denoiser_of(preset, making.size, making.threads)->denoise(even, {}, 0));
        for (auto const& skew : skews) {
            auto const denoiser = examples::denoiser_of(preset, making.size, making.threads);
            double sum = 0;
            for (int i = 0; i < static_cast<int>(skew.frames.size()); ++i) {
                metrics::Picture const picture = denoiser->denoise(skew.frames[static_cast<std::size_t>(i)], {}, i);
                if (i >= settled) sum += sum_of(picture);
            }
            auto const mean = sum / static_cast<double>(skew.frames.size() - settled);
            auto const percent = std::to_string(static_cast<int>(skew.p * 100 + 0.5));
            results.promises.push_back({name, preset.name, "light_off_at_" + percent + "_percent", std::abs(mean / truth - 1), skew.limit});
        }
    }
}

} // namespace

std::vector<Case> firefly_cases() {
    return {{"firefly", "A single sample of 10,000. Its energy doesn't grow, and it doesn't live on in the history.", firefly},
            {"variance", "One sample in fifty has all the light. Energy stays bounded.", variance},
            {"energy", "A half, a fifth, a 20th and a 100th of the samples have all the light. None is lost, none is won.", energy}};
}

} // namespace quell::stability
