#include "cases.hpp"
#include "sample_range.hpp"
#include "still.hpp"
#include "watch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace quell::stability {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// What stands in a broken pixel: numbers at which arithmetic changes its ways, any bits, or what was there, in another unit.
float odd(float value, std::mt19937& random) {
    constexpr std::array turning{
        std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 3e38f, 0.f, -0.f, -1.f, 1e16f, 65504.f, 1e-20f};
    switch (random() % 4) {
    case 0:
        return turning[random() % turning.size()];
    case 1:
        return std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    case 2:
        return value * 1.5f;
    default:
        return -value;
    }
}
/// The same without subnormal numbers, which threads may or may not count as 0.
float broken(float value, std::mt19937& random) {
    float const made = odd(value, random);
    return std::abs(made) < std::numeric_limits<float>::min() ? 0.f : made;
}

/// The frame with other samples and motion, of which some planes are broken: in few pixels, many or all.
io::ExrImage broken_frame(io::ExrImage frame, std::mt19937& random) {
    auto const number = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
    for (auto const& each : signal_planes())
        for (auto& value : plane(frame, each.name)) value = each.name == "visibility.V" ? static_cast<float>(random() % 2) : number(0, 3);
    for (auto const* const name : {"motion.X", "motion.Y", "sweep.X", "sweep.Y"})
        for (auto& value : plane(frame, name)) value = random() % 4 == 0 ? 0 : number(-3, 3);
    for (auto& value : plane(frame, "time.T")) value = number(0, 1);
    constexpr std::array one_in{0u, 100u, 10u, 2u, 1u};
    auto const share = one_in[random() % one_in.size()];
    if (share == 0) return frame;
    for (auto& each : frame.planes)
        if (random() % 3 == 0)
            for (auto& value : each.values)
                if (random() % share == 0) value = broken(value, random);
    return frame;
}

/// No guide can make light: whatever a frame holds, what comes out lies between the least and the greatest sample so far.
void bounds(std::string const& name, Making const& making, Results& results) {
    auto small = making;
    small.size = {64, 36};
    auto const even = even_frame(0.2f, small);
    for (auto const& preset : examples::presets()) {
        auto const denoiser = examples::denoiser_of(preset, small.size, making.threads);
        SampleRange range(preset);
        std::mt19937 random(making.seed + 8);
        double farthest = 0;
        for (long long i = 0, number = 0; i < making.broken_frames; ++i, ++number) {
            if (random() % 8 == 0) number += 2, range.start_over();
            auto const frame = broken_frame(even, random);
            range.see(frame);
            farthest = std::max(farthest, range.beyond(denoiser->denoise(frame, {}, number)));
        }
        results.promises.push_back({name, preset.name, "beyond_all_samples", farthest, 1e-5});
    }
}

/// A frame of which a part shows nothing. There, or else on the surfaces, one sample of four has all the light. The first column of the sky
/// belongs to the surfaces: its samples are of the pixel, and its guides of the pixel's centre.
io::ExrImage sky_frame(io::ExrImage frame, bool noisy_sky, std::mt19937& random) {
    int const width = frame.size.width, edge = width / 2;
    auto const of_sky = [&](std::size_t i, int fringe) { return static_cast<int>(i) % width >= edge + fringe; };
    for (std::size_t i = 0; i < frame.pixels(); ++i) {
        float const factor = random() % 4 == 0 ? 4.f : 0.f;
        for (auto const& each : signal_planes())
            if (of_sky(i, noisy_sky ? 0 : 1) == noisy_sky)
                plane(frame, each.name)[i] = each.name == "visibility.V" ? std::min(factor, 1.f) : plane(frame, each.name)[i] * factor;
        if (!of_sky(i, 0)) continue;
        plane(frame, "depth.Z")[i] = infinity;
        for (auto const* const component : {"X", "Y", "Z"}) plane(frame, std::string("normal.") + component)[i] = 0;
    }
    return frame;
}

/// Light stays where something is seen, and the sky's in the sky.
void sky(std::string const& name, Making const& making, Results& results) {
    auto const even = even_frame(0.2f, making);
    for (auto const& preset : examples::presets()) {
        if (preset.group == PresetGroup::blur || preset.name.find("blur") != preset.name.npos) continue; // what moves covers the sky
        for (bool const noisy_sky : {false, true}) {
            auto const denoiser = examples::denoiser_of(preset, making.size, making.threads);
            metrics::Picture const wanted = denoiser->denoise(even, {}, 0);
            std::mt19937 random(making.seed + 9);
            double farthest = 0;
            for (int i = 0; i < 16; ++i) {
                metrics::Picture const picture = denoiser->denoise(sky_frame(even, noisy_sky, random), {}, i + 100);
                for (int y = 0; y < making.size.height; ++y)
                    for (int x = 0; x < making.size.width; ++x) {
                        bool const is_sky = x > making.size.width / 2, is_surface = x < making.size.width / 2;
                        auto const pixel = static_cast<std::size_t>(y * making.size.width + x);
                        if (noisy_sky ? !is_surface : !is_sky) continue;
                        farthest = std::max<double>(farthest, std::abs(picture.pixels[pixel].x / wanted.pixels[pixel].x - 1));
                    }
            }
            results.promises.push_back({name, preset.name, noisy_sky ? "light_from_the_sky" : "light_in_the_sky", farthest, 1e-5});
        }
    }
}

} // namespace

std::vector<Case> bounds_cases() {
    return {{"bounds", "Frames of which any part is broken. What comes out lies between the least and the greatest sample so far.", bounds},
            {"sky", "Noise beside pixels without a surface. None of its light spreads over them, nor theirs over surfaces.", sky}};
}

} // namespace quell::stability
