#include "outdoors.hpp"
#include "../patterns.hpp"
#include "../shapes.hpp"
#include "turn.hpp"

namespace quell::tracer {
namespace {

bool is_within(glm::vec2 place, glm::vec2 least, glm::vec2 most) {
    return place.x > least.x && place.y > least.y && place.x < most.x && place.y < most.y;
}

/// A window with shutters in a cell of a wall, v upwards; what is no window stays as it is.
glm::vec3 with_window(glm::vec3 wall, glm::vec3 shutters, glm::vec2 place) {
    if (is_within(place, {0.3f, 0.2f}, {0.7f, 0.8f})) {
        bool const is_bar = std::abs(place.x - 0.5f) < 0.02f || std::abs(place.y - 0.52f) < 0.02f;
        bool const is_frame = !is_within(place, {0.34f, 0.24f}, {0.66f, 0.76f});
        return is_bar || is_frame ? glm::vec3{0.8f} : glm::mix(glm::vec3{0.05f, 0.07f, 0.1f}, glm::vec3{0.25f, 0.35f, 0.45f}, place.y);
    }
    if (is_within(place, {0.26f, 0.14f}, {0.74f, 0.2f})) return glm::vec3{0.55f};
    bool const is_shutter = is_within(place, {0.1f, 0.2f}, {0.28f, 0.8f}) || is_within(place, {0.72f, 0.2f}, {0.9f, 0.8f});
    return is_shutter ? shutters * (glm::fract(place.y * 14) < 0.3f ? 0.5f : 1.f) : wall;
}

Texture facade(glm::vec3 wall, glm::vec3 shutters, int columns, int floors) {
    return painted(256, 256, [=](glm::vec2 uv) {
        auto const plaster = wall * (0.8f + 0.4f * fractal_noise(uv, 8, 5));
        auto const place = uv * glm::vec2{static_cast<float>(columns), static_cast<float>(floors)};
        // Quoins at the corners and a dark plinth.
        if (uv.y < 0.06f) return glm::vec3{0.3f, 0.28f, 0.26f} * (0.7f + 0.6f * fractal_noise(uv, 16, 4));
        if (std::min(uv.x, 1 - uv.x) < (glm::fract(uv.y * 9) < 0.5f ? 0.05f : 0.03f)) return plaster * 0.6f;
        return with_window(plaster, shutters, glm::fract(place));
    });
}

Texture foliage() {
    return painted(256, 256, [](glm::vec2 uv) {
        float const leaf = fractal_noise(uv, 32, 3), shade = fractal_noise(uv, 6, 3, 4);
        return glm::mix(glm::vec3{0.03f, 0.08f, 0.02f}, glm::vec3{0.3f, 0.45f, 0.1f},
                        glm::smoothstep(0.3f, 0.75f, 0.7f * leaf + 0.3f * shade));
    });
}

} // namespace

void add_daylight(SceneDescription& scene, glm::vec3 sun_direction, float degrees) {
    constexpr float distance = 900;
    float const sine = std::sin(degrees / 2 * pi / 180), radius = distance * sine;
    glm::vec3 const irradiance{2.7f, 2.45f, 2.05f};
    auto const radiance = irradiance / (pi * sine * sine);
    scene.place(scene.add_sphere(), scene.glow(radiance),
                {.translation = glm::normalize(sun_direction) * distance, .scale = glm::vec3{radius}});
    scene.background = {{0.22f, 0.21f, 0.2f}, {0.4f, 0.62f, 1}};
}

TriangleMesh column_mesh() {
    auto mesh = moved(box({0.72f, 0.16f, 0.72f}), {0, 0.22f, 0});
    mesh = joined(std::move(mesh), moved(torus(0.26f, 0.07f, 32, 12), {0, 0.36f, 0}));
    // Fluted: the radius dips twelve times around.
    auto const shaft = surface(96, 8, [](float u, float v) {
        float const radius = (0.27f - 0.05f * v) * (1 - 0.06f * std::abs(std::sin(12 * pi * u)));
        return glm::vec3{radius * std::sin(2 * pi * u), 0.4f + 2.7f * v, radius * std::cos(2 * pi * u)};
    });
    mesh = joined(std::move(mesh), shaft);
    mesh = joined(std::move(mesh), moved(torus(0.23f, 0.06f, 32, 12), {0, 3.12f, 0}));
    return joined(std::move(mesh), moved(box({0.7f, 0.14f, 0.7f}), {0, 3.24f, 0}));
}

Town::Town(SceneDescription& scene)
    : town(scene), wall(scene.add(rectangle(1, 1))), roof(scene.add(cylinder(0.74f, 0, 1, 4))),
      trunk(scene.add(cylinder(0.06f, 0.04f, 0.5f, 12))), crown(scene.add_sphere()),
      shingles(scene.paint(bricks({0.5f, 0.2f, 0.13f}, {0.2f, 0.09f, 0.06f}, 16))), bark(scene.paint({0.2f, 0.13f, 0.08f})),
      leaves(scene.paint(foliage())) {
    for (auto const& texture :
         {facade({0.78f, 0.7f, 0.52f}, {0.12f, 0.3f, 0.2f}, 3, 3), facade({0.7f, 0.42f, 0.3f}, {0.75f, 0.72f, 0.65f}, 4, 3),
          facade({0.8f, 0.78f, 0.74f}, {0.2f, 0.25f, 0.5f}, 2, 3), facade({0.5f, 0.58f, 0.6f}, {0.5f, 0.12f, 0.08f}, 3, 4)})
        facades.push_back(scene.paint(texture));
}

void Town::add_house(glm::vec3 place, float degrees, glm::vec3 size, int style) {
    int const house = town.add_node(fixed({.translation = place, .rotation = turn(degrees, {0, 1, 0})}));
    int const facade = facades[static_cast<std::size_t>(style) % facades.size()];
    for (float side : {-1.f, 1.f}) {
        auto const front = turn(side > 0 ? 0.f : 180.f, {0, 1, 0}) * upright, flank = turn(side * 90, {0, 1, 0}) * upright;
        town.place(wall, facade, {{0, size.y / 2, side * size.z / 2}, front, {size.x, 1, size.y}}, house);
        town.place(wall, facade, {{side * size.x / 2, size.y / 2, 0}, flank, {size.z, 1, size.y}}, house);
    }
    // A pyramid's corners lie on the axes: it is turned, stretched, and so has to be stretched by the house's own axes.
    int const top = town.add_node(fixed({.translation = {0, size.y, 0}, .scale = {size.x * 1.04f, size.y * 0.35f, size.z * 1.04f}}), house);
    town.place(roof, shingles, {.rotation = turn(45, {0, 1, 0})}, top);
}

void Town::add_tree(glm::vec3 place, float height) {
    int const tree = town.add_node(fixed({.translation = place, .rotation = turn(place.x * 70, {0, 1, 0}), .scale = glm::vec3{height}}));
    town.place(trunk, bark, {}, tree);
    town.place(crown, leaves, {.translation = {0, 0.62f, 0}, .scale = {0.27f, 0.3f, 0.26f}}, tree);
    town.place(crown, leaves, {.translation = {0.16f, 0.5f, 0.08f}, .rotation = turn(80, {1, 0, 1}), .scale = glm::vec3{0.17f}}, tree);
    town.place(crown, leaves, {.translation = {-0.15f, 0.54f, 0.1f}, .rotation = turn(130, {1, 1, 0}), .scale = glm::vec3{0.15f}}, tree);
}

} // namespace quell::tracer
