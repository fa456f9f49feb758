#include <doctest/doctest.h>
#include <quell/resolve/agreement.hpp>

#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

using namespace quell;

namespace {

constexpr Extent size{64, 48};

/// White noise: from -1 to 1, another number for each pixel and frame.
float noise(int x, int y, int frame) {
    auto bits = static_cast<unsigned>(x) * 73856093u ^ static_cast<unsigned>(y) * 19349663u ^ static_cast<unsigned>(frame + 16) * 83492791u;
    bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du, bits = (bits ^ (bits >> 12)) * 0x297a2d39u;
    return static_cast<float>((bits ^ (bits >> 15)) >> 8) / 8388608.f - 1.f;
}

/// What a pixel of a frame shows.
using Texture = std::function<float(int x, int y, int frame)>;

struct TestFrame {
    ImageOf<Planar<>, Albedo> colour{size};
    ImageOf<Planar<>, Depth> depth{size};
    ImageOf<Planar<>, Motion> motion{size};

    TestFrame(Texture const& texture, int number) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                depth.view().set(0, x, y, 3.f);
                for (int c = 0; c < 3; ++c) colour.view().set(c, x, y, texture(x, y, number));
                for (int c = 0; c < 2; ++c) motion.view().set(c, x, y, 0.f);
            }
    }
    [[nodiscard]] ColouredFrame<> view() const { return {colour.view(), depth.view(), motion.view(), motion.view()}; }
};

/// Frame 0 by the four frames before it and those after it. Vectors say that nothing moves.
struct Made {
    ImageOf<Planar<>, Albedo> light{size}, to{size};
    Planar<>::Image<1> agrees;

    explicit Made(Texture const& texture, int samples = 1) : agrees(size) {
        std::deque<TestFrame> frames;
        std::vector<ColouredFrame<>> before, after;
        for (int k = 1; k <= AntiAliased::most_frames; ++k) {
            before.push_back(frames.emplace_back(texture, -k).view());
            after.push_back(frames.emplace_back(texture, k).view());
        }
        TestFrame const here(texture, 0);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (int c = 0; c < 3; ++c) light.view().set(c, x, y, 2.f);
        agrees = anti_alias_where_agreed({static_cast<float>(samples)}, AntiAliased::of_samples(samples), Simd{}, here.view(),
                                         std::span<ColouredFrame<> const>(before), std::span<ColouredFrame<> const>(after), light.view(),
                                         to.view());
    }
    /// The root mean square of the picture less twice a texture.
    [[nodiscard]] float error(Texture const& truth) const {
        double sum = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) sum += std::pow(static_cast<double>(to.view().get(1, x, y) - 2.f * truth(x, y, 0)), 2);
        return static_cast<float>(std::sqrt(sum / (size.height * size.width)));
    }
    [[nodiscard]] float mean_agreement() const {
        float sum = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) sum += agrees.view().get(0, x, y);
        return sum / static_cast<float>(size.height * size.width);
    }
};

/// A film that goes on, 3 pixels a frame to the right and 2 down.
float film(int x, int y, int frame) {
    return .5f + .2f * std::sin(.7f * static_cast<float>(x - 3 * frame)) + .2f * std::sin(.5f * static_cast<float>(y - 2 * frame));
}

} // namespace

TEST_CASE("noise of single samples is averaged: what frames around tell agrees") {
    auto const still = [](int x, int y, int) { return film(x, y, 0); };
    auto const noisy = [&](int x, int y, int frame) { return still(x, y, 0) + .1f * noise(x, y, frame); };
    Made const made(noisy);
    CHECK(made.mean_agreement() > .85f);
    CHECK(made.error(still) < .6f * 2.f * .1f / std::sqrt(3.f));
}

TEST_CASE("a texture that moves without vectors stays as its own frame shows it") {
    for (int const samples : {1, 4, 16}) {
        Made const made(film, samples);
        // By one sample it can't be told whether neighbours differ by noise; the film's own deviation is .4.
        CHECK(made.mean_agreement() < (samples == 1 ? .3f : .1f));
        CHECK(made.error(film) < (samples == 1 ? .06f : .015f));
    }
}

TEST_CASE("colours that are not finite spread nowhere") {
    auto const broken = [](int x, int y, int frame) {
        return x == 20 && y == 20 ? std::numeric_limits<float>::quiet_NaN() : film(x, y, frame);
    };
    Made const made(broken);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (x != 20 || y != 20) CHECK(std::isfinite(made.to.view().get(0, x, y)));
}

TEST_CASE("frames around count by the noise over the squared difference, of the pixels of a window") {
    detail::Planes<3> own(size), others(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c) {
                own.view().set(c, x, y, film(x, y, c) + .3f * noise(x, y, c));
                others.view().set(c, x, y, x % 9 == 4 ? std::numeric_limits<float>::quiet_NaN() : film(x, y, c) + .2f * noise(x, y, c + 3));
            }
    auto const colour = [](auto const& image, int x, int y) {
        return glm::dvec3(image.view().get(0, x, y), image.view().get(1, x, y), image.view().get(2, x, y));
    };
    auto const square = [](glm::dvec3 const& v) { return glm::dot(v, v); };
    // Samples, their noise's share of the variance between neighbours, and that of white noise.
    for (auto const& [rule, share, white] :
         {std::tuple{Agreement{.samples = 4.f, .radius = 3}, .2, .2},
          std::tuple{Agreement{.samples = 9.f, .is_blurred = true, .radius = 2}, 1.6 / 27., 16. / 81.}}) {
        auto const made = detail::agreement(rule, Simd{}, own.view(), others.view());
        double worst = 0.;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double off = 0., g[3]{};
                for (int j = std::max(y - rule.radius, 0); j <= std::min(y + rule.radius, size.height - 1); ++j)
                    for (int i = std::max(x - rule.radius, 0); i <= std::min(x + rule.radius, size.width - 1); ++i) {
                        if (i % 9 == 4) continue;
                        off += square(colour(others, i, j) - colour(own, i, j));
                        for (int const h : {1, 2}) {
                            if (i + h < size.width) g[h] += square(colour(own, i + h, j) - colour(own, i, j)) / 4.;
                            if (j + h < size.height) g[h] += square(colour(own, i, j + h) - colour(own, i, j)) / 4.;
                        }
                    }
                double const nugget = std::clamp(2. * g[1] - g[2], 0., g[1]);
                double const wanted = std::min(((g[1] - nugget) * share + nugget * white) / off, 1.);
                worst = std::max(worst, std::abs(static_cast<double>(made.view().get(0, x, y)) - wanted));
            }
        CHECK(worst < 1e-4);
    }
}
