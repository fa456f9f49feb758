#include "cases.hpp"
#include "still.hpp"
#include "watch.hpp"

#include <quell/core/real.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace quell::stability {
namespace {

constexpr float light = 0.2f;

/// What hosts hand over by mistake: the first four are never light, in any component, the others rarely guides.
constexpr std::array no_numbers{std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::infinity(),
                                -std::numeric_limits<float>::infinity(),
                                -100.f,
                                0.f,
                                -0.f,
                                1e-40f,
                                3e38f};

/// Spoils a tenth of a plane's pixels with the first so many of those.
void spoil(io::ExrImage& image, std::string const& name, unsigned kinds, std::mt19937& random) {
    for (auto& value : plane(image, name))
        if (random() % 10 == 0) value = no_numbers[random() % kinds];
}

struct Extremes {
    double farthest = 0; ///< from what the picture should be, as a part of it
    double broken = 0;   ///< components that aren't finite
};
Extremes extremes(metrics::Picture const& picture, metrics::Picture const& even) {
    Extremes result;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const a = picture.pixels[i][c], wanted = even.pixels[i][c];
            if (is_finite(a))
                result.farthest = std::max(result.farthest, static_cast<double>(std::abs(a - wanted) / wanted));
            else
                ++result.broken;
        }
    return result;
}

/// What is tried, by the name that its promises have.
struct Method {
    std::string name;
    quell_library::Way const& way;
    int enlarged = 0; ///< how many times, by anti-aliasing behind the preset; 0: none

    [[nodiscard]] std::unique_ptr<examples::Denoiser> denoiser(Extent size, int threads) const {
        auto const output = enlarged > 0 ? std::optional(Extent{enlarged * size.width, enlarged * size.height}) : std::nullopt;
        return std::make_unique<examples::Denoiser>(way, size, threads, output);
    }
};

/// A burst in the samples, in frames 4 and 8: each is missing, weighs nothing and spreads nowhere, so that an even picture stays even.
double spread(Method const& method, io::ExrImage const& even, Making const& making) {
    auto const denoiser = method.denoiser(making.size, making.threads);
    std::mt19937 random(making.seed + 5);
    double farthest = 0;
    metrics::Picture wanted;
    for (int i = 0; i < 16; ++i) {
        auto frame = even;
        if (i == 4 || i == 8)
            for (auto const& each : signal_planes()) spoil(frame, each.name, 4, random);
        metrics::Picture const picture = denoiser->denoise(frame, {}, i);
        if (i == 3) wanted = picture;
        if (i <= 3) continue;
        auto const found = extremes(picture, wanted);
        farthest = std::max(farthest, found.broken > 0 ? std::numeric_limits<double>::infinity() : found.farthest);
    }
    return farthest;
}

/// Signals, and what they are divided by: a black surface or light of next to nothing may well be meant.
bool is_light(std::string const& name) {
    return name.starts_with("albedo") || std::ranges::find(signal_planes(), name, &SignalPlane::name) != signal_planes().end();
}

/// A burst in every channel, signals and guides.
Extremes burst(std::string const& name, Method const& method, io::ExrImage const& even, Making const& making, Results& results) {
    auto const denoiser = method.denoiser(making.size, making.threads);
    std::mt19937 random(making.seed + 6);
    Extremes result;
    metrics::Picture wanted;
    for (int i = 0; i < 24; ++i) {
        auto frame = even;
        if (i == 4 || i == 5)
            for (auto const& each : even.planes) {
                spoil(frame, each.name, is_light(each.name) ? 4 : no_numbers.size(), random);
            }
        metrics::Picture const picture = denoiser->denoise(frame, {}, i);
        if (i == 3) wanted = picture;
        if (i >= 3) record(results.frames, name, method.name, i, wanted, picture);
        if (i <= 3) continue;
        auto const found = extremes(picture, wanted);
        result.broken += found.broken;
        result.farthest = found.farthest; // of the last frame
    }
    return result;
}

/// Whether something throws an Error that says this.
bool complains(auto const& something, std::string const& what) {
    try {
        something();
    } catch (Error const& error) {
        return std::string(error.what()).find(what) != std::string::npos;
    }
    return false;
}

/// Channels that are missing and sizes of nothing that aren't refused by name.
double unclear(Method const& method, io::ExrImage const& even, Making const& making) {
    double count = 0;
    for (Extent const size : {Extent{0, 9}, Extent{9, 0}, Extent{-1, 9}})
        if (!complains([&] { static_cast<void>(method.denoiser(size, making.threads)); }, to_string(size))) ++count;
    auto const denoiser = method.denoiser(making.size, making.threads);
    for (auto const& name : denoiser->planes({})) {
        auto frame = even;
        std::erase_if(frame.planes, [&](auto const& each) { return each.name == name; });
        if (!complains([&] { static_cast<void>(denoiser->denoise(frame, {}, 0)); }, "'" + name + "'")) ++count;
    }
    return count;
}

void broken_input(std::string const& name, Making const& making, Results& results) {
    auto const even = even_frame(light, making);
    std::vector<Method> methods;
    for (auto const& preset : examples::presets()) methods.push_back({preset.name, examples::way_of(preset)});
    for (std::string const preset : {"none", "svgf", "general"})
        methods.push_back({preset + "-upsampled", examples::way_of(examples::preset_of(preset)), 2});
    for (auto const& method : methods) {
        results.promises.push_back({name, method.name, "spread_of_missing_samples", spread(method, even, making), 1e-3});
        auto const after = burst(name, method, even, making, results);
        results.promises.push_back({name, method.name, "broken_components", after.broken, 0});
        results.promises.push_back({name, method.name, "left_18_frames_later", after.farthest, 1e-2});
        results.promises.push_back({name, method.name, "unclear_errors", unclear(method, even, making), 0});
    }
}

} // namespace

std::vector<Case> input_cases() {
    return {{"broken-input", "NaN, infinite, negative, denormal input, missing channels, no motion, no size. Never spreads; a clear error.",
             broken_input}};
}

} // namespace quell::stability
