#include <tracer/sampler.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

using namespace quell::tracer;

namespace {

/// How many of the first 2^(a+b) points fall into each of 2^a x 2^b equal boxes; the ideal is one in each.
bool one_point_per_box(SampleKey key, SampleUse use, int a, int b) {
    std::vector<int> counts(std::size_t{1} << (a + b));
    for (std::uint32_t i = 0; i < counts.size(); ++i) {
        key.index = i;
        auto const point = sample_pair(key, use);
        auto const column = static_cast<std::size_t>(point.x * static_cast<float>(1 << a)),
                   row = static_cast<std::size_t>(point.y * static_cast<float>(1 << b));
        ++counts[(row << a) + column];
    }
    for (int count : counts)
        if (count != 1) return false;
    return true;
}

} // namespace

TEST_CASE("sample pairs fill every elementary box with exactly one point") {
    for (int x : {0, 1, 977})
        for (auto use : {SampleUse::light_point, SampleUse::glossy, SampleUse::indirect})
            for (int a = 0; a <= 8; ++a) CHECK(one_point_per_box({{x, 3 * x}, 0, 42}, use, a, 8 - a));
}

TEST_CASE("sample pairs of different pixels, uses and seeds are unrelated") {
    std::set<float> seen;
    for (int x = 0; x < 16; ++x)
        for (int y = 0; y < 16; ++y)
            for (std::uint32_t seed = 0; seed < 4; ++seed)
                for (auto use : {SampleUse::light_point, SampleUse::glossy, SampleUse::indirect, SampleUse::lens})
                    seen.insert(sample_pair({{x, y}, 0, seed}, use).x);
    CHECK(seen.size() >= 4090);
}

TEST_CASE("sample pairs are uniform and the two numbers uncorrelated over pixels") {
    double x = 0, y = 0, xy = 0, xx = 0;
    constexpr int side = 300;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            auto const point = sample_pair({{i, j}, 5, 1}, SampleUse::light_point);
            x += point.x, y += point.y, xy += point.x * point.y, xx += point.x * point.x;
        }
    double const count = side * side;
    CHECK(x / count == doctest::Approx(0.5).epsilon(0.01));
    CHECK(y / count == doctest::Approx(0.5).epsilon(0.01));
    CHECK(xx / count == doctest::Approx(1. / 3).epsilon(0.015));
    CHECK(xy / count == doctest::Approx(0.25).epsilon(0.015));
}

TEST_CASE("sample pairs are a pure function of their key") {
    SampleKey const key{{12, 34}, 56, 78};
    CHECK(sample_pair(key, SampleUse::glossy, 2) == sample_pair(key, SampleUse::glossy, 2));
    CHECK(sample_pair(key, SampleUse::glossy, 2) != sample_pair(key, SampleUse::glossy, 3));
}

TEST_CASE("numbers stay below one") {
    CHECK(detail::unit_interval(~0u) < 1.f);
    CHECK(detail::unit_interval(0) == 0.f);
}

TEST_CASE("lone samples are uniform and as far apart as chance has it, where pairs share the range out") {
    double lone = 0, lone_squared = 0, shared_squared = 0;
    constexpr int pixels = 20000, samples = 8;
    for (int x = 0; x < pixels; ++x) {
        double alone = 0, together = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            SampleKey const key{{x, 7}, i, 3};
            alone += lone_sample(key, SampleUse::time) / samples;
            together += sample_pair(key, SampleUse::time).x / samples;
        }
        lone += alone / pixels, lone_squared += (alone - 0.5) * (alone - 0.5) / pixels;
        shared_squared += (together - 0.5) * (together - 0.5) / pixels;
    }
    CHECK(lone == doctest::Approx(0.5).epsilon(0.003));
    CHECK(lone_squared == doctest::Approx(1. / 12 / samples).epsilon(0.05)); // of independent samples
    CHECK(shared_squared < 0.05 * lone_squared);
}
