#include <doctest/doctest.h>
#include <quell/execute/executor.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/evidence_passes.hpp>

#include <glm/glm.hpp>

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

TEST_CASE("what is no light is no evidence") {
    glm::vec3 const a(2.f), b(1.f);
    for (float const value : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e17f, -1.f}) {
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

TEST_CASE("the part of the first estimate is that of least squares over a pixel's window, as far as its variance lets trust it") {
    constexpr Extent size{45, 29};
    using Image = ImageOf<Planar<>, RadianceAlpha>;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(.2f, 2.f);
    auto const image = [&](float most) {
        Image made(size);
        for (int i = 0; i < 4 * size.pixels(); ++i) made.view().set(i % 4, i / 4 % size.width, i / 4 / size.width, most * number(random));
        return made;
    };
    auto const samples = image(2.f), a = image(1.2f), b = image(1.f), b_with = image(1.f);
    auto const colour = [](Image const& of, int x, int y) {
        return glm::vec3(of.view().get(0, x, y), of.view().get(1, x, y), of.view().get(2, x, y));
    };
    glm::dvec3 const luminance_of(.2126, .7152, .0722);
    double mean = 0.;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            mean += glm::dot(glm::dvec3(colour(b_with, x, y)), luminance_of) / static_cast<double>(size.pixels());
    EvidenceMix<> mix;
    for (Evidence const rule : {Evidence{.radius = 2, .dark = .1f, .most = 2.f, .caution = .3f, .at_first = .8f, .spread = .2f},
                                Evidence{.radius = 3, .caution = .5f, .spread = .3f, .trust = .9f, .doubt = .6f}, Evidence{}}) {
        EvidenceSums sums(size, static_cast<float>(mean));
        for (std::size_t i = 0; i < static_cast<std::size_t>(size.pixels()); ++i) {
            int const x = static_cast<int>(i) % size.width, y = static_cast<int>(i) / size.width;
            sums.add(rule, i, colour(samples, x, y), colour(a, x, y), colour(b, x, y), colour(b_with, x, y));
        }
        auto const parts = sums.parts(rule);
        for (int const left_out : {1, 0}) mix.judge(rule, Simd{}, left_out, samples.view(), a.view(), b.view(), b_with.view());
        Image mixed(size), small(Extent{45, 28});
        mix.mix(rule, Simd{}, a.view(), b.view(), mixed.view());
        CHECK_THROWS_WITH_AS(mix.mix(rule, Simd{}, a.view(), small.view(), mixed.view()),
                             doctest::Contains("the second estimate: 45x28 beside samples of 45x29"), Error);
        if (!(rule.doubt > 0.f))
            CHECK_THROWS_WITH_AS(mix.mix({.doubt = .5f}, Simd{}, a.view(), b.view(), mixed.view()), doctest::Contains("it has doubt"),
                                 Error);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double product = 0., square = 0., noise = 0., own = 0.;
                for (int j = std::max(y - rule.radius, 0); j <= std::min(y + rule.radius, size.height - 1); ++j)
                    for (int i = std::max(x - rule.radius, 0); i <= std::min(x + rule.radius, size.width - 1); ++i) {
                        glm::dvec3 const first(colour(a, i, j)), second(colour(b, i, j)), off = first - second;
                        double const bright = static_cast<double>(rule.dark) * mean + .5 * glm::dot(first + second, luminance_of);
                        auto const sample =
                            glm::min(glm::dvec3(colour(samples, i, j)), glm::dvec3(static_cast<double>(rule.most) * bright));
                        auto const change = glm::dvec3(colour(b_with, i, j)) - second;
                        double const per = 1. / (bright * bright);
                        product += per * glm::dot(sample - second, off), square += per * glm::dot(off, off);
                        noise += std::pow(per * glm::dot(sample - .5 * (first + second), off), 2.);
                        own += static_cast<double>(rule.caution) * per * glm::dot(change, change);
                    }
                auto const part = [&](double caution) {
                    double const all = square + caution * own, w = (product + caution * own) / all, variance = noise / (all * all);
                    double const before = 1. / std::pow(static_cast<double>(rule.spread), 2.);
                    return std::clamp((w / variance + static_cast<double>(rule.at_first) * before) / (1. / variance + before), 0., 1.);
                };
                double const caution = 1. - static_cast<double>(rule.doubt) * (1. - part(0.));
                double const wanted = 1. - static_cast<double>(rule.trust) * (1. - part(caution));
                CHECK(parts[static_cast<std::size_t>(y * size.width + x)] == doctest::Approx(wanted).epsilon(1e-4));
                double const first = static_cast<double>(a.view().get(1, x, y)), second = static_cast<double>(b.view().get(1, x, y));
                CHECK(mixed.view().get(1, x, y) == doctest::Approx(second + (first - second) * wanted).epsilon(1e-4));
                CHECK(mixed.view().get(3, x, y) == a.view().get(3, x, y));
            }
    }
}
