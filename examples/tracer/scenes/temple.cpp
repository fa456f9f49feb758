#include "parts.hpp"

namespace quell::tracer {
namespace {

constexpr int column_pairs = 9;
constexpr float spacing = 2.6f, half_width = 2.3f;

float place_of(int pair) { return 4 - spacing * static_cast<float>(pair); }

/// Slabs of polished stone, each with a roughness of its own between 0 and 0.5.
void add_floor(SceneDescription& scene) {
    int const stone = scene.add(tiles({0.52f, 0.48f, 0.42f}, {0.1f, 0.09f, 0.08f}, 8)), polish = scene.add(tile_roughness(0, 1, 8));
    int const slabs =
        scene.add(Material{.metallic = 0.65f, .roughness = 0.5f, .base_texture = stone, .metallic_roughness_texture = polish});
    scene.place(scene.add(rectangle(9.6f, 38.4f, {1, 4})), slabs, {.translation = {0, 0, -10}});
    int const step = scene.paint(marble({0.75f, 0.7f, 0.62f}, {0.45f, 0.4f, 0.36f}));
    for (float side : {-1.f, 1.f}) {
        scene.place(scene.add(box({1.5f, 0.14f, 38.4f}, 0.5f)), step, {.translation = {side * (half_width + 0.35f), 0.07f, -10}});
        scene.place(scene.add(box({0.3f, 4.6f, 38.4f}, 0.3f)), step, {.translation = {side * 4.6f, 2.3f, -10}});
    }
    scene.place(scene.add(box({9.6f, 4.6f, 0.3f}, 0.3f)), step, {.translation = {0, 2.3f, -20}});
}

void add_columns(SceneDescription& scene) {
    int const column = scene.add(column_mesh()), beam = scene.add(box({0.7f, 0.4f, 25}, 0.7f)), rafter = scene.add(box({9, 0.22f, 0.35f}));
    int const stone = scene.paint(marble({0.82f, 0.75f, 0.64f}, {0.5f, 0.42f, 0.34f})), timber = scene.paint({0.36f, 0.2f, 0.1f});
    for (float side : {-1.f, 1.f}) {
        for (int pair = 0; pair < column_pairs; ++pair) scene.place(column, stone, {.translation = {side * half_width, 0, place_of(pair)}});
        scene.place(beam, stone, {.translation = {side * half_width, 3.5f, -6.5f}});
    }
    for (int pair = 0; pair < column_pairs; ++pair) scene.place(rafter, timber, {.translation = {0, 3.85f, place_of(pair) - spacing / 2}});
}

/// Hangings between the columns, waving a little.
void add_banners(SceneDescription& scene) {
    for (int pair = 0; pair + 1 < column_pairs; ++pair)
        for (float side : {-1.f, 1.f}) {
            float const phase = static_cast<float>(pair) * 1.7f + side;
            Shape cloth;
            cloth.mesh = surface(24, 16, [](float u, float v) { return glm::vec3{0, 1.1f + 2.1f * v, (u - 0.5f) * 1.2f}; });
            cloth.deformation = [phase](float frame, TriangleMesh& mesh) {
                for (auto& point : mesh.positions)
                    point.x = 0.1f * (3.2f - point.y) * std::sin(3 * point.z + 2 * point.y + phase + 0.12f * frame);
                compute_normals(mesh);
            };
            int const colour = scene.paint(pair % 2 == 0 ? glm::vec3{0.7f, 0.08f, 0.06f} : glm::vec3{0.08f, 0.2f, 0.6f});
            scene.place(scene.add(std::move(cloth)), colour,
                        {.translation = {side * (half_width + 0.9f), 0, place_of(pair) - spacing / 2}});
        }
}

void add_lights(SceneDescription& scene) {
    int const sun = scene.glow({64, 55, 43}), fire = scene.glow({11, 4.6f, 1.3f}), bronze = scene.metal({0.8f, 0.5f, 0.25f}, 0.3f);
    scene.place(scene.add(rectangle(8, 9)), sun, {.translation = {20, 24, -2}, .rotation = turn(140, {0, 0, 1})});
    int const bowl =
        scene.add(turned({{0, 0}, {0.2f, 0}, {0.06f, 0.1f}, {0.05f, 0.6f}, {0.1f, 0.7f}, {0.26f, 0.85f}, {0.24f, 0.85f}, {0, 0.72f}}));
    for (float side : {-1.f, 1.f})
        for (int pair : {1, 4}) {
            glm::vec3 const place{side * 1.45f, 0, place_of(pair) - spacing / 2};
            scene.place(bowl, bronze, {.translation = place});
            scene.place(scene.add_sphere(), fire, {.translation = place + glm::vec3{0, 1, 0}, .scale = glm::vec3{0.15f}});
        }
}

void add_statue(SceneDescription& scene) {
    int const gold = scene.metal({1, 0.76f, 0.38f}, 0.35f), stone = scene.paint({0.25f, 0.28f, 0.3f});
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= 48; ++i) {
        float const t = static_cast<float>(i) / 48;
        profile.emplace_back((0.1f + 0.5f * (1 - t)) * (0.75f + 0.25f * std::cos(9 * t)), 1.9f * t);
    }
    scene.place(scene.add(box({1.6f, 0.5f, 1.6f})), stone, {.translation = {0, 0.25f, -13}});
    scene.place(scene.add(turned(profile)), gold, {.translation = {0, 0.5f, -13}});
    scene.place(scene.add_sphere(), gold, {.translation = {0, 2.6f, -13}, .scale = glm::vec3{0.3f}});
}

} // namespace

SceneDescription temple() {
    SceneDescription scene;
    add_floor(scene);
    add_columns(scene);
    add_banners(scene);
    add_lights(scene);
    add_statue(scene);
    scene.background = {{0.35f, 0.35f, 0.4f}, {0.45f, 0.75f, 1.3f}};
    scene.camera = [](float frame) {
        float const z = 6.5f - 0.07f * frame, sway = 0.5f * std::sin(2 * pi * frame / 160);
        return look_at({sway, 1.25f, z}, {-0.4f * sway, 0.95f, z - 5}, 55);
    };
    return scene;
}

} // namespace quell::tracer
