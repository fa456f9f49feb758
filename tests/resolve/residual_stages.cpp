#include <doctest/doctest.h>
#include <quell/execute/executor.hpp>
#include <quell/resolve/repeated_residual.hpp>
#include <quell/resolve/residual_feedback.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

// What ResidualFeedback and RepeatedResidual are made of, against double loops over the pixels around.
namespace {

using namespace quell;
using namespace quell::detail;
using Triple = glm::dvec3;

constexpr Extent size{37, 23};
constexpr float none = std::numeric_limits<float>::quiet_NaN();

template <int n = 3> Planes<n> random_planes(unsigned seed, float low, float high) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(low, high);
    Planes<n> image(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < n; ++c) image.view().set(c, x, y, number(random));
    return image;
}
template <int n> double at(Planes<n> const& image, int x, int y, int c = 0) { return static_cast<double>(image.view().get(c, x, y)); }
Triple colour(auto const& image, int x, int y) { return {at(image, x, y, 0), at(image, x, y, 1), at(image, x, y, 2)}; }
double bright(Triple const& c) { return std::abs(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z); }
double square(Triple const& c) { return glm::dot(c, c); }

void each_pixel(auto const& f) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) f(x, y);
}
/// The sum over the pixels of a square that lie in the image.
auto sum_around(int x, int y, int radius, auto const& f) {
    auto sum = 0. * f(x, y);
    for (int j = std::max(y - radius, 0); j <= std::min(y + radius, size.height - 1); ++j)
        for (int i = std::max(x - radius, 0); i <= std::min(x + radius, size.width - 1); ++i) sum += f(i, j);
    return sum;
}
double mean_around(int x, int y, int radius, auto const& f) {
    return sum_around(x, y, radius, f) / sum_around(x, y, radius, [](int, int) { return 1.; });
}
double mean_brightness_of(Planes<3> const& picture) {
    return mean_around(0, 0, 99, [&](int x, int y) { return bright(colour(picture, x, y)); });
}
double light_at(Planes<3> const& picture, int x, int y) {
    return mean_around(x, y, 2, [&](int i, int j) { return bright(colour(picture, i, j)); }) + .02 * mean_brightness_of(picture) + 1e-6;
}
/// The largest difference of numbers to what they should be, as a part of that or of 1.
struct Worst {
    double off = 0.;
    void compare(double made, double wanted) {
        double const by = std::abs(made - wanted) / (1. + std::abs(wanted));
        off = by <= 1e9 ? std::max(off, by) : 1e9;
    }
    void compare(Triple const& made, Triple const& wanted) {
        for (int c = 0; c < 3; ++c) compare(made[c], wanted[c]);
    }
    ~Worst() { CHECK(off < 2e-4); }
};

/// A picture, samples with holes and spikes, and their residual.
struct Seen {
    Planes<3> picture = random_planes(1, -.2f, 1.4f), samples = random_planes(2, .1f, 1.3f);
    ResidualLimits limits{.most = 4.f, .dark = .1f, .spike = 1.3f, .noise_radius = 2};
    Brightness brightness;
    WindowSums<4> sums{size};
    PictureResidual residual;

    static Planes<3> with_holes(Planes<3> samples) {
        each_pixel([&](int x, int y) {
            if ((x * 7 + y * 5) % 11 == 0) samples.view().set(1, x, y, 40.f);
            if ((x * 3 + y * 8) % 13 == 0) samples.view().set(2, x, y, none);
            if ((x + y * 4) % 17 == 0) samples.view().set(0, x, y, -30.f);
        });
        return samples;
    }
    Seen()
        : samples(with_holes(random_planes(2, .1f, 1.3f))), brightness(Simd{}, picture.view()),
          residual(Simd{}, sums, limits, samples.view(), picture.view(), brightness) {}
    [[nodiscard]] bool is_sample(int x, int y) const {
        return glm::dot(colour(samples, x, y), Triple(0.2126, 0.7152, 0.0722)) >= 0.; // not of NaN
    }
};

} // namespace

TEST_CASE("stages: a Gaussian's mean is that of the pixels in the image, to three deviations") {
    auto const image = random_planes(3, -1.f, 1.f);
    for (float const deviation : {.7f, 2.f}) {
        auto const made = blurred(Simd{}, image.view(), deviation);
        Worst worst;
        each_pixel([&](int x, int y) {
            auto const weight = [&](int i, int j) {
                return std::exp(-.5 * ((i - x) * (i - x) + (j - y) * (j - y)) /
                                (static_cast<double>(deviation) * static_cast<double>(deviation)));
            };
            int const radius = static_cast<int>(std::ceil(3.f * deviation));
            auto const sum = sum_around(x, y, radius, [&](int i, int j) { return weight(i, j) * colour(image, i, j); });
            worst.compare(colour(made, x, y), sum / sum_around(x, y, radius, weight));
        });
        // What a pixel has of itself, where all are in the image.
        auto dot = random_planes(3, 0.f, 0.f);
        dot.view().set(0, 18, 11, 1.f);
        worst.compare(static_cast<double>(GaussianTaps(deviation).of_own_pixel()), at(blurred(Simd{}, dot.view(), deviation), 18, 11));
    }
}

TEST_CASE("stages: sums over windows are those of each pixel's square, and bright pixels take nothing off dark ones") {
    auto from = random_planes<1>(4, 0.f, 1.f);
    from.view().set(0, 20, 10, 1e12f);
    Planes<2> to(size);
    for (int const radius : {0, 1, 6, 16}) {
        CAPTURE(radius);
        WindowSums<4> sums(size);
        sums.around<2>(
            Simd{}, radius,
            [in = from.view()]<class Real>(AtOnce<Real>, int x, int y) {
                return std::array{Real(1.f), in.load_component<Real>(0, x, y)};
            },
            [out = to.view(), radius]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
                store_pixels<Real>(out, x, y, {around[0] - pixels_in_square<Real>(x, y, radius, size), around[1]}, count);
            });
        Worst worst;
        each_pixel([&](int x, int y) {
            worst.compare(at(to, x, y, 1), sum_around(x, y, radius, [&](int i, int j) { return at(from, i, j); }));
            worst.compare(at(to, x, y), 0.);
        });
    }
}

TEST_CASE("stages: a residual is limited, and what is more than its surroundings is spread over its half of the checkerboard") {
    Seen const seen;
    auto const most = static_cast<double>(seen.limits.most), spike = static_cast<double>(seen.limits.spike);
    int const radius = seen.limits.noise_radius;
    double const dark = static_cast<double>(seen.limits.dark) * mean_brightness_of(seen.picture) + 1e-6;
    auto const light = [&](int x, int y) { return bright(colour(seen.picture, x, y)) + dark; };
    auto const whole = [&](int x, int y) {
        if (!seen.is_sample(x, y)) return Triple(0.);
        return glm::min(colour(seen.samples, x, y), Triple(light(x, y) * most)) - colour(seen.picture, x, y);
    };
    auto const count = [&](int x, int y) { return seen.is_sample(x, y) ? 1. : 0.; };
    auto const mean_square = [&](int x, int y) {
        return sum_around(x, y, radius, [&](int i, int j) { return square(whole(i, j)); }) / std::max(sum_around(x, y, radius, count), 1.) +
               1e-4 * light(x, y) * light(x, y);
    };
    auto const kept = [&](int x, int y) {
        double const limit = mean_square(x, y) * spike * spike, its = square(whole(x, y));
        return whole(x, y) * (its > limit ? std::sqrt(limit / its) : 1.);
    };
    Worst worst;
    int spikes = 0;
    each_pixel([&](int x, int y) {
        worst.compare(at(seen.residual.mean_square, x, y), count(x, y) * mean_square(x, y));
        spikes += kept(x, y) != whole(x, y);
        auto const in_half = [&](int i, int j) { return (i + j) % 2 == (x + y) % 2 ? 1. : 0.; };
        auto const more = sum_around(x, y, radius, [&](int i, int j) { return in_half(i, j) * (whole(i, j) - kept(i, j)); });
        auto const shared = sum_around(x, y, radius, [&](int i, int j) { return in_half(i, j) * count(i, j); });
        worst.compare(colour(seen.residual.value, x, y), seen.is_sample(x, y) ? kept(x, y) + more / std::max(shared, 1.) : Triple(0.));
    });
    CHECK(spikes > 20);
}

TEST_CASE("stages: a residual is smoothed over surfaces and pieces of like light, and held out by halves") {
    Seen const seen;
    auto normals = random_planes(5, -.25f, .25f);
    auto depths = random_planes<1>(6, 3.f, 3.3f);
    auto const light = random_planes<1>(7, 0.f, .3f);
    each_pixel([&](int x, int y) {
        normals.view().set(2, x, y, 1.5f);
        if (x > 20) depths.view().set(0, x, y, std::numeric_limits<float>::infinity());
        if (y < 4)
            for (int c = 0; c < 3; ++c) normals.view().set(c, x, y, y < 2 ? 0.f : none);
    });
    auto const levels = levels_of<3>(Simd{}, seen.residual, {normals.view(), depths.view(), .05f, light.view(), .15f});
    auto const direction = [&](int x, int y) { return y < 4 ? Triple(0.) : glm::normalize(colour(normals, x, y)); };
    auto const nearness = [&](int x, int y) { return x > 20 ? 0. : 1. / at(depths, x, y); };
    auto const pixel = [](int x, int y) { return static_cast<std::size_t>(y * size.width + x); };
    std::array<std::vector<glm::dvec4>, 2> from, to;
    for (int half : {0, 1})
        each_pixel([&](int x, int y) {
            bool const here = (x + y) % 2 == half && seen.is_sample(x, y);
            from[static_cast<std::size_t>(half)].push_back(here ? glm::dvec4(colour(seen.residual.value, x, y), 1.) : glm::dvec4(0.));
        });
    Worst worst;
    for (int step = 1; auto const& level : levels) {
        to = from;
        each_pixel([&](int x, int y) {
            double whole = 0.;
            glm::dvec4 sums[2]{glm::dvec4(0.), glm::dvec4(0.)};
            for (int j = y - 2 * step; j <= y + 2 * step; j += step)
                for (int i = x - 2 * step; i <= x + 2 * step; i += step) {
                    if (i < 0 || j < 0 || i >= size.width || j >= size.height) continue;
                    constexpr double spline[]{.375, .25, .0625};
                    double w = spline[std::abs(i - x) / step] * spline[std::abs(j - y) / step];
                    if (i != x || j != y) {
                        double const range = .05 * std::max({nearness(i, j), nearness(x, y), 3e-19});
                        w *= std::pow(std::max(glm::dot(direction(x, y), direction(i, j)), 0.), 32.) /
                             (1. + std::pow((nearness(i, j) - nearness(x, y)) / range, 2.)) /
                             (1. + std::pow((at(light, i, j) - at(light, x, y)) / .15, 2.));
                    }
                    whole += w;
                    for (std::size_t half : {0u, 1u}) sums[half] += w * from[half][pixel(i, j)];
                }
            for (std::size_t half : {0u, 1u}) to[half][pixel(x, y)] = sums[half] / whole;
            auto const both = (sums[0] + sums[1]) / whole, other = sums[(x + y) % 2 == 0] / whole;
            worst.compare(colour(level.value, x, y), Triple(both) / std::max(both.w, 1e-6));
            if (std::abs(other.w - .02) > 1e-5)
                worst.compare(colour(level.held, x, y), other.w > .02 ? Triple(other) / other.w : Triple(0.));
        });
        from = to, step *= 2;
    }
}

TEST_CASE("stages: noise, texture and light around a pixel, and how far held-out samples bear a band out") {
    Seen seen;
    auto bright_there = seen.picture; // a part is brighter: its edge is texture
    each_pixel([&](int x, int y) {
        for (int c = 0; c < 3 && x > 25; ++c) bright_there.view().set(c, x, y, 2.f * bright_there.view().get(c, x, y));
    });
    Brightness const brightness(Simd{}, bright_there.view());
    FeedbackGates const gates(Simd{}, seen.sums, seen.residual, bright_there.view(), brightness);
    ResidualLevel fine(size), coarse(size);
    fine.held = random_planes(9, -1.f, 1.f), coarse.held = random_planes(10, -.5f, .5f);
    auto const shares = held_shares(Simd{}, seen.sums, seen.residual, fine, coarse);
    auto const light = [&](int x, int y) { return light_at(bright_there, x, y); };
    std::vector<double> lights;
    each_pixel([&](int x, int y) { lights.push_back(light(x, y)); });
    auto const known_light = [&](int x, int y) { return lights[static_cast<std::size_t>(y * size.width + x)]; };
    auto const squares = [&](int x, int y) { return at(seen.residual.mean_square, x, y); };
    auto const with_missing = [&](int x, int y) { return squares(x, y) > 0. ? squares(x, y) : mean_around(x, y, 3, squares); };
    Worst worst;
    each_pixel([&](int x, int y) {
        double const its = known_light(x, y), variance = mean_around(x, y, 2, with_missing) / 3.;
        worst.compare(at(gates.light, x, y), its);
        double const own = glm::dot(colour(bright_there, x, y), Triple(0.2126, 0.7152, 0.0722));
        worst.compare(at(gates.light_logarithm, x, y), std::log(std::max(own, 0.) + .05 * its));
        worst.compare(at(gates.variance, x, y), variance);
        worst.compare(at(gates.noise, x, y), std::clamp(std::log2(std::sqrt(variance) / its + 1e-3) / 3., -2., 1.5));
        auto const logarithm = [&](int i, int j) { return std::log(known_light(i, j)); };
        double const mean = mean_around(x, y, 4, logarithm);
        double const spread = mean_around(x, y, 4, [&](int i, int j) { return std::pow(logarithm(i, j) - mean, 2.); });
        worst.compare(at(gates.texture, x, y), std::min(2. * std::sqrt(spread), 1.5));

        auto const per_square = [&](int i, int j) { return squares(i, j) > 0. ? 1. / squares(i, j) : 0.; };
        auto const band = [&](int i, int j) { return colour(fine.held, i, j) - colour(coarse.held, i, j); };
        auto const product = [&](int i, int j) { return glm::dot(colour(seen.residual.value, i, j), band(i, j)) * per_square(i, j); };
        double const common = sum_around(x, y, 6, product);
        double const bands = sum_around(x, y, 6, [&](int i, int j) { return square(band(i, j)) * per_square(i, j); });
        double const deviation = std::sqrt(2. * sum_around(x, y, 6, [&](int i, int j) { return product(i, j) * product(i, j); }));
        worst.compare(at(shares, x, y, 0), std::clamp(common / bands, 0., 1.));
        worst.compare(at(shares, x, y, 1), std::clamp(common / deviation / 3., 0., 1.));
    });
}

TEST_CASE("stages: parts of levels that are fed back, of which none comes back more than whole") {
    ResidualFeedbackShares const by{.fine_held = 1.3f, .wide = .4f, .wide_noise = -.3f, .wide_texture = .5f};
    constexpr double times = .5;
    auto const light = random_planes<1>(1, .5f, 2.f), noise = random_planes<1>(2, -2.f, 6.f), texture = random_planes<1>(3, 0.f, 1.5f);
    auto const fine = random_planes<2>(5, 0.f, 1.f);
    std::vector<Planes<3>> levels;
    for (unsigned i = 0; i < 6; ++i) levels.push_back(random_planes(10 + i, -1.f, 1.f));
    Planes<3> smooth(size), smooth_held(size);
    for_all_pixels(Simd{}, size,
                   FedBack{by,
                           static_cast<float>(times),
                           light.view(),
                           noise.view(),
                           texture.view(),
                           fine.view(),
                           {levels[0].view(), levels[1].view(), levels[2].view()},
                           {levels[3].view(), levels[4].view(), levels[5].view()},
                           smooth.view(),
                           smooth_held.view()});
    Worst worst;
    each_pixel([&](int x, int y) {
        auto const limited = [&](Triple const& c) {
            return glm::clamp(c, Triple(-times * at(light, x, y)), Triple(times * at(light, x, y)));
        };
        double const of_fine = std::min(1.3 * at(fine, x, y, 0) * at(fine, x, y, 1), 1.),
                     wide = std::min(.4 - .3 * at(noise, x, y) + .5 * at(texture, x, y), 1.);
        auto const given = [&](std::size_t first) {
            auto const level = [&](std::size_t i) { return colour(levels[first + i], x, y); };
            return of_fine * limited(level(0) - level(1)) + wide * limited(level(2));
        };
        worst.compare(colour(smooth, x, y), given(0)), worst.compare(colour(smooth_held, x, y), given(3));
    });
}

TEST_CASE("stages: what comes back is the share that held-out samples bear out, and leaves a part of the light") {
    Seen seen;
    auto const smooth = random_planes(5, -.5f, .5f), noise = random_planes(6, -.5f, .5f);
    auto held = random_planes(6, 0.f, 0.f);
    each_pixel([&](int x, int y) {
        for (int c = 0; c < 3; ++c) // of which the residual has something
            held.view().set(c, x, y, noise.view().get(c, x, y) + seen.residual.value.view().get(c, x, y) * (x < 16 ? .4f : -.1f));
    });
    auto made = seen.picture;
    made.view().set(0, 5, 5, none);
    ResidualFeedback const rule{.darkest = .3f, .held_radius = 4, .held_variance = .5f};
    add_as_held(Simd{}, seen.sums, rule, .8f, seen.residual, smooth, held, made.view());
    auto const per_square = [&](int x, int y) {
        double const mean = at(seen.residual.mean_square, x, y);
        return mean > 0. ? 1. / mean : 0.;
    };
    auto const product = [&](int x, int y) { return glm::dot(colour(seen.residual.value, x, y), colour(held, x, y)) * per_square(x, y); };
    Worst worst;
    double least = 1., most = 0.;
    each_pixel([&](int x, int y) {
        if (x == 5 && y == 5) return;
        double const h = sum_around(x, y, 4, product),
                     a = sum_around(x, y, 4, [&](int i, int j) { return square(colour(smooth, i, j)) * per_square(i, j); });
        double const variance = 2. * sum_around(x, y, 4, [&](int i, int j) { return product(i, j) * product(i, j); }) / (a * a);
        // The mean of 1 and of h / a, each by one over its variance.
        double const w = std::clamp((h / a / variance + 1. / .5) / (1. / variance + 1. / .5), 0., 1.);
        least = std::min(least, w), most = std::max(most, w);
        auto const old = colour(seen.picture, x, y), more = colour(smooth, x, y);
        worst.compare(colour(made, x, y), glm::max(old + .8 * w * more, glm::min(old, .3 * old)));
    });
    CHECK(std::isnan(at(made, 5, 5)));
    CHECK((least < .2 && most > .8));
}

TEST_CASE("stages: an image moved is interpolated between pixels, and unknown where its surface was outside") {
    auto const image = random_planes(5, -1.f, 1.f), motion = random_planes(6, -5.f, 5.f);
    std::vector<glm::vec3> pixels(static_cast<std::size_t>(size.pixels()));
    copy_out(image.view(), pixels);
    Planes<2> vectors(size);
    each_pixel([&](int x, int y) {
        for (int c = 0; c < 2; ++c) vectors.view().set(c, x, y, x == y ? none : motion.view().get(c, x, y));
    });
    auto const now = moved(Simd{}, pixels, vectors.view(), glm::vec3(7.f));
    Worst worst;
    each_pixel([&](int x, int y) {
        double const column = x + at(vectors, x, y, 0), row = y + at(vectors, x, y, 1);
        Triple wanted(7.);
        if (column > -.5 && row > -.5 && column < size.width - .5 && row < size.height - .5) {
            wanted = Triple(0.); // the sum by each pixel's tent, with the border repeated
            for (int j = -1; j <= size.height; ++j)
                for (int i = -1; i <= size.width; ++i)
                    wanted += std::max(1. - std::abs(column - i), 0.) * std::max(1. - std::abs(row - j), 0.) *
                              colour(image, std::clamp(i, 0, size.width - 1), std::clamp(j, 0, size.height - 1));
        }
        worst.compare(Triple(now[static_cast<std::size_t>(y * size.width + x)]), wanted);
    });
}

TEST_CASE("stages: what a picture lacks of its samples is limited by the light around, in any unit") {
    Seen const seen;
    for (float const unit : {1.f, 1000.f}) {
        std::vector<glm::vec3> samples(static_cast<std::size_t>(size.pixels())), picture = samples;
        copy_out(seen.samples.view(), samples, unit), copy_out(seen.picture.view(), picture, unit);
        auto const lacking = lacking_of_samples({.most = 2.f}, Simd{}, size, samples, picture);
        Worst worst;
        each_pixel([&](int x, int y) {
            Triple const most(2. * light_at(seen.picture, x, y)), off = colour(seen.samples, x, y) - colour(seen.picture, x, y);
            worst.compare(Triple(lacking[static_cast<std::size_t>(y * size.width + x)]) / static_cast<double>(unit),
                          seen.is_sample(x, y) ? glm::clamp(off, -most, most) : Triple(0.));
        });
    }
}

TEST_CASE("stages: a witness counts by correlations of residuals over a window") {
    auto const now = random_planes(5, -1.f, 1.f), other = random_planes(6, -1.f, 1.f), staying = random_planes(7, -1.f, 1.f);
    auto const light = random_planes<1>(8, .5f, 2.f), known = random_planes<1>(9, 0.f, 1.f);
    auto there = other, on_screen = staying;
    each_pixel([&](int x, int y) { // from hardly to quite alike
        for (int c = 0; c < 3; ++c) {
            there.view().set(c, x, y, other.view().get(c, x, y) + now.view().get(c, x, y) * .06f * static_cast<float>(x));
            on_screen.view().set(c, x, y, staying.view().get(c, x, y) + now.view().get(c, x, y) * .1f * static_cast<float>(y));
        }
    });
    NewWitness const rule{.radius = 2, .alike = .5f, .same = .95f, .stays = .2f, .common = .9f, .scattered = -.2f, .in_shapes = .3f};
    BlurredResidual const residual(Simd{}, {.7f, 2.f}, there);
    WindowSums<6> sums(size);
    Planes<1> counts = known, is_new(size);
    count_witness(Simd{}, rule, sums, now.view(), residual, on_screen.view(), light.view(), counts.view(), is_new.view());
    auto const in_range = [](double from, double to, double value) { return std::clamp((value - from) / (to - from), 0., 1.); };
    Worst worst;
    each_pixel([&](int x, int y) {
        auto const common = [&](auto const& a, auto const& b) {
            return sum_around(x, y, 2,
                              [&](int i, int j) { return glm::dot(colour(a, i, j), colour(b, i, j)) / std::pow(at(light, i, j), 2.); });
        };
        auto const correlation = [&](auto const& b) { return common(now, b) / std::sqrt(common(now, now) * common(b, b)); };
        double const alike = correlation(there), stays = correlation(on_screen) - alike;
        double const of_white = static_cast<double>(residual.of_white), of_blurred = common(now, residual.blurred[0]) / common(now, there);
        double const fresh = in_range(.95, .5, alike) * in_range(.4, .2, stays);
        worst.compare(at(is_new, x, y), at(known, x, y) * fresh);
        if (alike < .02) return; // then the quotient may be anything
        double const detail = std::max(in_range(-.2, .3, (of_blurred - of_white) / (1. - of_white)), in_range(.9, .36, alike));
        worst.compare(at(counts, x, y), at(known, x, y) * std::max(fresh * detail, 1e-6));
    });
}

TEST_CASE("stages: what is repeated comes back by the least expected error") {
    auto const now = random_planes(5, -1.f, 1.f), light = random_planes(8, .5f, 2.f);
    Planes<1> const bright = light_around(Simd{}, *std::make_unique<WindowSums<1>>(size), Brightness(Simd{}, light.view()));
    std::vector<ResidualAround> frames;
    for (unsigned k = 0; k < 2; ++k) { // their noise, and what they have in common with now
        auto residual = random_planes(20 + k, -.4f, .4f);
        each_pixel([&](int x, int y) {
            for (int c = 0; c < 3; ++c)
                residual.view().set(c, x, y, residual.view().get(c, x, y) + .03f * static_cast<float>(x - 4) * now.view().get(c, x, y));
        });
        auto is_known = random_planes<1>(30 + k, .1f, .9f);
        each_pixel([&](int x, int y) {
            if (x > 30 && y > 9 + static_cast<int>(k)) is_known.view().set(0, x, y, 0.f);
        });
        frames.push_back({BlurredResidual(Simd{}, {.7f, 2.f}, std::move(residual)), std::move(is_known)});
    }
    BlurredResidual const here(Simd{}, {.7f, 2.f}, now);
    WindowSums<6> sums(size);
    for (std::size_t band = 0; band < 3; ++band) {
        CAPTURE(band);
        BandsAround around;
        for (std::size_t k = 0; k < 2; ++k)
            around.frames[k].emplace(BandsAround::Band{ResidualBand(frames[k].residual, band), frames[k].is_known.view()});
        auto made = random_planes(9, 0.f, 1.f);
        auto const before = made;
        add_repeated(Simd{}, sums, ResidualBand(here, band), around, bright.view(), 3, .7f, .9f, made.view());
        auto const in_band = [&](BlurredResidual const& r, int x, int y) {
            auto const finer = colour(band == 0 ? r.whole : r.blurred[band - 1], x, y);
            return band == 2 ? finer : finer - colour(r.blurred[band], x, y);
        };
        struct Mean {
            Triple value{0.};
            double squares = 0., known = 0.;
        };
        std::vector<Mean> means;
        each_pixel([&](int x, int y) {
            Mean mean;
            for (auto const& frame : frames) {
                auto const value = in_band(frame.residual, x, y);
                double const known = at(frame.is_known, x, y);
                mean.value += known * value, mean.squares += known * square(value), mean.known += known;
            }
            if (mean.known > 0.) mean.value /= mean.known, mean.squares /= mean.known;
            mean.known = std::min(mean.known, 1.), means.push_back(mean);
        });
        Worst worst;
        each_pixel([&](int x, int y) {
            auto const mean = [&](int i, int j) { return means[static_cast<std::size_t>(j * size.width + i)]; };
            auto const weight = [&](int i, int j) { return mean(i, j).known / std::pow(at(bright, i, j), 2.); };
            auto const product = [&](int i, int j) { return weight(i, j) * glm::dot(in_band(here, i, j), mean(i, j).value); };
            auto const sum = [&](auto const& f) { return sum_around(x, y, 3, f); };
            double const v = sum([&](int i, int j) { return square(in_band(here, i, j)) / std::pow(at(bright, i, j), 2.); });
            double const u = sum([&](int i, int j) { return weight(i, j) * square(mean(i, j).value); });
            double const w = sum([&](int i, int j) { return weight(i, j) * mean(i, j).squares; });
            double const sure = sum(product) - .7 * std::sqrt(sum([&](int i, int j) { return std::pow(product(i, j), 2.); }));
            double const c = std::min({sure, .98 * std::sqrt(u * v), u, v});
            auto added = Triple(0.);
            if (c > 0.) { // v a + c b = m and c a + u b = c, m the square of the mistake
                double const m = std::max(c * v / w, c), determinant = std::max(u * v - c * c, .03 * u * v);
                double const a = std::clamp((u * m - c * c) / determinant, 0., 1.),
                             b = std::clamp((v * c - c * m) / determinant, 0., 1. - a);
                added = .9 * (a * in_band(here, x, y) + b * mean(x, y).value);
            }
            auto const counts = mean(x, y).known > 0. ? mean(x, y).known : 1.;
            worst.compare(colour(made, x, y), colour(before, x, y) + counts * added);
        });
    }
}
