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
LinearPicture flat(float value) { return LinearPicture(size, value); }
/// Grey values about 1 that know nothing of each other; each pixel is the mean of `of` of them. Half a pixel farther at `shift` 1.
LinearPicture texture(unsigned seed, std::size_t of = 1, std::size_t shift = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> some(.5f, 1.5f);
    std::vector<float> values(of * pixels + 1);
    for (auto& value : values) value = some(random);
    LinearPicture picture = flat(0.f);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t k = 0; k < of; ++k) picture[i] += glm::vec3(values[of * i + k + shift] / static_cast<float>(of));
    return picture;
}
double mean_share(LinearView const& before, LinearView const& now, Motions const& motion) {
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
        for (std::size_t i = 0; i + 1 < pixels; ++i) moved[i + 1] = now[i];
        CHECK(mean_share(now, moved, motion_of(-1.f)) > .97);
        CHECK(mean_share(half_before, half_now, motion_of(.5f)) > .6);
    }
    SUBCASE("noise that is new in each frame") { CHECK(mean_share(texture(1), texture(2), motion_of(0.f)) < .1); }
    SUBCASE("half of each") {
        auto before = texture(1), now = before;
        auto const noise_before = texture(2), noise_now = texture(3);
        for (std::size_t i = 0; i < pixels; ++i) before[i] += noise_before[i], now[i] += noise_now[i];
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
    auto const mean_of = [&](LinearView const& detail, LinearView const& guides) {
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
            for (std::size_t i = 0; float const value : texture(seed).values) mean.values[i++] += value;
        CHECK(mean_of(finest_detail(rule, mean), guides) > .95);
    }
    SUBCASE("the opposite of what guides add is not theirs") {
        auto opposite = guides;
        for (auto& value : opposite.values) value = -value;
        CHECK(mean_of(opposite, guides) == 0.);
    }
}

TEST_CASE("detail is limited by the light of its picture") {
    RepeatedDetail const rule;
    auto detail = flat(0.f);
    detail[5] = glm::vec3(1e30f, -1e30f, std::numeric_limits<float>::quiet_NaN());
    limit_detail(rule, flat(1.f), detail);
    CHECK(detail.at(0, 5) == doctest::Approx(rule.most * 1.02f));
    CHECK(detail.at(1, 5) == -detail.at(0, 5));
    CHECK(detail.at(2, 5) == 0.f);
}

TEST_CASE("detail of a colour is what it adds to the picture, finite, and no light") {
    RepeatedDetail const rule;
    auto const colour = texture(1);
    auto signal = colour;
    for (auto& value : signal.values) value *= 3.f; // light of 3
    auto const detail = detail_of_colour(rule, colour, signal), own = finest_detail(rule, colour);
    double sum = 0.;
    for (std::size_t i = 0; i < pixels; ++i) {
        CHECK(detail.at(0, i) == doctest::Approx(3.f * own.at(0, i)).epsilon(1e-4));
        sum += static_cast<double>(detail.at(1, i));
    }
    CHECK(std::abs(sum) < 1e-3 * static_cast<double>(pixels));
    for (float const value : finest_detail(rule, flat(2.f)).values) CHECK(value == doctest::Approx(0.f));
    auto broken = colour;
    broken[100] = glm::vec3(std::numeric_limits<float>::infinity()), signal.at(1, 101) = std::numeric_limits<float>::quiet_NaN();
    for (float const value : detail_of_colour(rule, broken, signal).values) CHECK(std::isfinite(value));
}
