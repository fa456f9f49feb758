#include <doctest/doctest.h>
#include <quell/resolve/evidence.hpp>

#include <array>
#include <random>

using namespace quell;

namespace {
/// The part of A over an image where the truth is 1, A and B are off by so much, and samples have skewed noise of mean 1.
double part(float a, float b, Evidence const& rule = {}) {
    constexpr Extent size{48, 40};
    EvidenceSums sums(size);
    std::mt19937 random(7);
    std::exponential_distribution<float> noise(1.f);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size.pixels()); ++i) {
        std::array<float, 3> const sample{noise(random), noise(random), noise(random)}, first{1.f + a, 1.f + a, 1.f + a},
            second{1.f + b, 1.f + b, 1.f + b};
        sums.add(rule, i, sample, first, second);
    }
    double sum = 0;
    auto const parts = sums.parts(rule);
    for (float const p : parts) sum += static_cast<double>(p);
    return sum / static_cast<double>(parts.size());
}
} // namespace

TEST_CASE("samples choose what is true") {
    CHECK(part(0.f, .5f) > .9);
    CHECK(part(.5f, 0.f) < .1);
    CHECK(part(.3f, -.3f) == doctest::Approx(.5).epsilon(.2));
    CHECK(part(-.6f, .2f) == doctest::Approx(.25).epsilon(.3));
}

TEST_CASE("where both agree nothing is changed") {
    CHECK(part(.2f, .2f) == doctest::Approx(1.));
    CHECK(part(.2f, .2f, {.at_first = .25f}) == doctest::Approx(.25));
}

TEST_CASE("a sample that is not finite says nothing") {
    EvidenceSums sums({3, 3});
    std::array<float, 3> const none{std::numeric_limits<float>::quiet_NaN(), 1.f, std::numeric_limits<float>::infinity()}, a{2.f, 2.f, 2.f},
        b{1.f, 1.f, 1.f};
    sums.add({}, 4, none, a, b);
    for (float const p : sums.parts({.radius = 1, .trust = 1e-6f})) CHECK((p >= 0.f && p <= 1.f));
}
