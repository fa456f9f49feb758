#include <denoise/repeated_detail.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace quell;
using namespace quell::examples;

namespace {

constexpr Extent size{96, 64};
constexpr std::size_t pixels = 96 * 64;
using Motions = ImageOf<Planar<>, Motion>;

Motions motion_of(float x) {
    Motions motion(size);
    for (int j = 0; j < size.height; ++j)
        for (int i = 0; i < size.width; ++i) motion.view().set(0, i, j, x), motion.view().set(1, i, j, 0.f);
    return motion;
}
metrics::Picture flat(float value) { return {size, std::vector<glm::vec3>(pixels, glm::vec3(value))}; }
/// Grey values about 1 that know nothing of each other; each pixel is the mean of `of` of them. Half a pixel farther at `shift` 1.
metrics::Picture texture(unsigned seed, std::size_t of = 1, std::size_t shift = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> some(.5f, 1.5f);
    std::vector<float> values(of * pixels + 1);
    for (auto& value : values) value = some(random);
    metrics::Picture picture = flat(0.f);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t k = 0; k < of; ++k) picture.pixels[i] += glm::vec3(values[of * i + k + shift] / static_cast<float>(of));
    return picture;
}
double mean_share(metrics::Picture const& before, metrics::Picture const& now, Motions const& motion) {
    RepeatedDetail const rule;
    auto const earlier = finest_detail(rule, before), later = finest_detail(rule, now);
    double sum = 0.;
    for (float const share : repeated_share(rule, later, flat(1.f), motion.view(), earlier)) sum += static_cast<double>(share);
    return sum / static_cast<double>(pixels);
}

} // namespace

TEST_CASE("detail of guides that comes again is texture, and what does not is noise") {
    SUBCASE("at rest") { CHECK(mean_share(texture(1), texture(1), motion_of(0.f)) > .999); }
    SUBCASE("where it has moved to, between pixels too") {
        auto const now = texture(1), half_before = texture(2, 2, 0), half_now = texture(2, 2, 1);
        auto moved = now;
        for (std::size_t i = 0; i + 1 < pixels; ++i) moved.pixels[i + 1] = now.pixels[i];
        CHECK(mean_share(now, moved, motion_of(-1.f)) > .97);
        CHECK(mean_share(half_before, half_now, motion_of(.5f)) > .6);
    }
    SUBCASE("noise that is new in each frame") { CHECK(mean_share(texture(1), texture(2), motion_of(0.f)) < .1); }
    SUBCASE("half of each") {
        auto before = texture(1), now = before;
        auto const noise_before = texture(2), noise_now = texture(3);
        for (std::size_t i = 0; i < pixels; ++i) before.pixels[i] += noise_before.pixels[i], now.pixels[i] += noise_now.pixels[i];
        CHECK(mean_share(before, now, motion_of(0.f)) == doctest::Approx(.5).epsilon(.1));
    }
}

TEST_CASE("nothing is noise where nothing is known of the frame before") {
    RepeatedDetail const rule;
    auto const detail = finest_detail(rule, texture(1));
    for (float const share : repeated_share(rule, detail, flat(1.f), motion_of(0.f).view(), {})) CHECK(share == 1.f);
    auto const unknown = motion_of(std::numeric_limits<float>::quiet_NaN());
    for (float const share : repeated_share(rule, detail, flat(1.f), unknown.view(), detail)) CHECK(share == 1.f);
}

TEST_CASE("detail of a picture counts as that of guides as far as both are correlated") {
    RepeatedDetail const rule;
    auto const mean_of = [&](metrics::Picture const& detail, metrics::Picture const& guides) {
        double sum = 0.;
        for (float const share : share_of_guides(rule, detail, guides, flat(1.f))) sum += static_cast<double>(share);
        return sum / static_cast<double>(pixels);
    };
    auto const guides = finest_detail(rule, texture(1)), other = finest_detail(rule, texture(2));
    CHECK(mean_of(guides, guides) > .999);
    CHECK(mean_of(other, guides) < .25);
    CHECK(mean_of(flat(0.f), guides) == 0.);
    CHECK(mean_of(guides, flat(0.f)) == 0.);
    SUBCASE("the mean of nine frames' guides is theirs") {
        auto mean = texture(1);
        for (unsigned seed = 2; seed <= 9; ++seed)
            for (std::size_t i = 0; auto const& pixel : texture(seed).pixels) mean.pixels[i++] += pixel;
        CHECK(mean_of(finest_detail(rule, mean), guides) > .95);
    }
    SUBCASE("the opposite of what guides add is not theirs") {
        auto opposite = guides;
        for (auto& pixel : opposite.pixels) pixel = -pixel;
        CHECK(mean_of(opposite, guides) == 0.);
    }
}

TEST_CASE("detail is limited by the light of its picture") {
    RepeatedDetail const rule;
    auto detail = flat(0.f);
    detail.pixels[5] = glm::vec3(1e30f, -1e30f, std::numeric_limits<float>::quiet_NaN());
    limit_detail(rule, flat(1.f), detail);
    CHECK(detail.pixels[5].x == doctest::Approx(rule.most * 1.02f));
    CHECK(detail.pixels[5].y == -detail.pixels[5].x);
    CHECK(detail.pixels[5].z == 0.f);
}

TEST_CASE("detail of a colour is what it adds to the picture, finite, and no light") {
    RepeatedDetail const rule;
    auto const colour = texture(1);
    auto signal = colour;
    for (auto& pixel : signal.pixels) pixel *= 3.f; // light of 3
    auto const detail = detail_of_colour(rule, colour, signal), own = finest_detail(rule, colour);
    double sum = 0.;
    for (std::size_t i = 0; i < pixels; ++i) {
        CHECK(detail.pixels[i].x == doctest::Approx(3.f * own.pixels[i].x).epsilon(1e-4));
        sum += static_cast<double>(detail.pixels[i].y);
    }
    CHECK(std::abs(sum) < 1e-3 * static_cast<double>(pixels));
    for (auto const& pixel : finest_detail(rule, flat(2.f)).pixels) CHECK(pixel.x == doctest::Approx(0.f));
    auto broken = colour;
    broken.pixels[100] = glm::vec3(std::numeric_limits<float>::infinity()), signal.pixels[101].y = std::numeric_limits<float>::quiet_NaN();
    for (auto const& pixel : detail_of_colour(rule, broken, signal).pixels) CHECK(std::isfinite(pixel.x + pixel.y + pixel.z));
}
