#include <quell/blur/two_motions/stratified_mean.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace quell;

namespace {
struct At {
    float when, value, weight;
};
/// Of `parts` equal parts, each has the mean of its samples, or where it has none half of the next one before it that has and half of the
/// next one after it. Each counts by `exposed`.
double filled_parts(std::vector<At> const& samples, int parts, auto&& exposed) {
    std::vector<double> sum(static_cast<std::size_t>(parts)), weight(sum);
    for (auto const& s : samples) {
        auto const part = static_cast<std::size_t>(std::min(static_cast<int>(s.when * static_cast<float>(parts)), parts - 1));
        sum[part] += static_cast<double>(s.value) * s.weight, weight[part] += s.weight;
    }
    double mean = 0, total = 0;
    for (int i = 0; i < parts; ++i) {
        double found = 0, n = 0;
        auto const look = [&](int step) {
            for (int k = i; k >= 0 && k < parts; k += step) {
                auto const at = static_cast<std::size_t>(k);
                if (weight[at] <= 0) continue;
                found += sum[at] / weight[at], ++n;
                return;
            }
        };
        look(-1), look(1);
        mean += found / std::max(n, 1.) * exposed(i), total += exposed(i);
    }
    return mean / total;
}
using Means = detail::StratifiedMean<Value<1, float>, 32>;
Means of(std::vector<At> const& samples, float pixels) {
    Means means(pixels);
    for (auto const& s : samples) means.add({s.value * s.weight}, s.weight, s.when);
    return means;
}
float mean(std::vector<At> const& samples, float pixels) { return component<0>(of(samples, pixels).mean()); }
} // namespace

TEST_CASE("each part of the open shutter has the mean of its samples, or of the next ones where it has none") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit;
    for (int const count : {1, 2, 3, 5, 9, 32})
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<At> samples;
            for (int i = 0; i < count; ++i) samples.push_back({unit(random), unit(random), unit(random) + 0.1f});
            detail::Strata<float> exposed;
            for (auto& e : exposed.at) e = unit(random) + 0.01f;
            for (int const parts : {1, 2, 5, 8}) {
                auto const means = of(samples, static_cast<float>(parts) * Means::pixels_a_part);
                CHECK(component<0>(means.mean()) == doctest::Approx(filled_parts(samples, parts, [](int) { return 1.; })));
                CHECK(component<0>(means.mean(exposed)) ==
                      doctest::Approx(filled_parts(samples, parts, [&](int i) { return static_cast<double>(exposed.at[i]); })));
                for (int i = 0; i < parts; ++i)
                    CHECK(means.last_component().at[i] ==
                          doctest::Approx(filled_parts(samples, parts, [&](int k) { return k == i ? 1. : 0.; })));
            }
        }
}

TEST_CASE("the sums of strata that a device keeps in place of samples are those of the samples") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit;
    detail::StrataSamples<vec2<float>, 32> samples;
    detail::StrataSums<vec2<float>> sums;
    for (int i = 0; i < 32; ++i) {
        vec2<float> const value{unit(random), unit(random)};
        float const weight = unit(random), stratum = std::floor(unit(random) * 8);
        samples.add(value, weight, stratum, true), sums.add(value, weight, stratum, true);
    }
    detail::Strata<float> share;
    for (auto& part : share.at) part = unit(random);
    for (int i = 0; i < detail::max_strata; ++i) {
        CHECK(sums.weights().at[i] == samples.weights().at[i]);
        CHECK(sums.last_sums().at[i] == samples.last_sums().at[i]);
    }
    CHECK(sums.sum_with(share).x == doctest::Approx(samples.sum_with(share).x));
    CHECK(sums.sum_with(share).y == doctest::Approx(samples.sum_with(share).y));
}

TEST_CASE("a mean over no time is that over all of it") {
    auto const means = of({{0.1f, 1, 1}, {0.9f, 3, 1}}, 20);
    CHECK(component<0>(means.mean({})) == doctest::Approx(component<0>(means.mean())));
}

TEST_CASE("a mean over the open shutter needs a sample, and counts from when it opens until it closes") {
    CHECK(mean({}, 20) == 0);
    CHECK(mean({{0, 1, 1}, {1, 3, 1}}, 20) == doctest::Approx(2));
    CHECK(mean({{-0.1f, 1, 1}, {1.1f, 3, 1}}, 20) == doctest::Approx(2));
    CHECK(mean({{0.3f, 7, 0}}, 20) == 0);
}

TEST_CASE("samples at random times tell when something changed better than by how many there are before and after") {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit;
    double error = 0, plain = 0;
    for (int trial = 0; trial < 500; ++trial) {
        float const change = unit(random);
        std::vector<At> samples;
        float before = 0;
        for (int i = 0; i < 8; ++i) {
            float const when = unit(random);
            samples.push_back({when, when < change ? 1.f : 0.f, 1});
            before += samples.back().value / 8;
        }
        error += std::pow(mean(samples, 8) - change, 2), plain += std::pow(before - change, 2);
    }
    CHECK(std::sqrt(error) < 0.7 * std::sqrt(plain));
}
