#pragma once

#include <quell_denoiser.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

/// What tests of libquell share.
namespace wall_test {

constexpr int width = 61, height = 34;
constexpr std::size_t pixels = width * height;

/// A wall in noisy light, in memory of the caller's.
struct Wall {
    std::vector<float> rgb, albedo, normal, depth, motion, out;
    std::vector<quell_channel> channels;
    quell_frame frame = QUELL_FRAME;
    std::size_t behind_frame = ~std::size_t{0}; ///< what a later version's frame may have there

    Wall() : rgb(pixels * 3), albedo(pixels * 3, 0.5f), normal(pixels * 3), depth(pixels, 4.f), motion(pixels * 2), out(pixels * 3) {
        for (std::size_t i = 2; i < normal.size(); i += 3) normal[i] = 1;
        channels = {{"radiance", QUELL_PIXELS(rgb.data(), 3)},
                    {"albedo", QUELL_PIXELS(albedo.data(), 3)},
                    {"normal", QUELL_PIXELS(normal.data(), 3)},
                    {"depth", QUELL_PIXELS(depth.data(), 1)},
                    {"motion", QUELL_PIXELS(motion.data(), 2)}};
        frame.output = QUELL_PIXELS(out.data(), 3);
        shine(1);
    }
    void shine(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> any(0, 1);
        for (auto& value : rgb) value = any(random);
    }
    quell_frame const* ready() {
        frame.channels = channels.data(), frame.channel_count = channels.size();
        return &frame;
    }
};
struct Destroy {
    void operator()(quell_denoiser* denoiser) const { quell_destroy(denoiser); }
};
using Owned = std::unique_ptr<quell_denoiser, Destroy>;
inline quell_settings settings_of(char const* preset = "svgf") {
    quell_settings settings = QUELL_SETTINGS;
    settings.preset = preset, settings.width = width, settings.height = height;
    return settings;
}
inline Owned made(quell_settings const& settings = settings_of()) {
    quell_denoiser* denoiser = nullptr;
    INFO(std::string(quell_error()));
    REQUIRE(quell_create(&settings, &denoiser) == QUELL_OK);
    return Owned(denoiser);
}
/// What is said about a call.
inline void check_refused(quell_status status, quell_status wanted, std::vector<std::string> const& words) {
    CHECK(status == wanted);
    std::string const sentence = quell_error();
    INFO(sentence);
    for (auto const& word : words) CHECK(sentence.find(word) != sentence.npos);
}

} // namespace wall_test
