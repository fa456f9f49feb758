#include "flat_surface.hpp"

#include <doctest/doctest.h>
#include <quell/execute/threads.hpp>
#include <quell/resolve/residual_feedback.hpp>

#include <cmath>
#include <limits>

using namespace quell;
using namespace quell::tests;

namespace {
struct Fed : FlatSurface {
    using FlatSurface::FlatSurface;

    Fed& feed(Executor auto const& executor, float count) {
        // What waves lack here they lack nearly everywhere, and there is next to no noise beside.
        ResidualFeedback const rule{.samples = count, .of_neighbours = {.least = 2.f, .most = 3.f}};
        feed_back_residual(rule, executor, samples, normals.view(), depths.view(), picture);
        return *this;
    }
};
float flat(int, int) { return 1.f; }
float brighter(int, int) { return 1.1f; }
/// Waves of 8 pixels that the picture lacks, in the left half.
float waves(int x, int) { return x < size.width / 2 ? 1.f + .3f * std::sin(static_cast<float>(x) * .785398f) : 1.f; }
} // namespace

TEST_CASE("residual feedback: a picture that is as its samples stays") {
    for (float const count : {1.f, 4.f, 16.f, 256.f}) {
        Fed seen(flat, 0.f);
        auto const before = seen.picture;
        CHECK(seen.feed(Serial{}, count).picture == before);
    }
}

TEST_CASE("residual feedback: what a filter took out comes back") {
    for (auto const& each : {std::pair{1.f, .95}, std::pair{4.f, .75}, std::pair{16.f, .55}}) {
        CAPTURE(each.first);
        Fed seen(waves, .1f);
        double const before = seen.error();
        CHECK(seen.feed(Serial{}, each.first).error() < each.second * before);
    }
}

TEST_CASE("residual feedback: light that the picture lacks everywhere comes back in part, and never more than that") {
    for (float const noise : {0.f, .001f, .01f, .1f, .5f})
        for (float const count : {1.f, 4.f, 16.f, 64.f}) {
            CAPTURE(noise);
            CAPTURE(count);
            Fed seen(brighter, noise);
            seen.feed(Serial{}, count);
            double mean = 0;
            for (auto const& colour : seen.picture) mean += static_cast<double>(colour.x) / static_cast<double>(size.pixels());
            CHECK(mean > 1.01);
            CHECK(mean < 1.11);
        }
}

TEST_CASE("residual feedback: little of the noise comes back, and nothing of it in the mean") {
    for (float const count : {1.f, 16.f}) {
        CAPTURE(count);
        double error = 0, mean = 0;
        for (unsigned seed = 1; seed <= 8; ++seed) {
            Fed seen(flat, .3f, seed);
            error += seen.feed(Serial{}, count).error() / 8.;
            for (auto const& colour : seen.picture) mean += static_cast<double>(colour.x - 1.f) / 8. / static_cast<double>(size.pixels());
        }
        CHECK(error < .2 * .3);
        CHECK(std::abs(mean) < .003);
    }
}

TEST_CASE("residual feedback: threads give the same bits, and packs nearly") {
    Fed one(waves, .1f), two(waves, .1f), three(waves, .1f), packs(waves, .1f);
    one.feed(Threads<>{.count = 1}, 16.f), two.feed(Threads<>{.count = 2}, 16.f), three.feed(Threads<>{.count = 3}, 16.f);
    CHECK(one.picture == two.picture);
    CHECK(one.picture == three.picture);
    packs.feed(Simd{}, 16.f);
    for (std::size_t i = 0; i < one.picture.size(); ++i) REQUIRE(packs.picture[i].x == doctest::Approx(one.picture[i].x).epsilon(1e-4));
}

TEST_CASE("residual feedback: what is bad spreads nothing") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    Fed seen(waves, .1f);
    for (std::size_t i = 0; i < seen.samples.size(); i += 3) seen.samples[i].y = i % 2 == 0 ? nan : infinity;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < size.width; ++x) seen.depths.view().set(0, x, y, infinity), seen.normals.view().set(2, x, y, 0.f);
    seen.picture[700] = glm::vec3(infinity);
    feed_back_residual({.samples = 16.f}, Simd{}, seen.samples, seen.normals.view(), seen.depths.view(), seen.picture);
    for (std::size_t i = 0; i < seen.picture.size(); ++i)
        if (i != 700) REQUIRE((std::isfinite(seen.picture[i].x) && std::isfinite(seen.picture[i].y) && std::isfinite(seen.picture[i].z)));
    CHECK(seen.picture[700] == glm::vec3(infinity));
}

TEST_CASE("residual feedback: of no samples the picture stays, and light never turns negative") {
    Fed none(flat, 0.f), dark(flat, 0.f);
    for (auto& sample : none.samples) sample = glm::vec3(std::numeric_limits<float>::infinity());
    auto const before = none.picture;
    CHECK(none.feed(Serial{}, 16.f).picture == before);
    for (auto& sample : dark.samples) sample = glm::vec3(0.f);
    for (auto const& colour : dark.feed(Serial{}, 16.f).picture) CHECK(colour.x >= .2f);
}

TEST_CASE("residual feedback: shares of few samples lie between those of 1 and of 16") {
    auto const one = ResidualFeedbackShares::of_samples(1.f), four = ResidualFeedbackShares::of_samples(4.f),
               many = ResidualFeedbackShares::of_samples(16.f);
    CHECK(one.wide == feedback_of_1_sample.wide);
    CHECK(four.fine_held == doctest::Approx(.5f * (one.fine_held + many.fine_held)));
    CHECK(many.wide_noise == doctest::Approx(feedback_of_16_samples.wide_noise));
    CHECK(ResidualFeedbackShares::of_samples(256.f).fine_held == many.fine_held);
    CHECK(ResidualFeedbackShares::of_samples(0.f).fine_held == one.fine_held);
    CHECK(ResidualFeedbackShares::beside_history(1.f).wide == 0.f);
    CHECK(ResidualFeedbackShares::beside_history(4.f).wide == doctest::Approx(.5f * four.wide));
    CHECK(ResidualFeedbackShares::beside_history(64.f).wide == many.wide);
}

TEST_CASE("residual feedback: other shares take the place of fitted ones") {
    auto const fed_by = [](ResidualFeedbackShares const& shares) {
        Fed seen(brighter, 0.f);
        feed_back_residual({.shares = shares}, Serial{}, seen.samples, seen.normals.view(), seen.depths.view(), seen.picture);
        return seen.picture;
    };
    Fed const before(brighter, 0.f);
    CHECK(fed_by({}) == before.picture);
    auto const middle = [](auto const& picture) { return picture[size.width * size.height / 2 + size.width / 2].x; };
    CHECK(middle(fed_by({.wide = 1.f})) == doctest::Approx(1.1f));
    CHECK(middle(fed_by({.wide = .5f})) == doctest::Approx(1.05f));
    CHECK(middle(fed_by({.wide = 2.f})) == doctest::Approx(1.1f)); // never more than whole
    CHECK(middle(fed_by({.wide_noise = -.5f})) == doctest::Approx(1.f + .1f * -.5f * std::log2(.1f) / 3.f).epsilon(1e-3));
    CHECK(middle(fed_by({.fine_held = 1.f})) == doctest::Approx(1.f)); // an even light has no band
}

TEST_CASE("residual feedback: small images stay finite, and other sizes are refused") {
    for (Extent const small : {Extent{1, 1}, Extent{1, 9}, Extent{17, 1}, Extent{3, 2}}) {
        auto const pixels = static_cast<std::size_t>(small.pixels());
        ImageOf<Planar<>, Normal> normals(small);
        ImageOf<Planar<>, Depth> depths(small);
        std::vector<glm::vec3> const samples(pixels, glm::vec3(2.f));
        std::vector<glm::vec3> picture(pixels, glm::vec3(1.f));
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) normals.set(x, y, {0.f, 0.f, 1.f}), depths.set(x, y, 3.f);
        feed_back_residual({}, Simd{}, samples, normals.view(), depths.view(), picture);
        for (auto const& colour : picture) CHECK((colour.x >= 1.f && colour.x <= 2.f));
        picture.emplace_back(1.f);
        CHECK_THROWS_AS(feed_back_residual({}, Simd{}, samples, normals.view(), depths.view(), picture), Error);
        picture.pop_back();
        CHECK_THROWS_AS(feed_back_residual({.limits = {.noise_radius = 17}}, Simd{}, samples, normals.view(), depths.view(), picture),
                        Error);
        CHECK_THROWS_AS(feed_back_residual({.held_radius = 17}, Simd{}, samples, normals.view(), depths.view(), picture), Error);
        CHECK_THROWS_AS(feed_back_residual({.held_variance = 0.f}, Simd{}, samples, normals.view(), depths.view(), picture), Error);
    }
}

TEST_CASE("a logarithm is that of the standard library, for packs too") {
    for (float const a : {1e-30f, 3e-7f, .5f, .70710677f, .70710678f, .99999f, 1.f, 1.00001f, 1.41421f, 1.41422f, 2.f, 123.f, 1e30f}) {
        CAPTURE(a);
        float const right = std::log(a);
        CHECK(std::abs(detail::logarithm(a) - right) <= 2e-7f * std::max(std::abs(right), 1.f));
        CHECK(lane(detail::logarithm(Pack(a)), 0) == doctest::Approx(right).epsilon(1e-6));
    }
}
