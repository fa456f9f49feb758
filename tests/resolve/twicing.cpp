#include "flat_surface.hpp"

#include <doctest/doctest.h>
#include <quell/resolve/twicing.hpp>

#include <cmath>
#include <limits>

using namespace quell;
using namespace quell::tests;

namespace {
struct Denoised : FlatSurface {
    using FlatSurface::FlatSurface;

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

TEST_CASE("what is no light says nothing: it is no sample to a pipeline either") {
    Denoised seen(flat, 0.f), whole(flat, 0.f);
    for (std::size_t i = 0; i < seen.samples.size(); i += 5)
        seen.samples[i] = i % 3 == 0 ? glm::vec3(-1.f) : i % 3 == 1 ? glm::vec3(1e17f) : glm::vec3(std::numeric_limits<float>::infinity());
    CHECK(seen.twice(Serial{}).picture == whole.picture);
}

TEST_CASE("a picture that is negative in the mean has limits like its reverse") {
    std::vector<glm::vec3> const samples{glm::vec3(1.f)}, dark{glm::vec3(-1.f)}, bright{glm::vec3(1.f)};
    detail::PictureResidual const below({}, {1, 1}, samples, dark), above({}, {1, 1}, samples, bright);
    CHECK(below.value[0] == glm::vec3(2.f));
    CHECK(above.value[0] == glm::vec3(0.f));
    CHECK(above.mean_square[0] == doctest::Approx(below.mean_square[0] - 12.).epsilon(1e-9));
}

TEST_CASE("images of one pixel, one row and one column stay finite") {
    for (Extent const small : {Extent{1, 1}, Extent{1, 9}, Extent{17, 1}, Extent{3, 2}}) {
        CAPTURE(to_string(small));
        auto const pixels = static_cast<std::size_t>(small.pixels());
        ImageOf<Planar<>, Normal> normals(small);
        ImageOf<Planar<>, Depth> depths(small);
        std::vector<glm::vec3> samples(pixels, glm::vec3(2.f)), picture(pixels, glm::vec3(1.f));
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) normals.set(x, y, {0.f, 0.f, 1.f}), depths.set(x, y, 3.f);
        samples[0] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        add_back_residual({}, Simd{}, samples, normals.view(), depths.view(), picture);
        for (auto const& colour : picture) CHECK((colour.x >= 1.f && colour.x <= 2.f));
    }
}

TEST_CASE("images of other sizes are refused") {
    Denoised seen(flat, 0.f);
    auto const refused = [&] { CHECK_THROWS_AS(seen.twice(Serial{}), Error); };
    seen.samples.pop_back(), refused();
    seen.samples.emplace_back(1.f), seen.picture.pop_back(), refused();
    seen.picture.emplace_back(1.f), seen.normals = ImageOf<Planar<>, Normal>({size.width - 1, size.height}), refused();
}

TEST_CASE("windows above a threshold are noise as often as is asked for") {
    std::vector<double> z;
    for (int i = 0; i < 100; ++i) z.push_back(i < 50 ? 1.2 : -1.2), z.push_back(3.2);
    CHECK(detail::threshold_above_noise(z, .2, 1.).value() == doctest::Approx(1.5));
    CHECK(detail::threshold_above_noise(z, .6, 1.).value() == doctest::Approx(.5));
    CHECK(!detail::threshold_above_noise({-3., 3., -1., 1.}, .2, 0.));
    CHECK(!detail::threshold_above_noise({}, .2, 0.));
}
