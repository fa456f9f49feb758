#include <doctest/doctest.h>
#include <quell/resolve/twicing.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace quell;

namespace {
constexpr Extent size{96, 80};

/// A picture that a filter made, its samples, and what is true, of one flat surface.
struct Denoised {
    std::vector<glm::vec3> truth, samples, picture;
    ImageOf<Planar<>, Normal> normals{size};
    ImageOf<Planar<>, Depth> depths{size};

    /// @param at    the truth at a column and row
    /// @param noise standard deviation of the samples
    template <class Truth> Denoised(Truth&& at, float noise, unsigned seed = 5) {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal_distribution(0.f, noise);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                truth.emplace_back(at(x, y));
                samples.push_back(truth.back() + glm::vec3(normal_distribution(random)));
                picture.emplace_back(1.f);
                normals.view().set(2, x, y, 1.f), depths.view().set(0, x, y, 3.f);
            }
    }
    double error() const {
        double sum = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) sum += std::pow(static_cast<double>(picture[i].x - truth[i].x), 2.);
        return std::sqrt(sum / static_cast<double>(truth.size()));
    }
    Denoised& twice(Executor auto const& executor, Twicing const& rule = {}) {
        add_back_residual(rule, executor, samples, normals.view(), depths.view(), picture);
        return *this;
    }
};
float flat(int, int) { return 1.f; }
/// Waves of 8 pixels that the picture lacks, in the left half.
float waves(int x, int) { return x < size.width / 2 ? 1.f + .3f * std::sin(static_cast<float>(x) * .785398f) : 1.f; }
} // namespace

TEST_CASE("what a filter took out comes back") {
    Denoised seen(waves, .1f);
    double const before = seen.error();
    CHECK(seen.twice(Serial{}).error() < .4 * before);
}

TEST_CASE("noise does not come back") {
    double sum = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) sum += Denoised(flat, .3f, seed).twice(Serial{}).error();
    CHECK(sum / 8. < .02 * .3);
}

TEST_CASE("packs give what single pixels give") {
    Denoised one(waves, .1f), packs(waves, .1f);
    one.twice(Serial{}), packs.twice(Simd{});
    for (std::size_t i = 0; i < one.picture.size(); ++i) REQUIRE(packs.picture[i].x == doctest::Approx(one.picture[i].x).epsilon(1e-5));
}

TEST_CASE("a surface takes nothing of another one") {
    Denoised seen(waves, .05f);
    // The left half lies far behind, and all that differs is there.
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width / 2; ++x) seen.depths.view().set(0, x, y, 300.f);
    seen.twice(Serial{}, {.certainty = 1e6f});
    for (int y = 0; y < size.height; ++y)
        CHECK(std::abs(seen.picture[static_cast<std::size_t>(y * size.width + size.width / 2 + 30)].x - 1.f) < .02f);
}

TEST_CASE("samples that are missing say nothing and spread nothing") {
    Denoised seen(waves, .1f);
    for (std::size_t i = 0; i < seen.samples.size(); i += 3) seen.samples[i].y = std::numeric_limits<float>::quiet_NaN();
    double const before = seen.error();
    CHECK(seen.twice(Serial{}).error() < .6 * before);
    for (auto const& colour : seen.picture) REQUIRE((std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z)));
}

TEST_CASE("of no samples and no surfaces the picture stays") {
    Denoised none(flat, 0.f);
    for (auto& sample : none.samples) sample = glm::vec3(std::numeric_limits<float>::infinity());
    auto const before = none.picture;
    CHECK(none.twice(Serial{}).picture == before);
    Denoised sky(waves, .1f);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            sky.normals.view().set(2, x, y, 0.f);
            sky.depths.view().set(0, x, y, std::numeric_limits<float>::infinity());
        }
    CHECK(sky.twice(Serial{}).picture == before);
}

TEST_CASE("windows above a threshold are noise as often as is asked for") {
    std::vector<double> z;
    for (int i = 0; i < 100; ++i) z.push_back(i < 50 ? 1.2 : -1.2), z.push_back(3.2);
    CHECK(detail::threshold_above_noise(z, .2, 1.).value() == doctest::Approx(1.5));
    CHECK(detail::threshold_above_noise(z, .6, 1.).value() == doctest::Approx(.5));
    CHECK(!detail::threshold_above_noise({-3., 3., -1., 1.}, .2, 0.));
    CHECK(!detail::threshold_above_noise({}, .2, 0.));
}
