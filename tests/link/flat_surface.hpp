#pragma once

#include "../frames.hpp"

#include <quell/link/light_given_back.hpp>

#include <limits>
#include <random>

// A filter's picture of a flat surface, of light 1 everywhere, whose samples know better. Pictures are as of copy_of().
namespace quell::tests {

inline constexpr float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
inline constexpr Extent flat_size{96, 80};
using Pixels = std::vector<float>;

/// A grey picture of f(x, y).
inline Pixels grey(auto const& f) {
    Pixels picture;
    for (int y = 0; y < flat_size.height; ++y)
        for (int x = 0; x < flat_size.width; ++x) picture.insert(picture.end(), 3, f(x, y));
    return picture;
}
inline Pixels const flat(3 * 96 * 80, 1.f);
/// Stripes that move right by `shift`, finer than a filter keeps.
inline Pixels stripes(int shift = 0, float height = .5f) {
    return grey([&](int x, int) { return (x - shift + 96) % 4 < 2 ? 1.f + height : 1.f - height; });
}
/// Each pixel's three components get the same.
inline Pixels with_noise(Pixels picture, float deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(0.f, deviation);
    for (std::size_t i = 0; i < picture.size(); i += 3)
        for (float const more = noise(random); auto& a : std::span(picture).subspan(i, 3)) a += more;
    return picture;
}
/// Four pixels share a sample.
inline Pixels shared(Pixels const& samples) {
    return grey([&](int x, int y) { return samples[static_cast<std::size_t>(3 * (y / 2 * 2 * flat_size.width + x / 2 * 2))]; });
}
inline Pixels scaled(Pixels picture, float factor) {
    for (auto& each : picture) each *= factor;
    return picture;
}
inline void put(auto& image, Pixels const& picture) {
    fill(image, [pixel = picture.begin()](int, int) mutable { return pixel += 3, glm::vec3(pixel[-3], pixel[-2], pixel[-1]); });
}

/// A link behind that picture. The surface stands still in front of the camera.
template <class Link> struct FlatSurface {
    Link link;
    Frame<typename Link::reads> frame;
    History<Link> history;

    explicit FlatSurface(Link const& l, Extent size = flat_size) : link(l), frame(size), history(size, link) {
        fill_still(frame);
        if constexpr (Link::reads::template has<Denoised>) fill(frame[denoised], [](int, int) { return glm::vec3(1.f); });
    }
    /// What is made of the next samples.
    Pixels run(Pixels const& samples) { return put(frame[radiance], samples), copy_of(quell::run(link, frame, history)); }
};

} // namespace quell::tests
