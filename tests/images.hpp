#pragma once

#include <quell/quell.hpp>

#include <cmath>
#include <random>
#include <vector>

// Fills the images of frames, and copies images. Without doctest, which throws.
namespace quell::tests {

/// Fills a channel by f(x, y).
template <class Image, class F> void fill(Image& image, F&& f) {
    for (int y = 0; y < image.size().height; ++y)
        for (int x = 0; x < image.size().width; ++x) image.set(x, y, f(x, y));
}

/// What a random frame has at a pixel: guides as a renderer makes them (several surfaces, unit normals, small motion), signals of any size.
struct RandomValue {
    std::mt19937& random;
    float next(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }

    float of(Depth, int x, int y) { return x % 11 < 7 ? 5.f + 0.02f * static_cast<float>(x + y) : next(2.f, 9.f); }
    float of(Instance, int x, int) {
        int const strip = x / 9;
        return static_cast<float>(strip);
    }
    glm::vec3 of(Normal, int x, int) {
        glm::vec3 const n(next(-0.2f, 0.2f), next(-0.2f, 0.2f), x % 13 < 9 ? 1.f : -1.f);
        float const length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        return {n.x / length, n.y / length, n.z / length};
    }
    glm::vec2 of(Motion, int, int) { return {next(-2.5f, 2.5f), next(-2.5f, 2.5f)}; }
    glm::vec3 of(Albedo, int x, int) { return {next(0.f, 1.f), x % 7 == 0 ? 0.f : 0.5f, next(0.1f, 1.f)}; }
    template <class C> auto of(C, int, int) {
        if constexpr (C::components == 1)
            return next(0.f, 1.f);
        else if constexpr (C::components == 2)
            return glm::vec2(next(0.f, 3.f), next(0.f, 3.f));
        else if constexpr (C::components == 4)
            return glm::vec4(next(0.f, 3.f), next(0.f, 3.f), next(0.f, 3.f), next(0.f, 1.f));
        else
            return glm::vec3(next(0.f, 3.f), next(0.f, 3.f), next(0.f, 3.f));
    }
};

template <class F> void fill_randomly(F& frame, unsigned seed) {
    std::mt19937 random(seed);
    for_each_channel(typename F::channels{},
                     [&](auto c) { fill(frame[c], [&](int x, int y) { return RandomValue{random}.of(c, x, y); }); });
}

/// A frame in which nothing moves: one plane that faces the camera, black everywhere else.
template <class F> void fill_still(F& frame) {
    for_each_channel(typename F::channels{}, [&](auto c) {
        using C = decltype(c);
        fill(frame[c], [](int, int) {
            if constexpr (std::is_same_v<C, Depth>)
                return 4.f;
            else if constexpr (std::is_same_v<C, Normal>)
                return glm::vec3(0, 0, 1);
            else if constexpr (std::is_same_v<C, Albedo>)
                return glm::vec3(1);
            else
                return Value<C::components, float>(0.f);
        });
    });
}

/// All components of an image, row by row.
template <ImageView View> std::vector<float> copy_of(View const& view) {
    std::vector<float> all;
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x)
            for (int c = 0; c < View::components; ++c) all.push_back(view.get(c, x, y));
    return all;
}

} // namespace quell::tests
