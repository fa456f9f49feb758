#include "../frames.hpp"

#include <numbers>

using namespace quell;

namespace {
using Six = Components<24, float>;
std::mt19937 generator(17);

float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(generator); }
glm::vec3 any_direction() {
    float const z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi_v<float>), r = std::sqrt(std::max(0.f, 1 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
}
/// Cosine-distributed around a normal: the normal plus a point of the unit sphere.
glm::vec3 cosine_direction(glm::vec3 n) {
    for (;;) {
        auto const d = n + any_direction();
        if (glm::dot(d, d) > 1e-6f) return d * (1 / std::sqrt(glm::dot(d, d)));
    }
}
/// What a cone has gathered, and how much it weighs.
glm::vec3 radiance_in(Six const& a, int k) { return glm::vec3(a.at[4 * k], a.at[4 * k + 1], a.at[4 * k + 2]) / a.at[4 * k + 3]; }
/// The same radiance in all cones, whatever their weights.
Six even(glm::vec3 radiance) {
    Six a{};
    for (int k = 0; k < cone::count; ++k) {
        float const w = uniform(0.1f, 5);
        a.at[4 * k] = radiance.x * w, a.at[4 * k + 1] = radiance.y * w, a.at[4 * k + 2] = radiance.z * w, a.at[4 * k + 3] = w;
    }
    return a;
}
double const half_angle = std::acos(5.0 / 6.0);

/// The part of a cone that two cones share, whose axes are `alpha` apart.
double overlap_in_closed_form(double alpha) {
    double const full = 2 * std::numbers::pi * (1 - std::cos(half_angle));
    if (alpha >= 2 * half_angle) return 0;
    if (alpha <= 0) return 1;
    double const gamma = alpha / 2;
    double const beta = std::acos(std::sin(gamma) / std::sin(half_angle)), phi = std::acos(std::tan(gamma) / std::tan(half_angle));
    return 4 * (beta - phi * std::cos(half_angle)) / full;
}
} // namespace

TEST_CASE("six unit axes: one along the normal, five at 60 degrees from it, 72 degrees apart, for every normal") {
    for (int i = 0; i < 2000; ++i) {
        auto const n = i == 0 ? glm::vec3(0, 0, -1) : i == 1 ? glm::vec3(0, 0, 1) : any_direction();
        cone::Axes<float> const axes(n);
        for (int k = 0; k < 5; ++k) {
            CHECK(glm::length(axes.at[k + 1]) == doctest::Approx(1).epsilon(1e-5));
            CHECK(glm::dot(axes.at[k + 1], n) == doctest::Approx(0.5).epsilon(1e-4));
            auto const a = axes.at[k + 1] - n * 0.5f, b = axes.at[(k + 1) % 5 + 1] - n * 0.5f;
            CHECK(glm::dot(a, b) == doctest::Approx(0.75 * std::cos(0.4 * std::numbers::pi)).epsilon(1e-4));
        }
    }
}

TEST_CASE("a sample falls into exactly one cone, the nearest, for any direction and normal") {
    for (int i = 0; i < 20000; ++i) {
        auto const n = any_direction(), d = i % 2 ? any_direction() : cosine_direction(n);
        glm::vec3 const colour(1, 2, 3);
        auto const a = cone::deposit(colour, d, n);
        cone::Axes<float> const axes(n);
        float samples = 0, closest = -2;
        int fullest = -1;
        for (int k = 0; k < cone::count; ++k) {
            samples += a.at[4 * k + 3], closest = std::max(closest, glm::dot(axes.at[k], d));
            if (a.at[4 * k + 3] == 1.f) fullest = k;
        }
        REQUIRE(samples == 1.f);
        REQUIRE(glm::dot(axes.at[fullest], d) == doctest::Approx(closest).epsilon(1e-5));
        REQUIRE(radiance_in(a, fullest) == colour);
    }
}

TEST_CASE("a direction that is not finite still counts once and colours nothing that it should not") {
    float const bad = std::bit_cast<float>(0x7fc00000u);
    auto const a = cone::deposit(glm::vec3(1, 2, 3), glm::vec3(bad), glm::vec3(0, 0, 1));
    float samples = 0;
    for (int k = 0; k < cone::count; ++k) samples += a.at[4 * k + 3];
    CHECK(samples == 1.f);
    auto const shaded = cone::shade(a);
    for (int c = 0; c < 3; ++c) CHECK(shaded[c] == doctest::Approx(1 + c).epsilon(1e-5));
}

TEST_CASE("constant radiance shades to itself; cones without a sample borrow and don't read black") {
    glm::vec3 const colour(0.25f, 1, 30);
    for (int i = 0; i < 1000; ++i) {
        auto a = even(colour);
        for (int k = 0; k < cone::count; ++k)
            if (i % 3 && uniform(0, 1) < 0.6f && k != i % cone::count)
                for (int c = 0; c < 4; ++c) a.at[4 * k + c] = 0;
        auto const out = cone::shade(a);
        CHECK(out.x == doctest::Approx(colour.x).epsilon(1e-6));
        CHECK(out.y == doctest::Approx(colour.y).epsilon(1e-6));
        CHECK(out.z == doctest::Approx(colour.z).epsilon(1e-6));
    }
    auto const nothing = cone::shade(Six{});
    CHECK(nothing == glm::vec3(0));
}

TEST_CASE("the parts of the cosine-weighted hemisphere are what numerical integration gives") {
    // Around each of many directions of the compass, the edge of the middle cell by bisection; below it lies sin^2 of its angle.
    double sum = 0;
    int const steps = 3600;
    cone::Axes<float> const axes({0, 0, 1});
    for (int i = 0; i < steps; ++i) {
        double const around = (i + 0.5) * 2 * std::numbers::pi / steps;
        double low = 0, high = 1.5;
        for (int j = 0; j < 50; ++j) {
            double const middle = 0.5 * (low + high), s = std::sin(middle), c = std::cos(middle);
            double ring = -2;
            for (int k = 1; k < cone::count; ++k)
                ring = std::max(ring, axes.at[k].x * s * std::cos(around) + axes.at[k].y * s * std::sin(around) + axes.at[k].z * c);
            (c > ring ? low : high) = middle;
        }
        sum += std::sin(low) * std::sin(low) / steps;
    }
    CHECK(std::abs(cone::middle_part - sum) < 1e-5);
    CHECK(std::abs(cone::part(0) + 5 * cone::part(3) - 1) < 1e-6);
}

TEST_CASE("the overlap of two cones is the closed form's to a thousandth") {
    double worst = 0;
    for (double alpha = 0; alpha < std::numbers::pi; alpha += 0.0005)
        worst = std::max(worst, std::abs(cone::overlap(static_cast<float>(std::cos(alpha))) - overlap_in_closed_form(alpha)));
    CHECK(worst < 1e-3);
    CHECK(cone::overlap(1.f) == 1.f);
    CHECK(cone::overlap(static_cast<float>(std::cos(2 * half_angle + 1e-3))) == 0.f);
    CHECK(cone::overlap(-1.f) == 0.f);
    CHECK(cone::overlap(1.0001f) == 1.f);
}

TEST_CASE("the mean of many cosine-distributed samples shades to the irradiance of the environment") {
    struct Case {
        glm::vec3 normal, brightest;
    };
    for (Case const& c : {Case{{0, 0, 1}, {0, 0, 1}}, Case{{0.6f, 0, 0.8f}, {0, 1, 0}}, Case{{0, -0.6f, -0.8f}, {0.8f, -0.6f, 0}}}) {
        glm::vec3 const n = c.normal;
        glm::dvec3 const w(c.brightest);
        auto const light = [&](glm::dvec3 d) { return std::pow(std::max(0.0, glm::dot(w, d)), 2) + 0.1; };
        // The irradiance over pi, on a grid of the disc below the hemisphere.
        cone::Axes<float> const axes(n);
        glm::dvec3 const up(n), across = glm::normalize(glm::dvec3(axes.at[1]) - 0.5 * up), along = glm::cross(up, across);
        double wanted = 0;
        int const grid = 400;
        for (int i = 0; i < grid; ++i)
            for (int j = 0; j < grid; ++j) {
                double const r = std::sqrt((i + 0.5) / grid), a = (j + 0.5) * 2 * std::numbers::pi / grid;
                wanted += light(across * (r * std::cos(a)) + along * (r * std::sin(a)) + up * std::sqrt(1 - r * r)) / (grid * grid);
            }
        glm::vec3 const tint(1, 0.5f, 3);
        std::vector<double> sums(24);
        int const samples = 200000;
        for (int i = 0; i < samples; ++i) {
            auto const d = cosine_direction(n);
            auto const a = cone::deposit(tint * static_cast<float>(light(d)), d, n);
            for (std::size_t k = 0; k < 24; ++k) sums[k] += a.at[k];
        }
        Six mean{};
        for (std::size_t k = 0; k < 24; ++k) mean.at[k] = static_cast<float>(sums[k] / samples);
        for (int i = 0; i < 3; ++i) CHECK(cone::shade(mean)[i] == doctest::Approx(wanted * static_cast<double>(tint[i])).epsilon(0.005));
        for (int k = 0; k < cone::count; ++k) CHECK(mean.at[4 * k + 3] == doctest::Approx(cone::part(k)).epsilon(0.02));
    }
}

TEST_CASE("constant radiance stays constant when it is passed to another normal's cones") {
    glm::vec3 const colour(0.5f, 2, 7);
    for (int i = 0; i < 2000; ++i) {
        auto const from = any_direction();
        auto const to = i % 3 ? cosine_direction(from) : from;
        auto const before = even(colour);
        auto const after = cone::transferred(before, from, to);
        for (int k = 0; k < cone::count; ++k) {
            // A cone that no cone of the other normal touches has nothing.
            if (after.at[4 * k + 3] < 1e-4f) continue;
            auto const there = radiance_in(after, k);
            CHECK(glm::length(there - colour) < 1e-5f * 7);
        }
        auto const shaded = cone::shade(after);
        CHECK(glm::length(shaded - colour) < 1e-5f * 7);
    }
}

namespace {
/// Six cones of random radiance and weights.
Six uneven() {
    Six a{};
    for (int i = 0; i < 24; ++i) a.at[i] = uniform(0.1f, 9);
    return a;
}
} // namespace

TEST_CASE("every cone takes from each other's as much as the closed form says that they overlap") {
    for (int i = 0; i < 1000; ++i) {
        auto const from = any_direction(), to = i % 10 ? cosine_direction(from) : from;
        auto const before = uneven();
        auto const after = cone::transferred(before, from, to);
        cone::Axes<float> const source(from), target(to);
        for (int j = 0; j < cone::count; ++j) {
            double wanted[4] = {}, slack[4] = {};
            for (int k = 0; k < cone::count; ++k) {
                double const alpha = std::acos(std::clamp(glm::dot(glm::dvec3(source.at[k]), glm::dvec3(target.at[j])), -1.0, 1.0));
                double const common = overlap_in_closed_form(alpha);
                // The polynomial is good to 0.0006, and where axes coincide, rounding of their cosine does as much.
                for (int c = 0; c < 4; ++c)
                    wanted[c] += common * static_cast<double>(before.at[4 * k + c]),
                        slack[c] += alpha < 2 * half_angle + 1e-3 ? 0.0015 * static_cast<double>(before.at[4 * k + c]) : 0;
            }
            for (int c = 0; c < 4; ++c) REQUIRE(std::abs(static_cast<double>(after.at[4 * j + c]) - wanted[c]) <= slack[c] + 1e-5);
        }
    }
}

TEST_CASE("radiance passed to the same normal's cones stays where it is, but for the little that neighbours share") {
    // Of the cone along the normal each of five neighbours shares 4.4 %, of each other cone it shares as much and two neighbours 3.4 %.
    double const by_middle = overlap_in_closed_form(std::acos(0.5));
    double const by_ring = overlap_in_closed_form(std::acos(0.25 + 0.75 * std::cos(0.4 * std::numbers::pi)));
    double const from_others[] = {5 * by_middle, by_middle + 2 * by_ring};
    for (int i = 0; i < 200; ++i) {
        auto const n = any_direction();
        auto before = uneven();
        for (int k = 0; k < cone::count; ++k) before.at[4 * k + 3] = 1;
        auto const after = cone::transferred(before, n, n);
        for (int k = 0; k < cone::count; ++k) {
            double const others = from_others[k == 0 ? 0 : 1];
            CHECK(std::abs(static_cast<double>(after.at[4 * k + 3]) - 1 - others) < 5 * 0.0006 + 0.0009);
            auto const moved = radiance_in(after, k) - radiance_in(before, k);
            for (int c = 0; c < 3; ++c) CHECK(std::abs(static_cast<double>(moved[c])) < 9 * (others / (1 + others) + 0.003));
        }
    }
}
