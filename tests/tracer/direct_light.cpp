#include <tracer/emitter.hpp>
#include <tracer/lighting.hpp>
#include <tracer/math.hpp>
#include <tracer/polygon.hpp>
#include <tracer/sampler.hpp>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace quell::tracer;

namespace {

Emitter rectangle_light(glm::vec3 centre, glm::vec3 half_u, glm::vec3 half_v) {
    Emitter light;
    light.radiance = glm::vec3{1.f};
    light.corner_count = 4;
    light.corners = {centre - half_u - half_v, centre + half_u - half_v, centre + half_u + half_v, centre - half_u + half_v};
    light.corners_before = light.corners;
    return light;
}

Emitter sphere_light(glm::vec3 centre, float radius) {
    Emitter light;
    light.radiance = glm::vec3{1.f};
    light.centre = light.centre_before = centre;
    light.radius = radius;
    return light;
}

glm::vec2 random_pair(std::uint32_t i) { return sample_pair({{3, 7}, i, 99}, SampleUse::light_point); }

/// Irradiance by adding up points of the light's surface.
double by_area(Emitter const& light, glm::vec3 position, glm::vec3 normal, std::uint32_t count) {
    auto const u = light.corners[1] - light.corners[0], v = light.corners[3] - light.corners[0], plane = glm::cross(u, v);
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        auto const random = random_pair(i);
        auto const offset = light.corners[0] + u * random.x + v * random.y - position;
        double const distance2 = glm::dot(offset, offset);
        sum += std::max(0.f, glm::dot(offset, normal)) * std::max(0.f, -glm::dot(offset, plane)) / (distance2 * distance2);
    }
    return sum / count;
}

/// Irradiance by adding up directions of the hemisphere that meet the sphere.
double by_direction(Emitter const& light, glm::vec3 position, glm::vec3 normal, std::uint32_t count) {
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        auto const direction = cosine_direction(normal, random_pair(i));
        auto const offset = light.centre - position;
        float const along = glm::dot(offset, direction), miss2 = glm::dot(offset, offset) - along * along;
        met += along > 0 && miss2 < light.radius * light.radius ? 1 : 0;
    }
    return std::numbers::pi * met / count;
}

} // namespace

TEST_CASE("angle over sine") {
    for (double angle = 0.001; angle < 3.1; angle += 0.0137)
        CHECK(static_cast<double>(angle_over_sine(static_cast<float>(std::cos(angle)))) ==
              doctest::Approx(angle / std::sin(angle)).epsilon(angle < 2.9 ? 2e-6 : 2e-4));
    CHECK(angle_over_sine(1.f) == doctest::Approx(1));
    CHECK(std::isfinite(angle_over_sine(-1.f)));
}

TEST_CASE("irradiance from a rectangle equals a sum over its points") {
    glm::vec3 const up{0, 1, 0}, position{0.2f, 0, 0.1f};
    // Above, shifted aside, upright and half below the horizon, far away, very close.
    Emitter const lights[] = {rectangle_light({0, 2, 0}, {0, 0, 0.5f}, {1, 0, 0}), rectangle_light({3, 1.5f, 1}, {0, 0, 0.5f}, {1, 0, 0}),
                              rectangle_light({1, 0, 0}, {0, 0.6f, 0}, {0, 0, -1}), rectangle_light({10, 30, 4}, {0, 0, 1}, {1.5f, 0, 0}),
                              rectangle_light({0, 0.3f, 0}, {0, 0, 2}, {2, 0, 0})};
    for (auto light : lights) {
        auto const toward = position - light.corners[0];
        if (glm::dot(glm::cross(light.corners[1] - light.corners[0], light.corners[2] - light.corners[0]), toward) < 0)
            std::swap(light.corners[1], light.corners[3]);
        CHECK(irradiance(light, position, up) == doctest::Approx(by_area(light, position, up, 1 << 16)).epsilon(2e-3));
        std::swap(light.corners[1], light.corners[3]);
        CHECK(irradiance(light, position, up) == 0);
        light.both_sides = true;
        std::swap(light.corners[1], light.corners[3]);
        CHECK(irradiance(light, position, up) == doctest::Approx(by_area(light, position, up, 1 << 16)).epsilon(2e-3));
    }
}

TEST_CASE("a rectangle below the horizon gives nothing, an unbounded one pi") {
    glm::vec3 const up{0, 1, 0};
    auto below = rectangle_light({0, -1, 0}, {0, 0, 1}, {1, 0, 0});
    below.both_sides = true;
    CHECK(irradiance(below, {0, 0, 0}, up) == 0);
    auto ceiling = rectangle_light({0, 1, 0}, {0, 0, 1e4f}, {1e4f, 0, 0});
    ceiling.both_sides = true;
    CHECK(irradiance(ceiling, {0, 0, 0}, up) == doctest::Approx(std::numbers::pi).epsilon(1e-3));
}

TEST_CASE("irradiance from a sphere equals a sum over directions, above, across and below the horizon") {
    glm::vec3 const up = glm::normalize(glm::vec3{1, 2, -1});
    for (float degrees : {0.f, 40.f, 75.f, 85.f, 90.f, 95.f, 104.f, 120.f, 170.f}) {
        Basis const basis{up};
        float const angle = glm::radians(degrees);
        glm::vec3 const position{3, -2, 1};
        auto const light = sphere_light(position + 2.f * basis.world({std::sin(angle), 0, std::cos(angle)}), 0.6f);
        CHECK(irradiance(light, position, up) == doctest::Approx(by_direction(light, position, up, 1 << 19)).epsilon(1e-2).scale(0.01));
    }
    CHECK(irradiance(sphere_light({0, 0, 0}, 1), {0.1f, 0, 0}, up) == doctest::Approx(std::numbers::pi));
}

TEST_CASE("points on lights are distributed as their contribution") {
    glm::vec3 const up{0, 1, 0}, position{0, 0, 0};
    // The share of points in one half of the light must be that half's share of the irradiance.
    auto const compare = [&](Emitter const& whole, Emitter const& half, auto is_in_half) {
        constexpr std::uint32_t count = 1 << 15;
        std::uint32_t inside = 0;
        for (std::uint32_t i = 0; i < count; ++i)
            inside += is_in_half(sample_point(whole, position, up, random_pair(i), sample_pair({{1, 2}, i, 3}, SampleUse::light_choice).x))
                          ? 1
                          : 0;
        CHECK(static_cast<double>(inside) / count ==
              doctest::Approx(irradiance(half, position, up) / irradiance(whole, position, up)).epsilon(0.004));
    };
    for (float height : {0.4f, 1.f, 3.f, 40.f}) {
        auto const whole = rectangle_light({0.5f, height, 0}, {1, 0, 0}, {0, 0, 0.7f}),
                   half = rectangle_light({1, height, 0}, {0.5f, 0, 0}, {0, 0, 0.7f});
        compare(whole, half, [](glm::vec3 p) { return p.x > 0.5f; });
    }
    // Upright, so that the horizon cuts it.
    auto upright = rectangle_light({1, 0.2f, 0}, {0, 0, 1}, {0, 0.8f, 0}), part = rectangle_light({1, 0.75f, 0}, {0, 0, 1}, {0, 0.25f, 0});
    compare(upright, part, [](glm::vec3 p) { return p.y > 0.5f; });
}

TEST_CASE("points on lights lie on the light") {
    glm::vec3 const up{0, 1, 0};
    auto const rectangle = rectangle_light({0.3f, 1, 0.2f}, {1, 0, 0}, {0, 0, 0.5f});
    auto const sphere = sphere_light({1, 0.2f, 0}, 0.5f);
    for (std::uint32_t i = 0; i < 2000; ++i) {
        auto const on_rectangle = sample_point(rectangle, {0, 0, 0}, up, random_pair(i), 0.3f),
                   on_sphere = sample_point(sphere, {0, 0, 0}, up, random_pair(i), 0.3f);
        CHECK(std::abs(on_rectangle.y - 1) < 1e-4f);
        CHECK(std::abs(on_rectangle.x - 0.3f) < 1.001f);
        CHECK(std::abs(on_rectangle.z - 0.2f) < 0.501f);
        CHECK(glm::distance(on_sphere, sphere.centre) == doctest::Approx(0.5).epsilon(1e-3));
        CHECK(glm::dot(on_sphere - sphere.centre, sphere.centre) <= 1e-3f);
    }
}

TEST_CASE("a light's points go back to where they were") {
    auto light = rectangle_light({0, 2, 0}, {1, 0, 0}, {0, 0, 1});
    for (auto& corner : light.corners_before) corner = corner * 2.f + glm::vec3{0, 0, 3};
    CHECK(glm::distance(light.before({0.25f, 2, -0.5f}), glm::vec3{0.5f, 4, 2}) < 1e-5f);
    auto ball = sphere_light({1, 2, 3}, 0.5f);
    CHECK(ball.before({1, 2.5f, 3}) == glm::vec3{1, 2.5f, 3});
    ball.centre_before = {0, 2, 3};
    CHECK(glm::distance(ball.before({1, 2.5f, 3}), glm::vec3{0, 2.5f, 3}) < 1e-6f);
}

TEST_CASE("lights without extent give nothing and no NaN") {
    glm::vec3 const up{0, 1, 0};
    auto const flat = rectangle_light({0, 1, 0}, {0, 0, 0}, {0, 0, 0});
    CHECK(irradiance(flat, {0, 0, 0}, up) == 0);
    CHECK(std::isfinite(glm::length(sample_point(flat, {0, 0, 0}, up, {0.3f, 0.4f}, 0.5f))));
    auto const dot = sphere_light({0, 1, 0}, 0);
    CHECK(irradiance(dot, {0, 0, 0}, up) == 0);
    CHECK(std::isfinite(glm::length(sample_point(dot, {0, 0, 0}, up, {0.3f, 0.4f}, 0.5f))));
}
