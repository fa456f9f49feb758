#pragma once

#include <doctest/doctest.h>
#include <quell/quell.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

// Frames to test with, and ways to compare what comes out.
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

/// What the Error says that f throws.
template <class F> std::string message(F&& f) {
    try {
        f();
    } catch (Error const& e) {
        return e.what();
    }
    return "nothing thrown";
}

/// All components of an image, row by row.
template <ImageView View> std::vector<float> copy_of(View const& view) {
    std::vector<float> all;
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x)
            for (int c = 0; c < View::components; ++c) all.push_back(view.get(c, x, y));
    return all;
}

/// What a pipeline makes of the last of three frames of random guides and signals. `change` is called with each frame, once it is filled,
/// and its number: it sets the camera, for instance.
template <class P> std::vector<float> sequence(P const& denoise, Extent size, auto const& executor, auto&& change) {
    Frame frame{size, denoise};
    History history{size, denoise};
    std::vector<float> out;
    for (unsigned i = 0; i < 3; ++i) {
        fill_randomly(frame, i);
        change(frame, i);
        out = copy_of(run(denoise, frame, history, executor));
    }
    return out;
}
template <class P> std::vector<float> sequence(P const& denoise, Extent size, auto const& executor) {
    return sequence(denoise, size, executor, [](auto&, unsigned) {});
}

/// The greatest difference relative to max(1, |a|).
inline double difference(std::vector<float> const& a, std::vector<float> const& b) {
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double const scale = std::max(1.0, std::abs(static_cast<double>(a[i])));
        double const d = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) / scale;
        worst = d > worst || d != d ? d : worst;
    }
    return worst;
}

inline double root_mean_square(std::vector<float> const& a, std::vector<float> const& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (static_cast<double>(a[i]) - b[i]) * (static_cast<double>(a[i]) - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

inline bool all_finite(std::vector<float> const& all) {
    for (float const a : all)
        if (!is_finite(a)) return false;
    return true;
}

} // namespace quell::tests
