#include "alone.hpp"

using namespace quell;
using namespace quell::detail;
using namespace quell::tests;

namespace {
double part(float a) { return static_cast<double>(a); }
/// Of halves, the mean and that of the other half's samples.
Triple smooth(auto const& p) {
    return (p.colour(FirstHalf{}) + p.colour(SecondHalf{})) / std::max(p.in(FirstHalf{}, 3) + p.in(SecondHalf{}, 3), 1e-6);
}
Triple of_others(auto const& p) {
    bool const is_first = is_even(p.x + p.y);
    double const known = is_first ? p.in(SecondHalf{}, 3) : p.in(FirstHalf{}, 3);
    return known > .02 ? (is_first ? p.colour(SecondHalf{}) : p.colour(FirstHalf{})) / known : Triple(0.);
}
/// The products of what is given and what others say, as a share is found by.
Triple products_of(auto const& p, Triple const& given, Triple const& others) {
    double const per_square = p.in(SampleResidual{}, 3) / p.in(MeanSquare{}),
                 product = glm::dot(p.colour(SampleResidual{}), others) * per_square;
    return {product, square(given) * per_square, product * product};
}
} // namespace

TEST_CASE("stages: the brightness of a frame is summed over blocks, also of those that stick out of it") {
    for (Extent const size : {Extent{75, 43}, Extent{4100, 9}, Extent{1, 530}}) {
        PassAlone<SumBrightness, SumFrame<BrightnessSums>> pass(size, {}, {});
        pass.run([&](auto const& p) {
            auto const check = [&]<int fraction>(BrightnessSums<fraction> sums) {
                if (p.x % fraction + p.y % fraction > 0) return;
                double sum = 0., pixels = 0.;
                for (int y = p.y; y < std::min(p.y + fraction, size.height); ++y)
                    for (int x = p.x; x < std::min(p.x + fraction, size.width); ++x, ++pixels)
                        sum += luminance_of(pass.at(x, y).colour(denoised));
                p.check(sums, sum, pixels);
            };
            for_each_channel(emits_of<FrameBrightness>{}, check);
        });
    }
}

TEST_CASE("stages: sums along rows are of the pixels in the image, and a bright one takes nothing off others") {
    for (int const radius : {0, 1, 6, 16}) {
        PassAlone<SumRows<ResidualSquares, ResidualSquaresOfRows>> pass({radius});
        pass.at(20, 10).set(ResidualSquares{}, {1e12f});
        pass.run([&](auto const& p) {
            auto const sum = [&](int c) { return p.sum(radius, 0, [&](auto const& q) { return q.in(ResidualSquares{}, c); }); };
            p.check(ResidualSquaresOfRows{}, sum(0), sum(1));
        });
    }
}

TEST_CASE("stages: light around a pixel, in units of the frame's brightness, and its logarithms") {
    PassAlone<SumBrightnessOfRows, TakeLight> pass({}, {});
    for (double const unit : {1.5, 1.}) {
        if (unit == 1.) pass.at(0, 0).set(BrightnessSums<whole_frame>{}, {0.f}); // of a black frame
        pass.run([&](auto const& p) {
            auto const light = [&](auto const& q) { return luminance_of(q.colour(denoised)) / unit; };
            double const around = p.sum(2, 2, light) / p.pixels(2) + .02;
            p.check(LightAround{}, around), p.check(LightLogarithms{}, std::log(light(p) + .05 * around), std::log(around));
        });
    }
}

TEST_CASE("stages: a residual is limited, and what is more than its surroundings is spread over its half of the checkerboard") {
    ResidualLimits const limits{.most = 4.f, .dark = .1f, .spike = 1.3f};
    PassAlone<LimitedResidual<Radiance>, SetOutHalves> pass({limits}, {});
    pass.fill(radiance, .1f, 1.3f), pass.fill(denoised, -.2f, 1.4f);
    pass.each_pixel([](auto const& p) {
        if ((p.x * 7 + p.y * 5) % 11 == 0) p.set(radiance, {.5f, 40.f});
        if ((p.x * 3 + p.y * 8) % 13 == 0 || (p.x < 9 && p.y < 9)) p.set(radiance, {.5f, none});
        if ((p.x + p.y * 4) % 17 == 0) p.set(radiance, {-30.f});
        if ((p.x * 5 + p.y * 2) % 19 == 0) p.set(radiance, {30.f, 30.f, 30.f}), p.set(denoised, {30.f, 30.f, 30.f});
    });
    // Missing in the picture is what is no light.
    auto const count = [](auto const& p) {
        return luminance_of(p.colour(radiance)) >= 0. && luminance_of(p.colour(denoised)) >= 0. ? 1. : 0.;
    };
    auto const light = [](auto const& p) { return luminance_of(p.colour(denoised)) / 1.5 + .1; };
    auto const whole = [&](auto const& p) {
        return count(p) > 0. ? glm::min(p.colour(radiance) / 1.5, Triple(4. * light(p))) - p.colour(denoised) / 1.5 : Triple(0.);
    };
    auto const mean_square = [&](auto const& p) {
        return p.sum(3, 3, [&](auto const& q) { return square(whole(q)); }) / std::max(p.sum(3, 3, count), 1.) + 1e-4 * light(p) * light(p);
    };
    auto const kept = [&](auto const& p) {
        return whole(p) * std::min(std::sqrt(mean_square(p) * 1.69 / std::max(square(whole(p)), 1e-30)), 1.);
    };
    int spikes = 0;
    pass.run([&](auto const& p) {
        auto const in_half = [&](auto const& f) {
            return p.sum(3, 3, [&](auto const& q) { return is_even(q.x + q.y - p.x - p.y) ? f(q) : 0. * f(q); });
        };
        auto const more = in_half([&](auto const& q) { return whole(q) - kept(q); }) / std::max(in_half(count), 1.);
        auto const wanted = kept(p) + count(p) * more;
        bool const is_first = is_even(p.x + p.y);
        if (count(p) > 0.) p.check(MeanSquare{}, mean_square(p));
        p.check(SampleResidual{}, wanted, count(p)), spikes += kept(p) != whole(p);
        p.check(FirstHalf{}, wanted * double(is_first), is_first * count(p)),
            p.check(SecondHalf{}, wanted * double(!is_first), !is_first * count(p));
        auto const logarithm = [](auto const& q) { return q.in(LightLogarithms{}, 1); };
        p.check(TextureOfRows{}, p.sum(4, 0, logarithm), p.sum(4, 0, [&](auto const& q) { return logarithm(q) * logarithm(q); }));
    });
    CHECK(spikes > 20);
}

TEST_CASE("stages: halves of a residual are smoothed over surfaces and pieces of like light") {
    for (int const step : {1, 8}) {
        PassAlone<SmoothHalves> pass({step});
        pass.most = 2e-4;
        pass.fill(LightLogarithms{}, 0.f, .3f);
        pass.each_pixel([](auto const& p) { // two slopes, one behind the other, in front of the sky; some without a normal, some turned
            double const up = p.y < 2 ? 0. : (p.x + 3 * p.y) % 10 == 0 ? -1. : 1.;
            glm::vec3 const n = up * glm::normalize(p.colour(normal) * .2 + Triple(0., 0., 1.));
            p.set(normal, {n.x, n.y, n.z});
            p.set(depth, {p.x > 30 ? endless : (p.y > 12 ? 4.f : 3.f) + .1f * static_cast<float>(p.x + 2 * p.y)});
        });
        pass.run([&](auto const& p) {
            constexpr double spline[]{.375, .25, .0625};
            glm::dvec4 first(0.), second(0.);
            double whole = 0.;
            for (int j = -2; j <= 2; ++j)
                for (int i = -2; i <= 2; ++i) {
                    auto const q = pass.at(p.x + i * step, p.y + j * step);
                    if (q.x < 0 || q.y < 0 || q.x >= 37 || q.y >= 23) continue;
                    double w = spline[std::abs(i)] * spline[std::abs(j)];
                    if (i != 0 || j != 0) {
                        double const z = std::min(p.in(depth), 1e30), there = std::min(q.in(depth), 1e30);
                        double const darker = (q.in(LightLogarithms{}) - p.in(LightLogarithms{})) / .15;
                        w *= std::pow(std::max(glm::dot(p.colour(normal), q.colour(normal)), 0.), 32.) /
                             (1. + std::pow((there - z) / (.05 * std::max(z, there)), 2.)) / (1. + darker * darker);
                    }
                    whole += w, first += w * glm::dvec4(q.colour(FirstHalf{}), q.in(FirstHalf{}, 3));
                    second += w * glm::dvec4(q.colour(SecondHalf{}), q.in(SecondHalf{}, 3));
                }
            p.check(FirstHalf{}, Triple(first) / whole, first.w / whole), p.check(SecondHalf{}, Triple(second) / whole, second.w / whole);
        });
    }
}

TEST_CASE("stages: levels are of both halves and of the other one, the finest band is what the next level has not") {
    auto const check = [](auto& pass, auto const& wanted) {
        pass.each_pixel([](auto const& p) {
            p.set(FirstHalf{}, {.01f * static_cast<float>((p.x * 5 + p.y) % 7) - .001f}, 3);
            p.set(SecondHalf{}, {.01f * static_cast<float>((p.x + p.y * 3) % 5) + .001f}, 3);
            p.set(MeanSquare{}, {.1f + static_cast<float>(p.x)});
        });
        pass.run(wanted);
    };
    PassAlone<TakeFinestLevel> level({});
    check(level, [](auto const& p) { p.check(FinestLevel{}, smooth(p)), p.check(FinestLevelOfOthers{}, of_others(p)); });
    PassAlone<TakeFinestBand> band({});
    check(band, [](auto const& p) {
        auto const others = p.colour(FinestLevelOfOthers{}) - of_others(p);
        p.check(FinestBand{}, p.colour(FinestLevel{}) - smooth(p)), p.check(FinestBandOfOthers{}, others);
        p.check(BandProducts{}, products_of(p, others, others));
    });
}

TEST_CASE("stages: parts of levels are fed back, none more than whole, by shares of frames without a past and with one") {
    ResidualFeedbackShares const first{.fine_held = 1.3f, .wide = .1f, .wide_noise = -.3f, .wide_texture = .5f}, later{.wide = .7f};
    PassAlone<GiveLevels> pass({first, later, .5f});
    pass.fill(LightAround{}, .5f, 2.f), pass.fill(MeanSquare{}, 1e-4f, 6.f), pass.fill(FirstHalf{}, .5f, 1.f),
        pass.fill(SecondHalf{}, -.5f, 1.f);
    pass.each_pixel([&](auto const& p) {
        auto const along = static_cast<float>(p.x), down = static_cast<float>(p.y),
                   product = static_cast<float>(p.in(BandProductsOfRows{}));
        p.set(TextureOfRows{}, {static_cast<float>(p.x % 5 - 2), static_cast<float>(p.x % 5 + 4)});
        p.set(BandProductsOfRows{}, {product + .05f * along, product + 1.1f, product * product * down});
        if (p.x % 6 == 0) p.set(MeanSquare{}, {p.y < 11 ? 1e4f : 1e-4f}); // more noise, or less, than counts
    });
    pass.at(7, 5).set(FinestBand{}, {none, endless}), pass.at(8, 5).set(FinestBandOfOthers{}, {-endless});
    for (auto const& by : {first, later})
        pass.run([&](auto const& p) {
            auto const logarithm = [&](int c) { return p.column(TextureOfRows{}, 4, c) / p.pixels(4); };
            auto const held = [&](int c) { return p.column(BandProductsOfRows{}, 6, c); };
            double const light = p.in(LightAround{}), deviation = std::sqrt(std::max(logarithm(1) - std::pow(logarithm(0), 2.), 0.)),
                         noise = std::clamp(std::log2(std::sqrt(p.in(MeanSquare{}) / 3.) / light + 1e-3) / 3., -2., 1.5),
                         sure = std::clamp(held(0) / held(1), 0., 1.) * std::clamp(held(0) / std::sqrt(2. * held(2)) / 3., 0., 1.),
                         fine = std::min(part(by.fine_held) * sure, 1.),
                         wide = std::min(
                             part(by.wide) + part(by.wide_noise) * noise + part(by.wide_texture) * std::min(2. * deviation, 1.5), 1.);
            auto const given = [&](Triple band, Triple const& level) {
                for (int c = 0; c < 3; ++c) band[c] = std::isfinite(band[c]) ? band[c] : 0.;
                return fine * limited(band, .5 * light) + wide * limited(level, .5 * light);
            };
            auto const wanted = given(p.colour(FinestBand{}), smooth(p));
            p.check(LevelsGiven{}, wanted);
            p.check(LevelProducts{}, products_of(p, wanted, given(p.colour(FinestBandOfOthers{}), of_others(p))));
        });
}

TEST_CASE("stages: what comes back is the share that held-out samples bear out, as far as noise is of single pixels, and leaves light") {
    // Of 16 windows a quarter lies below the least, between that and the middle, from there to the most, or beyond.
    using Windows = std::array<float, 4>;
    for (auto const& [windows, trust] :
         {std::pair{Windows{5, 9, 12, 16}, 1.}, {{2, 6, 8, 16}, .75}, {{0, 3, 5, 16}, .25}, {{0, 1, 3, 16}, 0.}}) {
        PassAlone<AddLevels<true>> pass({4, .5f, .3f});
        for (int c = 0; float const each : windows) pass.at(0, 0).set(SharedNoiseSums<whole_frame>{}, {each}, c++);
        pass.each_pixel([](auto const& p) {
            auto const product = static_cast<float>(p.in(LevelProductsOfRows{}));
            p.set(denoised, {-.05f}); // outside the gamut
            p.set(LevelProductsOfRows{}, {product + (p.x < 16 ? .8f : -.2f), product + 1.1f, product * product});
        });
        double least = 1., most = 0.;
        pass.run([&, by = trust](auto const& p) {
            auto const sum = [&](int c) { return p.column(LevelProductsOfRows{}, 4, c); };
            // The mean of 1 and of h / a, each by one over its variance.
            double const variance = 2. * sum(2) / (sum(1) * sum(1)),
                         w = std::clamp((sum(0) / sum(1) / variance + 1. / .5) / (1. / variance + 1. / .5), 0., 1.);
            least = std::min(least, w), most = std::max(most, w);
            auto const old = p.colour(denoised);
            p.check(denoised, glm::max(old + 1.5 * by * w * p.colour(LevelsGiven{}), glm::min(old, .3 * old)));
            p.check(noise_independence, by);
        });
        CHECK((least < .2 && most > .8));
    }
}

TEST_CASE("stages: of windows, the lesser correlation of neighbours to the right and below, if there is noise") {
    constexpr SampleResidual residual;
    for (int const height : {61, 57}) { // of 57 rows the last windows have one, which has none below
        PassAlone<ShareOfNeighbours<SampleResidual>, SumFrame<SharedNoiseSums>> pass(Extent{91, height}, {{.least = .1f, .most = .3f}}, {});
        // More in common below than to the right in some windows, the other way round in others; in some nothing but rounding.
        pass.each_pixel([&](auto const& p) {
            auto const across = static_cast<float>(p.x) / 91.f, down = 1.f - across;
            glm::vec3 const here = p.colour(residual), beside = pass.at(std::min(p.x + 1, 90), p.y).colour(residual),
                            below = pass.at(p.x, std::min(p.y + 1, height - 1)).colour(residual),
                            mixed = p.x < 16 ? glm::vec3(.3f + 1e-7f * across) : here + down * beside + across * below + .5f;
            p.set(residual, {mixed.x, mixed.y, mixed.z});
        });
        std::vector<double> parts;
        pass.each_pixel([&](auto const& p) {
            if (p.x % 8 > 0 || p.y % 8 > 0) return;
            Triple right(0.), below(0.), squares(0.), mean(0.);
            auto const each = [&](auto const& f) {
                for (int y = p.y; y < std::min(p.y + 8, height - 1); ++y)
                    for (int x = p.x; x < std::min(p.x + 8, 90); ++x) f(x, y, pass.at(x, y).colour(residual));
            };
            double pixels = 0.;
            each([&](int, int, Triple const& e) { mean += e, ++pixels; });
            mean /= std::max(pixels, 1.);
            each([&](int x, int y, Triple const& e) {
                right += (e - mean) * pass.at(x + 1, y).colour(residual), below += (e - mean) * pass.at(x, y + 1).colour(residual);
                squares += (e - mean) * e;
            });
            auto const sum = [](Triple const& c) { return c.x + c.y + c.z; };
            if (sum(squares) > 1e-4) parts.push_back(std::min(sum(right), sum(below)) / sum(squares));
        });
        auto const below = [&](double limit) {
            return static_cast<double>(std::ranges::count_if(parts, [&](double a) { return a < limit; }));
        };
        CHECK((below(.1) > 0. && below(.2) > below(.1) && below(.3) > below(.2) && below(9.) > below(.3)));
        pass.run([&](auto const& p) { p.check(SharedNoiseSums<whole_frame>{}, below(.1), below(.2), below(.3), below(9.)); });
    }
}
