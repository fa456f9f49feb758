#include "alone.hpp"

using namespace quell;
using namespace quell::detail;
using namespace quell::tests;

namespace {
/// The bands of a residual, in units of the frame's brightness.
template <Around frame> std::array<Triple, 3> bands(auto const& p) {
    double const unit = frame == Around::now ? 1.5 : 1.;
    auto const finer = p.colour(Blurs<frame>{}), wider = p.colour(Blurs<frame>{}, 3);
    return {(p.colour(ResidualChannel<frame>{}) - finer) / unit, (finer - wider) / unit, wider / unit};
}
/// The mean of a band of both frames around, and of its squares, by how far they count; and how far.
struct MeanAround {
    Triple value{0.};
    double squares = 0., known = 0.;

    MeanAround(auto const& p, std::size_t band) {
        add<Around::before>(p, band), add<Around::after>(p, band);
        if (known > 0.) value /= known, squares /= known;
        known = std::min(known, 1.);
    }
    template <Around frame> void add(auto const& p, std::size_t band) {
        double const counts = p.in(Witness<frame>{});
        auto const its = bands<frame>(p)[band];
        value += counts * its, squares += counts * square(its), known += counts;
    }
};
double in_range(double from, double to, double value) { return std::clamp((value - from) / (to - from), 0., 1.); }

/// A frame around, of which the last run's pass takes what is lacking.
template <Around frame> constexpr bool is_before = frame == Around::before;
template <Around frame> using LackingOf = std::conditional_t<is_before<frame>, Lacking, LackingNext>;
template <Around frame> Triple lacking_there(auto const& p) { return (is_before<frame> ? p.before() : p).colour(LackingOf<frame>{}); }
/// Runs, before the frame that is looked at, the one before it, in which nothing is known of a past.
template <Around frame> void run_before(auto& pass, auto const& check) {
    if constexpr (is_before<frame>) {
        pass.run(check);
        pass.then = pass.frame;
        pass.fill(lacking, -1.f, 1.f);
    }
}

template <Around frame> void check_moved() {
    PassAlone<MoveResidual<frame>> pass(Extent{48, 23}, {.9f}); // of whole packs, which are loaded at once where all move alike
    using Vectors = typename MoveResidual<frame>::Vectors;
    constexpr ResidualThere<frame> there{};
    pass.fill(LightAround{}, .1f, 1.f), pass.fill(Vectors{}, -5.f, 5.f);
    for (int i = 0; i < 23; ++i) pass.at(i, i).set(Vectors{}, {none}), pass.at(30, i).set(Vectors{}, {0.f, 0.f});
    for (int x = 0; x < 48; ++x) pass.at(x, 5).set(Vectors{}, {.3f, .2f});
    pass.at(20, 11).set(lacking_next, {0.f, none});
    run_before<frame>(pass, [](auto const& p) { p.check(ResidualThere<frame>{}, Triple(0.), 0.); });
    int known = 0;
    pass.run([&](auto const& p) {
        double const column = p.x + p.in(Vectors{}), row = p.y + p.in(Vectors{}, 1);
        Triple wanted(none);
        if (column > -.5 && row > -.5 && column < 47.5 && row < 22.5) { // the sum by each pixel's tent, with the border repeated
            wanted = Triple(0.);
            for (int j = p.y - 6; j <= p.y + 6; ++j)
                for (int i = p.x - 6; i <= p.x + 6; ++i) {
                    double const tent = std::max(1. - std::abs(column - i), 0.) * std::max(1. - std::abs(row - j), 0.);
                    if (tent > 0.) wanted += tent * lacking_there<frame>(pass.at(std::clamp(i, 0, 47), std::clamp(j, 0, 22)));
                }
        }
        bool const is_known = std::isfinite(wanted.y);
        known += is_known;
        p.check(there, is_known ? limited(wanted / 1.5, .9 * p.in(LightAround{})) : Triple(0.), double(is_known));
    });
    CHECK((known > 500 && known < 1050));
}
/// Of a whole window: from hardly to quite alike along rows, and on the screen along columns.
template <Around frame> void check_witness() {
    NewWitness const rule{.alike = .5f, .same = .95f, .stays = .2f, .common = .9f, .scattered = -.2f, .in_shapes = .3f};
    PassAlone<TakeWitness<frame>, SumRows<WitnessProducts, WitnessProductsOfRows>, JudgeWitness<frame>> pass({.9f}, {2}, {rule});
    pass.fill(LightAround{}, .5f, 2.f), pass.fill(ResidualThere<frame>{}, -.6f, .6f);
    run_before<frame>(pass, [](auto const& p) {
        auto const now = p.colour(lacking) / 1.5 / p.in(LightAround{}), there = p.colour(ResidualThere<frame>{}) / p.in(LightAround{});
        p.check(WitnessProducts{}, square(now), glm::dot(now, there), square(there), 0., 0.);
    });
    auto const known = [](auto const& p) { return p.in(ResidualThere<frame>{}, 3); };
    pass.each_pixel([&](auto const& p) {
        for (int c = 0; c < 3; ++c) {
            auto const now = static_cast<float>(p.in(lacking, c)), then = static_cast<float>(p.in(LackingOf<frame>{}, c));
            auto const there = static_cast<float>(p.in(ResidualThere<frame>{}, c)) + now * .03f * static_cast<float>(p.x);
            p.set(ResidualThere<frame>{}, {there}, c), p.set(Blurs<frame>{}, {.1f * static_cast<float>(p.y % 7) * there + .1f * now}, c);
            if (!is_before<frame>) p.set(lacking_next, {then + now * .1f * static_cast<float>(p.y)}, c);
        }
        p.set(ResidualThere<frame>{}, {.5f + .01f * static_cast<float>(p.x)}, 3);
    });
    pass.at(5, 5).set(lacking_next, {none});
    int fresh = 0, details = 0;
    pass.run([&](auto const& p) {
        auto const light = [](auto const& q) { return q.in(LightAround{}); };
        auto const now = [](auto const& q) { return q.colour(lacking) / 1.5; };
        auto const there = [](auto const& q) { return q.colour(ResidualThere<frame>{}); };
        auto const blurred = [](auto const& q) { return q.colour(Blurs<frame>{}); };
        auto const on_screen = [&](auto const& q) {
            auto c = lacking_there<frame>(q);
            if (std::isnan(c.x)) c.x = 0.;
            return limited(c / 1.5, .9 * light(q));
        };
        auto const common = [&](auto const& a, auto const& b) {
            return p.sum(2, 16, [&](auto const& q) { return glm::dot(a(q), b(q)) / (light(q) * light(q)); });
        };
        auto const correlation = [&](auto const& b) { return common(now, b) / std::sqrt(common(now, now) * common(b, b)); };
        double const alike = correlation(there), stays = correlation(on_screen) - alike,
                     is_new = in_range(.95, .5, alike) * in_range(.4, .2, stays);
        double const of_white = 1. / std::pow(1. + 2. * (std::exp(-.5 / .49) + std::exp(-2. / .49) + std::exp(-4.5 / .49)), 2.),
                     smooth = (common(now, blurred) / common(now, there) - of_white) / (1. - of_white),
                     detail = std::max(in_range(-.2, .3, smooth), in_range(.9, .36, alike));
        CHECK(pass.history[Made<Witness<frame>>{}].get(0, p.x, p.y) > 0.f); // 0 would say that nothing is known
        if (alike < .02) return;                                            // then the quotient may be anything
        fresh += is_new > .1 && is_new<.9, details += detail> .1 && detail < .9;
        p.check(Witness<frame>{}, known(p) * std::max(is_new * detail, 1e-6), known(p) * is_new);
    });
    CHECK((fresh > 50 && details > 50));
}
} // namespace

TEST_CASE("stages: what a picture lacks of samples that are light is limited by the light around") {
    PassAlone<SumBrightnessOfRows, TakeLacking<Radiance>> pass({}, {2.f});
    pass.fill(radiance, -.1f, 3.f), pass.at(4, 9).set(denoised, {none});
    for (int i = 0; i < 23; ++i) pass.at(i, i).set(radiance, {1.f, none});
    pass.run([](auto const& p) {
        if (std::abs(p.x - 4) < 3 && std::abs(p.y - 9) < 3) return; // the mean of its neighbours stands in for what is missing
        double const around = p.sum(2, 2, [](auto const& q) { return luminance_of(q.colour(denoised)); }) / 1.5 / p.pixels(2) + .02;
        auto const limits = limited(p.colour(radiance) - p.colour(denoised), 2. * 1.5 * around);
        p.check(lacking, luminance_of(p.colour(radiance)) >= 0. ? limits : Triple(0.)), p.check(LightAround{}, around);
    });
    pass.at(4, 9).check(lacking, Triple(0.));
}

TEST_CASE("stages: Gaussian means are of the pixels in the image, to three deviations") {
    PassAlone<BlurResidual<Around::now>> pass({});
    pass.run([](auto const& p) {
        auto const mean = [&](int reach, double deviation) {
            auto const weight = [&](auto const& q) {
                return std::exp(-.5 * (std::pow(q.x - p.x, 2.) + std::pow(q.y - p.y, 2.)) / (deviation * deviation));
            };
            return p.sum(reach, reach, [&](auto const& q) { return weight(q) * q.colour(lacking); }) / p.sum(reach, reach, weight);
        };
        p.check(Blurs<Around::now>{}, mean(3, .7), mean(6, 2.));
    });
}

TEST_CASE("stages: a residual of a frame around is taken to where its surfaces are now, between pixels") {
    check_moved<Around::before>();
    check_moved<Around::after>();
}

TEST_CASE("stages: a witness counts by correlations of residuals over a window") {
    check_witness<Around::before>();
    check_witness<Around::after>();
}

TEST_CASE("stages: what is repeated comes back by the least expected error") {
    constexpr int radius[] = {3, 5, 16};
    constexpr double caution[] = {.7, 1., .3}, parts[] = {.75, 1., 1.}; // three quarters of the finest band, as of 4 samples
    PassAlone<TakeRepeated<true>, SumRows<RepeatedProducts<0>, RepeatedProductsOfRows<0>>,
              SumRows<RepeatedProducts<1>, RepeatedProductsOfRows<1>>, SumRows<RepeatedProducts<2>, RepeatedProductsOfRows<2>>,
              AddRepeated<true, true>>
        pass({}, {3}, {5}, {16}, {4.f, {.7f, 1.f, .3f}, .3f, {3, 5, 16}});
    pass.at(0, 0).set(SharedNoiseSums<whole_frame>{}, {2.f, 6.f, 8.f, 16.f}); // so that three quarters of it come back
    pass.fill(LightAround{}, .5f, 2.f), pass.fill(Witness<Around::before>{}, .1f, .9f), pass.fill(Witness<Around::after>{}, .1f, .9f);
    pass.each_pixel([](auto const& p) {
        p.set(denoised, {-.05f}); // outside the gamut
        if (p.x > 30 && p.y > 9) p.set(Witness<Around::before>{}, {0.f});
        if (p.x > 30 && p.y > 10) p.set(Witness<Around::after>{}, {0.f});
        auto const add = [&](auto from, auto to, int count, float times) { // what they have in common
            for (int c = 0; c < count; ++c)
                p.set(to, {.5f * static_cast<float>(p.in(to, c)) + times * static_cast<float>(p.in(from, c))}, c);
        };
        float const times = .04f * static_cast<float>(p.x - 4);
        add(lacking, ResidualThere<Around::before>{}, 3, times), add(Blurs<Around::now>{}, Blurs<Around::before>{}, 6, times);
        add(lacking, ResidualThere<Around::after>{}, 3, times), add(Blurs<Around::now>{}, Blurs<Around::after>{}, 6, times);
    });
    int repeated = 0;
    std::vector<std::array<MeanAround, 3>> means;
    pass.each_pixel([&](auto const& p) { means.push_back({MeanAround(p, 0), {p, 1}, {p, 2}}); });
    pass.run([&](auto const& p) {
        Triple off(0.);
        auto const& known = means[static_cast<std::size_t>(p.y * 37 + p.x)][0].known;
        for (std::size_t band = 0; band < 3; ++band) {
            auto const mean = [&](auto const& q) { return means[static_cast<std::size_t>(q.y * 37 + q.x)][band]; };
            auto const here = [&](auto const& q) { return bands<Around::now>(q)[band]; };
            auto const sum = [&](auto const& f) { return p.sum(radius[band], radius[band], f); };
            auto const weight = [](auto const& q) { return std::pow(q.in(LightAround{}), -2.); };
            auto const product = [&](auto const& q) { return weight(q) * mean(q).known * glm::dot(here(q), mean(q).value); };
            double const v = sum([&](auto const&q) { return weight(q) * square(here(q)); }),
                         u = sum([&](auto const&q) { return weight(q) * mean(q).known * square(mean(q).value); }),
                         w = sum([&](auto const&q) { return weight(q) * mean(q).known * mean(q).squares; });
            double const sure = sum(product) - caution[band] * std::sqrt(sum([&](auto const& q) { return product(q) * product(q); }));
            double const c = std::min({sure, .98 * std::sqrt(u * v), u, v});
            if (c <= 0.) continue;
            // v a + c b = m and c a + u b = c, m the square of the mistake.
            double const m = std::max(c * v / w, c), determinant = std::max(u * v - c * c, .03 * u * v);
            double const a = std::clamp((u * m - c * c) / determinant, 0., 1.), b = std::clamp((v * c - c * m) / determinant, 0., 1. - a);
            off += parts[band] * (a * here(p) + b * mean(p).value), repeated += a > .05 && b > .05 && a + b < .95;
        }
        auto const old = p.colour(denoised);
        p.check(denoised, glm::max(old + 1.5 * .75 * (known > 0. ? known : 1.) * off, glm::min(old, .3 * old)));
        auto const left_out = [&]<Around frame>() { return p.in(ResidualThere<frame>{}, 3) - p.in(Witness<frame>{}, 1); };
        p.check(repeated_refusal, .5 * (left_out.template operator()<Around::before>() + left_out.template operator()<Around::after>()),
                .75);
    });
    CHECK(repeated > 300);
}
