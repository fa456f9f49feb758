#include <doctest/doctest.h>
#include <quell/execute/executor.hpp>
#include <quell/resolve/picture_brightness.hpp>
#include <quell/resolve/shared_noise.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using namespace quell;

namespace {

constexpr Extent size{96, 64};
using Pixels = std::vector<glm::vec3>;

Pixels white_noise(unsigned seed) {
    std::mt19937 random(seed);
    Pixels noise(static_cast<std::size_t>(size.pixels()));
    for (auto& pixel : noise)
        for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(random() >> 8) / 8388608.f - 1.f;
    return noise;
}
glm::vec3 at(Pixels const& pixels, int x, int y) {
    return pixels[static_cast<std::size_t>(std::clamp(y, 0, size.height - 1) * size.width + std::clamp(x, 0, size.width - 1))];
}
Pixels made(std::function<glm::vec3(int x, int y)> const& of) {
    Pixels pixels;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) pixels.push_back(of(x, y));
    return pixels;
}
/// Noise of which each pixel has the mean of the 3x3 around.
Pixels splatted(Pixels const& noise) {
    return made([&](int x, int y) {
        glm::vec3 sum(0.f);
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) sum += at(noise, x + i, y + j);
        return sum / 3.f;
    });
}
Pixels doubled(Pixels const& noise) {
    return made([&](int x, int y) { return at(noise, x / 2 * 2, y / 2 * 2); });
}
Pixels sum_of(Pixels const& a, Pixels const& b) {
    return made([&](int x, int y) { return at(a, x, y) + at(b, x, y); });
}
float shared(Pixels const& residual) { return shared_noise(detail::in_planes(size, residual).view()); }

} // namespace

TEST_CASE("neighbours share nothing of white noise, and what they share of noise that was spread") {
    CHECK(shared(white_noise(1)) < .1f);
    CHECK(shared(splatted(white_noise(1))) == doctest::Approx(2. / 3.).epsilon(.15)); // six of nine samples
    CHECK(shared(doubled(white_noise(1))) == doctest::Approx(.5).epsilon(.2));        // every second neighbour
    SharedNoise const rule;
    CHECK(independence(rule, shared(white_noise(2))) == 1.f);
    CHECK(independence(rule, shared(splatted(white_noise(2)))) == 0.f);
    CHECK(independence(rule, shared(doubled(white_noise(2)))) == 0.f);
}

TEST_CASE("what a picture has wrong in most of its places is no shared noise, and the unit of light is of no account") {
    auto const wrong = made([](int x, int y) { return glm::vec3(x < 60 ? 2.f * std::sin(.3f * static_cast<float>(x + y)) : 0.f); });
    auto const residual = sum_of(white_noise(3), wrong);
    CHECK(shared(residual) < .15f);
    auto const darker = made([&](int x, int y) { return at(residual, x, y) * 0x1p-40f; });
    CHECK(shared(darker) == shared(residual));
}

TEST_CASE("a residual without noise, of no pixel or with numbers that are not finite shares nothing") {
    CHECK(shared(made([](int, int) { return glm::vec3(0.f); })) == 0.f);
    auto broken = white_noise(4);
    broken[777] = glm::vec3(std::numeric_limits<float>::quiet_NaN()), broken[1234].y = std::numeric_limits<float>::infinity();
    CHECK(shared(broken) < .1f);
    detail::Planes<3> const one(Extent{1, 1});
    CHECK(shared_noise(one.view()) == 0.f);
}

TEST_CASE("of windows, the lesser correlation of neighbours to the right and below, and of these the lower quartile") {
    auto const noise = white_noise(11);
    // More in common below than to the right in some windows, the other way round in others; and something everywhere.
    auto const residual = made([&](int x, int y) {
        auto const part = static_cast<float>(x) / static_cast<float>(size.width);
        return at(noise, x, y) + part * at(noise, x, y + 1) + (1.f - part) * at(noise, x + 1, y) + glm::vec3(.5f);
    });
    constexpr int window = 8;
    std::vector<double> parts;
    for (int top = 0; top + 1 < size.height; top += window)
        for (int left = 0; left + 1 < size.width; left += window) {
            double right = 0., below = 0., square = 0.;
            for (int c = 0; c < 3; ++c) {
                auto const sum = [&](auto const& f) {
                    double all = 0.;
                    for (int y = top; y < std::min(top + window, size.height - 1); ++y)
                        for (int x = left; x < std::min(left + window, size.width - 1); ++x) all += f(x, y);
                    return all;
                };
                auto const e = [&](int x, int y) { return static_cast<double>(at(residual, x, y)[c]); };
                double const mean = sum(e) / sum([](int, int) { return 1.; });
                right += sum([&](int x, int y) { return (e(x, y) - mean) * e(x + 1, y); });
                below += sum([&](int x, int y) { return (e(x, y) - mean) * e(x, y + 1); });
                square += sum([&](int x, int y) { return (e(x, y) - mean) * e(x, y); });
            }
            parts.push_back(std::min(right, below) / square);
        }
    std::ranges::sort(parts);
    CHECK(shared_noise(detail::in_planes(size, residual).view()) == doctest::Approx(parts[parts.size() / 4]));
    SharedNoise const rule{.least = .1f, .most = .3f};
    CHECK(independence(rule, .15f) == doctest::Approx(.75));
}
