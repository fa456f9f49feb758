#include "flat_surface.hpp"

using namespace quell;
using namespace quell::tests;

namespace {
constexpr auto link_of(ResidualFeedback<> const& rule) { return Pipeline{denoised, Spatial{rule}}; }
Pixels fed(ResidualFeedback<> rule, Pixels const& samples) {
    rule.of_neighbours = {.least = 2.f, .most = 3.f}; // what waves lack they lack nearly everywhere, and there is next to no noise beside
    return FlatSurface(link_of(rule)).run(samples);
}
Pixels fed(float count, Pixels const& samples) { return fed(ResidualFeedback<>{.samples = count}, samples); }

double mean_of(Pixels const& picture) {
    double sum = 0.;
    for (float const each : picture) sum += static_cast<double>(each);
    return sum / static_cast<double>(picture.size());
}
/// Waves of 8 pixels that the picture lacks, in the left half.
Pixels waves() {
    return grey([](int x, int) { return x < flat_size.width / 2 ? 1.f + .3f * std::sin(static_cast<float>(x) * .785398f) : 1.f; });
}
double error_of(Pixels const& picture) { return root_mean_square(picture, waves()); }
} // namespace

TEST_CASE("residual feedback: a picture that is as its samples stays, and what a filter took out comes back") {
    for (auto const& [count, most] : {std::pair{1.f, .95}, std::pair{4.f, .75}, std::pair{16.f, .55}}) {
        CHECK(fed(count, flat) == flat);
        CHECK(error_of(fed(count, with_noise(waves(), .1f, 5))) < most * error_of(flat));
    }
}

TEST_CASE("residual feedback: light that the picture lacks everywhere comes back in part, and next to nothing of noise") {
    for (float const count : {1.f, 4.f, 16.f, 64.f}) {
        CAPTURE(count);
        for (float const noise : {0.f, .001f, .01f, .1f, .5f}) {
            double const mean = mean_of(fed(count, with_noise(scaled(flat, 1.1f), noise, 5)));
            CHECK((mean > 1.01 && mean < 1.11));
        }
        double error = 0., mean = 0.;
        for (unsigned seed = 1; seed <= 8; ++seed) {
            auto const made = fed(count, with_noise(flat, .3f, seed));
            error += root_mean_square(made, flat) / 8., mean += mean_of(made) / 8.;
        }
        CHECK(error < .2 * .3);
        CHECK(std::abs(mean - 1.) < .003);
    }
    auto const samples = with_noise(waves(), .3f, 5);
    CHECK(FlatSurface(link_of({.samples = 16.f})).run(samples) != flat);
    CHECK(FlatSurface(link_of({.samples = 16.f})).run(shared(samples)) == flat);
}

TEST_CASE("residual feedback: what is bad spreads nothing, and light leaves a part of the picture's") {
    FlatSurface seen(link_of({.samples = 16.f}));
    auto samples = with_noise(waves(), .1f, 5);
    fill(seen.frame[normal], [](int, int y) { return glm::vec3(0.f, 0.f, y < 40 ? 0.f : 1.f); });
    fill(seen.frame[depth], [](int, int y) { return y < 40 ? endless : 3.f; });
    seen.frame[denoised].set(28, 7, glm::vec3(endless));
    for (std::size_t i = 0; i < samples.size(); i += 9) samples[i + 1] = i % 2 == 0 ? none : endless;
    auto const made = seen.run(samples);
    CHECK((all_finite(made) && error_of(made) < error_of(flat)));
    CHECK(fed(16.f, Pixels(flat.size(), endless)) == flat);
    auto const dark = fed({.shares{{.wide = 1.f}}, .darkest = .3f}, Pixels(flat.size(), 0.f));
    CHECK(*std::ranges::min_element(dark) == doctest::Approx(.3f));
}

TEST_CASE("residual feedback: shares of few samples lie between those of 1 and of 16, and others may take their place") {
    using Shares = ResidualFeedbackShares;
    auto const one = Shares::of_samples(1.f), four = Shares::of_samples(4.f), many = Shares::of_samples(16.f);
    CHECK(one.wide == feedback_of_1_sample.wide);
    CHECK(four.fine_held == doctest::Approx(.5f * (one.fine_held + many.fine_held)));
    CHECK(many.wide_noise == doctest::Approx(feedback_of_16_samples.wide_noise));
    CHECK(Shares::of_samples(256.f).fine_held == many.fine_held);
    CHECK(Shares::of_samples(0.f).wide_texture == one.wide_texture);
    CHECK(Shares::beside_history(1.f).wide == 0.f);
    CHECK(Shares::beside_history(4.f).wide == doctest::Approx(.5f * four.wide));
    CHECK(Shares::beside_history(64.f).wide_texture == many.wide_texture);
    auto const middle = [](Shares const& shares) { return fed({.shares = shares}, scaled(flat, 1.1f))[3 * (40 * 96 + 48)]; };
    CHECK(middle({}) == 1.f);
    CHECK(middle({.wide = 1.f}) == doctest::Approx(1.1f));
    CHECK(middle({.wide = .5f}) == doctest::Approx(1.05f));
    CHECK(middle({.wide = 2.f}) == doctest::Approx(1.1f)); // never more than whole
    CHECK(middle({.wide_noise = -.5f}) == doctest::Approx(1.f + .1f * -.5f * std::log2(.1f) / 3.f).epsilon(1e-3));
    CHECK(middle({.fine_held = 1.f}) == doctest::Approx(1.f)); // an even light has no band
}

TEST_CASE("residual feedback: small images stay finite and between picture and samples") {
    for (Extent const small : {Extent{1, 1}, Extent{1, 9}, Extent{17, 1}, Extent{3, 2}})
        for (float const each : FlatSurface(link_of({}), small).run(scaled(flat, 2.f))) CHECK((each >= 1.f && each <= 2.f));
}

TEST_CASE("residual feedback: of single samples nothing is fed back to a picture with history, unless samples chose it") {
    auto const changes = [](float count, bool is_judged) {
        constexpr Pipeline first{radiance, Temporal{StillMotion{}, RunningMean{.cap = 2}}, Spatial{Atrous<>{.levels = 2}}};
        FlatSurface with(Chain{first, link_of({.samples = count, .is_judged = is_judged})});
        FlatSurface without(first);
        std::vector<bool> all;
        for (unsigned i = 0; i < 3; ++i) {
            if (i == 2) with.history.forget(), without.history.forget();
            auto const samples = with_noise(waves(), .3f, i + 1);
            all.push_back(with.run(samples) != without.run(samples));
        }
        return all;
    };
    CHECK(changes(1.f, false) == std::vector{true, false, true});
    CHECK(changes(1.f, true) == std::vector{true, true, true});
    CHECK(changes(16.f, false) == std::vector{true, true, true});
}
