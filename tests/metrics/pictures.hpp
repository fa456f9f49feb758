#pragma once

#include <quell/metrics/picture.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>

namespace pictures {

using quell::Extent;
using quell::metrics::Mask;
using quell::metrics::Picture;

inline Picture constant(Extent size, glm::vec3 colour) {
    return {size, std::vector<glm::vec3>(static_cast<std::size_t>(size.pixels()), colour)};
}

inline Picture noise(Extent size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> component(0.f, 1.f);
    auto result = constant(size, {});
    for (auto& p : result.pixels) p = {component(random), component(random), component(random)};
    return result;
}

/// The picture with noise of this amplitude added, in [0, 1] again.
inline Picture disturbed(Picture picture, float amplitude, unsigned seed) {
    auto const added = noise(picture.size, seed);
    auto const clamped = [](float a) { return std::clamp(a, 0.f, 1.f); };
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        auto const p = picture.pixels[i] + (added.pixels[i] - 0.5f) * (2.f * amplitude);
        picture.pixels[i] = {clamped(p.x), clamped(p.y), clamped(p.z)};
    }
    return picture;
}

/// Something with slopes, edges and lines.
inline Picture scene(Extent size) {
    auto result = constant(size, {});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const s = static_cast<float>(x) / static_cast<float>(size.width),
                       t = static_cast<float>(y) / static_cast<float>(size.height);
            auto const line = x % 9 == 4 ? 0.3f : 0.f;
            result.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)] = {
                0.7f * s + line, s + t < 0.9f ? 0.6f * t : 0.9f, 0.5f + 0.4f * (s - t)};
        }
    return result;
}

/// The left half of the picture.
inline Mask left_half(Extent size) {
    Mask mask(static_cast<std::size_t>(size.pixels()));
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = static_cast<int>(i) % size.width < size.width / 2;
    return mask;
}

/// The left half of one picture beside the right half of another.
inline Picture halves(Picture const& left, Picture right) {
    auto const mask = left_half(left.size);
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i] != 0) right.pixels[i] = left.pixels[i];
    return right;
}

/// Whether f throws a quell::Error whose message holds all these words.
inline bool refuses(std::function<void()> const& f, std::vector<std::string> const& words) {
    try {
        f();
    } catch (quell::Error const& error) {
        std::string const message = error.what();
        INFO("message: " << message);
        for (auto const& word : words) {
            INFO("expected in it: " << word);
            CHECK(message.find(word) != std::string::npos);
        }
        return true;
    }
    return false;
}

/// What every metric of two pictures must refuse.
inline void refuses_broken_input(std::function<double(Picture const&, Picture const&, Mask const&)> const& metric) {
    auto const good = noise({4, 3}, 1);
    CHECK(refuses([&] { metric(good, noise({5, 2}, 1), {}); }, {"4x3", "5x2"}));
    CHECK(refuses([&] { metric(constant({0, 7}, {}), good, {}); }, {"reference", "0x7", "1x1"}));
    CHECK(refuses([&] { metric(good, {{4, 3}, std::vector<glm::vec3>(11)}, {}); }, {"test", "4x3", "11", "12"}));
    CHECK(refuses([&] { metric(good, good, Mask(13, 1)); }, {"mask", "13", "12"}));
    CHECK(refuses([&] { metric(good, good, Mask(12, 0)); }, {"mask", "0 of the 12"}));
    for (float const bad : {-0.01f, 1.01f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        auto broken = good;
        broken.pixels[6].y = bad;
        CHECK(refuses([&] { metric(good, broken, {}); }, {"test", "(2, 1)", std::to_string(bad)}));
    }
}

} // namespace pictures
