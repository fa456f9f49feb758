#include <doctest/doctest.h>
#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/evidence.hpp>

#include <limits>
#include <random>

using namespace quell;

namespace {
/// The part of A over an image where the truth is 1, A and B are off by so much, samples have skewed noise of mean 1, and B has that part
/// of a pixel's own sample.
double part(float a, float b, Evidence const& rule = {}, float own = 0.f) {
    constexpr Extent size{48, 40};
    EvidenceSums sums(size);
    std::mt19937 random(7);
    std::exponential_distribution<float> noise(1.f);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size.pixels()); ++i) {
        glm::vec3 const sample{noise(random), noise(random), noise(random)}, first(1.f + a), second(1.f + b);
        sums.add(rule, i, sample, first, second, second + own * (sample - second));
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

TEST_CASE("an estimate that follows its pixels' own noise is not taken for one that does not") {
    CHECK(part(.2f, 0.f) < .2);
    CHECK(part(.2f, 0.f, {.caution = 1.f}, .5f) == doctest::Approx(.25 / (.25 + .04)).epsilon(.1)); // error .04 of A, .25 of B
    CHECK(part(.2f, 0.f, {}, .5f) > .85);
}

TEST_CASE("of many samples, there is no caution") {
    CHECK(Evidence::of_samples(1.f).caution == Evidence{}.caution);
    CHECK(Evidence::of_samples(0.f).caution == Evidence{}.caution);
    CHECK(Evidence::of_samples(16.f).caution == 0.f);
    CHECK(Evidence::of_samples(1024.f).caution == 0.f); // files may say more than is true
    double const blind = part(.2f, -.2f, {.caution = 0.f}, .3f);
    CHECK(blind == doctest::Approx(.5).epsilon(.2));
    CHECK(part(.2f, -.2f, {}, .3f) > blind);
    // What samples do not change is judged as ever.
    CHECK(part(0.f, .5f, Evidence::of_samples(16.f)) == doctest::Approx(part(0.f, .5f)));
}

TEST_CASE("doubt takes caution away as far as samples leave nothing of the first estimate") {
    // A is off, B is right but for its own noise: caution keeps a part of A, full doubt nearly nothing of it.
    double const cautious = part(.8f, 0.f, {}, .15f), doubtful = part(.8f, 0.f, {.doubt = 1.f}, .15f);
    double const blind = part(.8f, 0.f, {.caution = 0.f}, .15f);
    CHECK(cautious > .05);
    CHECK(blind < .02);
    CHECK(doubtful < blind + .3 * (cautious - blind));
    CHECK(part(.8f, 0.f, {.doubt = .5f}, .15f) == doctest::Approx(.5 * (cautious + blind)).epsilon(.2));
    // Where samples speak for A, the part stays what caution makes of it.
    CHECK(part(0.f, .5f, {.doubt = 1.f}, .3f) == doctest::Approx(part(0.f, .5f, {}, .3f)).epsilon(.02));
    CHECK(part(.2f, 0.f, {.caution = 0.f, .doubt = 1.f}, .5f) == part(.2f, 0.f, {.caution = 0.f}, .5f));
}

TEST_CASE("a history that has seen later frames is trusted less, the more samples there are") {
    for (float const few : {0.f, 1.f}) {
        CHECK(Evidence::with_later_frames(few).doubt == 0.f);
        CHECK(Evidence::with_later_frames(few).caution == Evidence{}.caution);
    }
    CHECK(Evidence::with_later_frames(4.f).doubt == doctest::Approx(.5));
    for (float const many : {16.f, 64.f, 1024.f}) CHECK(Evidence::with_later_frames(many).doubt == 1.f);
    CHECK(Evidence::with_later_frames(16.f).caution == doctest::Approx(2.));
    CHECK(Evidence::with_later_frames(32.f).caution == doctest::Approx(2.));
    CHECK(Evidence::with_later_frames(64.f).caution == doctest::Approx(.75));
    CHECK(Evidence::with_later_frames(1024.f).caution == 0.f);
}

TEST_CASE("little evidence changes little") {
    CHECK(part(.05f, 0.f, {.radius = 1, .spread = .1f}) > .9);
    CHECK(part(.05f, 0.f, {.radius = 1, .spread = 1e4f}) < .7);
}

TEST_CASE("where both agree nothing is changed") {
    CHECK(part(.2f, .2f) == doctest::Approx(1.));
    CHECK(part(.2f, .2f, {.at_first = .25f}) == doctest::Approx(.25));
}

TEST_CASE("a sample that is not finite says nothing") {
    EvidenceSums sums({3, 3});
    glm::vec3 const none{std::numeric_limits<float>::quiet_NaN(), 1.f, std::numeric_limits<float>::infinity()}, a(2.f), b(1.f);
    sums.add({}, 4, none, a, b, b);
    for (float const p : sums.parts({.radius = 1})) CHECK((p >= 0.f && p <= 1.f));
}

TEST_CASE("what is no light is no evidence") {
    glm::vec3 const a(2.f), b(1.f);
    for (float const value : {std::numeric_limits<float>::infinity(), 1e17f, -1.f}) {
        CAPTURE(value);
        EvidenceSums sums({3, 3});
        for (std::size_t i = 0; i < 9; ++i) sums.add({}, i, glm::vec3(value), a, b, b);
        for (float const p : sums.parts({.at_first = .25f})) CHECK(p == doctest::Approx(.25));
    }
}

TEST_CASE("parts by evidence: each half is judged by estimates that were made without it") {
    constexpr Extent size{40, 31};
    auto const pixels = static_cast<std::size_t>(size.pixels());
    std::mt19937 random(3);
    std::exponential_distribution<float> noise(1.f);
    std::vector<glm::vec3> samples(pixels);
    for (auto& sample : samples) sample = glm::vec3(noise(random), noise(random), noise(random));
    // Both estimates give a pixel its own sample back, unless that was left out. The truth is 1.
    auto const made = [&](float otherwise, int left_out) {
        ImageOf<Planar<>, Radiance> given(size);
        for (int y = 0, i = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x, ++i) given.set(x, y, samples[static_cast<std::size_t>(i)]);
        leave_out(given.view(), left_out);
        std::vector<glm::vec3> result;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                bool const is_left_out = !is_finite(given.view().get(0, x, y));
                CHECK(is_left_out == ((x + y) % 2 == left_out));
                result.push_back(is_left_out ? glm::vec3(otherwise) : samples[result.size()]);
            }
        return result;
    };
    auto const mean_part = [&](float a, float b) {
        auto const parts = parts_by_evidence(
            {}, size, samples, std::vector(pixels, glm::vec3(b)), [&](int out) { return made(a, out); },
            [&](int out) { return made(b, out); });
        double sum = 0;
        for (float const part : parts) sum += static_cast<double>(part);
        return sum / static_cast<double>(pixels);
    };
    CHECK(mean_part(1.f, 1.5f) > .9);
    CHECK(mean_part(1.5f, 1.f) < .1);
}

TEST_CASE("parts by evidence: the unit of light changes no bit") {
    constexpr Extent size{20, 15};
    auto const parts = [size](float unit) {
        std::mt19937 random(3);
        std::exponential_distribution<float> noise(1.f);
        auto const picture = [&](float light) {
            std::vector<glm::vec3> made;
            for (int i = 0; i < size.pixels(); ++i) // half of it is dark
                made.push_back(glm::vec3(noise(random), noise(random), noise(random)) * (i % 2 == 0 ? light : .001f * light) * unit);
            return made;
        };
        auto const samples = picture(1.f), b = picture(1.2f);
        return parts_by_evidence(
            {.radius = 2}, size, samples, b, [&](int) { return picture(.9f); }, [&](int) { return picture(1.2f); });
    };
    CHECK(parts(0x1p-12f) == parts(1.f));
    CHECK(parts(0x1p12f) == parts(1.f));
}

TEST_CASE("parts by evidence: an image of another size is named") {
    constexpr Extent size{4, 3};
    using Pixels = std::vector<glm::vec3>;
    auto const message = [size](std::size_t samples, std::size_t b, std::size_t a_without, std::size_t b_without) -> std::string {
        try {
            static_cast<void>(parts_by_evidence(
                {}, size, Pixels(samples), Pixels(b), [&](int) { return Pixels(a_without); }, [&](int) { return Pixels(b_without); }));
        } catch (Error const& error) {
            return error.what();
        }
        return {};
    };
    CHECK(message(12, 12, 12, 12).empty());
    CHECK(message(11, 12, 12, 12).find("the samples: 11 pixels for an image of 4x3") != std::string::npos);
    CHECK(message(12, 13, 12, 12).find("the second estimate: 13") != std::string::npos);
    CHECK(message(12, 12, 0, 12).find("the first estimate without samples: 0") != std::string::npos);
    CHECK(message(12, 12, 12, 1).find("the second estimate without samples: 1") != std::string::npos);
}
