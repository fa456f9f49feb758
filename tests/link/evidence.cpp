#include "../frames.hpp"

#include <quell/link/evidence/choose_by_evidence.hpp>
#include <quell/link/evidence/held_out.hpp>

#include <glm/glm.hpp>

#include <limits>
#include <random>

using namespace quell;

namespace {

/// A pipeline that chooses, with a frame of its estimates.
template <ChannelTag Samples> struct Choosing {
    static constexpr int n = Samples::components;
    static constexpr auto choose_by(Evidence const& rule, SharedNoise const& noise = {.least = 2.f, .most = 3.f}) {
        return Pipeline{FirstEstimate<n>{}, Spatial{ChooseByEvidence<Samples>{rule, noise}}};
    }
    using Choice = decltype(choose_by({}));
    Frame<typename Choice::reads> frame;

    explicit Choosing(Extent size) : frame(size) {}
    template <ChannelTag C> void fill(C channel, auto&& value) {
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x)
                for (int c = 0; c < n; ++c) frame[channel].view().set(c, x, y, value(c, x, y));
    }
    void fill_without(auto even, auto odd, auto const& value) { fill(even, value), fill(odd, value); }
    [[nodiscard]] std::vector<float> run(Evidence const& rule, auto const&... noise) const {
        auto const choose = choose_by(rule, noise...);
        History history{frame.size, choose};
        return tests::copy_of(quell::run(choose, frame, history));
    }
};
template <class Random> auto numbers(Random distribution, unsigned seed, float times = 1.f) {
    return [distribution, random = std::mt19937(seed), times](int, int, int) mutable { return times * distribution(random); };
}
using Skewed = std::exponential_distribution<float>;

/// The part of A over an image where the truth is 1, A and B are off by so much, samples have skewed noise of mean 1, and B has that part
/// of a pixel's own sample.
template <ChannelTag Samples = Radiance> double part(float a, float b, Evidence const& rule = {}, float own = 0.f) {
    constexpr int n = Samples::components;
    Choosing<Samples> given(Extent{48, 40});
    auto noise = numbers(Skewed(1.f), 7);
    given.fill(Samples{}, noise);
    auto const constant = [](float value) { return [value](int, int, int) { return value; }; };
    given.fill(FirstEstimate<n>{}, constant(1.f + a)), given.fill_without(FirstWithoutEven<n>{}, FirstWithoutOdd<n>{}, constant(1.f + a));
    given.fill(SecondEstimate<n>{}, constant(1.f + b)),
        given.fill_without(SecondWithoutEven<n>{}, SecondWithoutOdd<n>{}, constant(1.f + b));
    given.fill(SecondJudged<n>{}, [&](int c, int x, int y) { return 1.f + b + own * (given.frame[Samples{}].get(c, x, y) - 1.f - b); });
    double sum = 0;
    auto const picture = given.run(rule);
    for (std::size_t i = 0; i < picture.size(); i += std::size_t{n}) sum += static_cast<double>((picture[i] - 1.f - b) / (a - b));
    return sum * n / static_cast<double>(picture.size());
}
} // namespace

TEST_CASE("evidence: samples choose what is true, of one component, of three, and with alpha") {
    CHECK(part(0.f, .5f) > .9);
    CHECK(part(.5f, 0.f) < .1);
    CHECK(part<Visibility>(0.f, .5f) > .9);
    CHECK(part<Visibility>(.5f, 0.f) < .1);
    CHECK(part<RadianceAlpha>(.5f, 0.f) < .1);
    CHECK(part(.3f, -.3f) == doctest::Approx(.5).epsilon(.2));
    CHECK(part(-.6f, .2f) == doctest::Approx(.25).epsilon(.3));
}

TEST_CASE("evidence: an estimate that follows its pixels' own noise is not taken for one that does not") {
    CHECK(part(.2f, 0.f) < .2);
    CHECK(part(.2f, 0.f, {.caution = 1.f}, .5f) == doctest::Approx(.25 / (.25 + .04)).epsilon(.1)); // error .04 of A, .25 of B
    CHECK(part(.2f, 0.f, {}, .5f) > .85);
    double const blind = part(.2f, -.2f, {.caution = 0.f}, .3f);
    CHECK(blind == doctest::Approx(.5).epsilon(.2));
    CHECK(part(.2f, -.2f, {}, .3f) > blind);
    // What samples do not change is judged as ever.
    CHECK(part(0.f, .5f, Evidence::of_samples(16.f)) == doctest::Approx(part(0.f, .5f, {.both_halves = false})));
}

TEST_CASE("evidence: of many samples there is no caution, and a history that has seen later frames is trusted less, the more there are") {
    for (float const few : {0.f, 1.f}) {
        CHECK(Evidence::of_samples(few).caution == Evidence{}.caution);
        CHECK(Evidence::with_later_frames(few).doubt == 0.f);
        CHECK(Evidence::with_later_frames(few).caution == Evidence{}.caution);
    }
    for (float const many : {16.f, 1024.f})
        CHECK(Evidence::of_samples(many).caution == doctest::Approx(0.));       // files may say more than is true
    for (auto const rule : {Evidence::of_samples, Evidence::with_later_frames}) // one half says enough, of more samples than one
        for (float const samples : {1.f, 2.f, 64.f}) CHECK(rule(samples).both_halves == (samples == 1.f));
    CHECK(Evidence::with_later_frames(4.f).doubt == doctest::Approx(.5));
    for (float const many : {16.f, 64.f, 1024.f}) CHECK(Evidence::with_later_frames(many).doubt == doctest::Approx(1.));
    CHECK(Evidence::with_later_frames(16.f).caution == doctest::Approx(2.));
    CHECK(Evidence::with_later_frames(32.f).caution == doctest::Approx(2.));
    CHECK(Evidence::with_later_frames(64.f).caution == doctest::Approx(.75));
    CHECK(Evidence::with_later_frames(1024.f).caution == 0.f);
}

TEST_CASE("evidence: what is no light says nothing, and neither do samples of a half that is not held out") {
    for (float const value : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e17f, -1.f}) {
        CAPTURE(value);
        for (int const halves : {1, 2}) {
            Choosing<Radiance> given(Extent{9, 7});
            auto const constant = [](float of) { return [of](int, int, int) { return of; }; };
            given.fill(radiance, [&](int, int x, int y) { return halves == 1 && (x + y) % 2 == 1 ? 5.f : value; });
            given.fill(FirstEstimate<3>{}, constant(2.f)), given.fill_without(FirstWithoutEven<3>{}, FirstWithoutOdd<3>{}, constant(2.f));
            given.fill(SecondEstimate<3>{}, constant(1.f)),
                given.fill_without(SecondWithoutEven<3>{}, SecondWithoutOdd<3>{}, constant(1.f));
            given.fill(SecondJudged<3>{}, constant(1.f));
            for (float const each : given.run({.at_first = .25f, .both_halves = halves == 2})) CHECK(each == doctest::Approx(1.25));
        }
    }
}

TEST_CASE("evidence: samples held out become missing ones, every second pixel of each row") {
    constexpr Extent size{21, 5};
    ImageOf<Planar<>, Radiance> from(size), to(size);
    tests::fill(from, [](int x, int y) { return glm::vec3(1.f, static_cast<float>(x), static_cast<float>(y)); });
    for (int const half : {0, 1, detail::none_held_out}) {
        Simd{}.for_each_pixel({0, 0, size.width, size.height},
                              detail::HoldOut<decltype(from.view()), decltype(to.view())>{from.view(), to.view(), half});
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                CHECK((is_finite(to.get(1, x, y)) ? to.get(1, x, y) == static_cast<float>(x) : half == (x + y) % 2));
    }
}

TEST_CASE("evidence: the part of the first estimate is that of least squares over a pixel's window, as far as its variance lets trust it") {
    constexpr Extent size{45, 37};
    Choosing<RadianceAlpha> given(size);
    auto const uniform = [](unsigned seed, float most) { return numbers(std::uniform_real_distribution<float>(.2f, 2.f), seed, most); };
    given.fill(radiance_alpha, uniform(1, 2.f)), given.fill(FirstEstimate<4>{}, uniform(2, 1.2f)),
        given.fill(SecondEstimate<4>{}, uniform(3, 1.f));
    given.fill(FirstWithoutEven<4>{}, uniform(4, 1.2f)), given.fill(SecondWithoutEven<4>{}, uniform(5, 1.f)),
        given.fill(FirstWithoutOdd<4>{}, uniform(7, 1.2f)), given.fill(SecondWithoutOdd<4>{}, uniform(8, 1.f)),
        given.fill(SecondJudged<4>{}, uniform(6, 1.f));
    auto const colour = [&](auto channel, int x, int y) {
        auto const view = given.frame[channel].view();
        return glm::dvec3(view.get(0, x, y), view.get(1, x, y), view.get(2, x, y));
    };
    glm::dvec3 const luminance_of(.2126, .7152, .0722);
    double mean = 0.;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            mean += glm::dot(colour(FirstEstimate<4>{}, x, y), luminance_of) / static_cast<double>(size.pixels());
    for (Evidence const rule :
         {Evidence{.dark = .1f, .most = 2.f, .caution = .3f, .at_first = .8f, .spread = .02f},
          Evidence{.caution = .5f, .spread = .03f, .doubt = .6f}, Evidence{.spread = .05f, .both_halves = false}, Evidence{}}) {
        auto const mixed = given.run(rule);
        for (int y = 0; y < size.height; y += 3)
            for (int x = 0; x < size.width; x += 2) {
                constexpr int radius = 12;
                double product = 0., square = 0., noise = 0., own = 0.;
                for (int j = std::max(y - radius, 0); j <= std::min(y + radius, size.height - 1); ++j)
                    for (int i = std::max(x - radius, 0); i <= std::min(x + radius, size.width - 1); ++i) {
                        bool const is_odd = (i + j) % 2 != 0;
                        if (is_odd && !rule.both_halves) continue;
                        auto const first = is_odd ? colour(FirstWithoutOdd<4>{}, i, j) : colour(FirstWithoutEven<4>{}, i, j);
                        auto const second = is_odd ? colour(SecondWithoutOdd<4>{}, i, j) : colour(SecondWithoutEven<4>{}, i, j);
                        auto const off = first - second;
                        double const bright = static_cast<double>(rule.dark) * mean + .5 * glm::dot(first + second, luminance_of);
                        auto const sample = glm::min(colour(radiance_alpha, i, j), glm::dvec3(static_cast<double>(rule.most) * bright));
                        auto const change = colour(SecondJudged<4>{}, i, j) - second;
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
                double const wanted = part(1. - static_cast<double>(rule.doubt) * (1. - part(0.)));
                auto const at = [&](auto channel, int c) { return static_cast<double>(given.frame[channel].view().get(c, x, y)); };
                auto const made = [&](int c) { return mixed[static_cast<std::size_t>(4 * (y * size.width + x) + c)]; };
                double const first = at(FirstEstimate<4>{}, 1), second = at(SecondEstimate<4>{}, 1);
                CHECK(made(1) == doctest::Approx(second + (first - second) * wanted).epsilon(1e-4));
                CHECK(static_cast<double>(made(3)) == at(FirstEstimate<4>{}, 3));
            }
    }
}

TEST_CASE("evidence: the unit of light changes no bit, and of samples that share their noise the first estimate stays") {
    Choosing<Radiance> given(Extent{40, 31});
    auto const fill = [&](float unit) {
        given.fill(radiance, numbers(Skewed(1.f), 3, unit));
        auto const constant = [&](float value) { return [=](int, int x, int) { return value * unit * (x % 2 == 0 ? 1.f : .01f); }; };
        given.fill(FirstEstimate<3>{}, constant(2.f)), given.fill_without(FirstWithoutEven<3>{}, FirstWithoutOdd<3>{}, constant(2.f));
        given.fill(SecondEstimate<3>{}, constant(1.f)), given.fill_without(SecondWithoutEven<3>{}, SecondWithoutOdd<3>{}, constant(1.f)),
            given.fill(SecondJudged<3>{}, constant(1.1f));
    };
    fill(1.f);
    auto const wanted = given.run({});
    for (float const unit : {0x1p-12f, 0x1p12f}) {
        fill(unit);
        auto picture = given.run({});
        for (float& each : picture) each *= 1.f / unit;
        CHECK(picture == wanted);
    }
    // A blur of rows and columns.
    fill(1.f);
    auto const samples = tests::copy_of(given.frame[radiance].view());
    auto const sample = [&](int c, int x, int y) {
        return samples[static_cast<std::size_t>(3 * (std::clamp(y, 0, 30) * 40 + std::clamp(x, 0, 39)) + c)];
    };
    given.fill(radiance, [&](int c, int x, int y) {
        return .25f * (sample(c, x, y) + sample(c, x + 1, y) + sample(c, x, y + 1) + sample(c, x + 1, y + 1));
    });
    CHECK(given.run({}, SharedNoise{}) == tests::copy_of(given.frame[FirstEstimate<3>{}].view()));
}
