#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Long enough for the fast camera to pass by.
constexpr float length = 190;

/// Columns in a row along x, unevenly spaced, so that no row looks the same again after a step.
void add_row(SceneDescription& scene, int column, std::vector<int> const& stones, float z, float spacing) {
    float x = -length / 2;
    for (int i = 0; x < length / 2; ++i) {
        scene.place(column, stones[static_cast<std::size_t>(i * 5 % 7) % stones.size()],
                    {.translation = {x, 0, z}, .rotation = turn(31 * x, {0, 1, 0})});
        x += spacing * (0.8f + 0.4f * static_cast<float>(i * 4 % 9) / 9);
    }
}

void add_hall(SceneDescription& scene) {
    int const pale = scene.paint(marble({0.84f, 0.79f, 0.7f}, {0.5f, 0.43f, 0.36f}));
    int const rose = scene.paint(marble({0.8f, 0.58f, 0.48f}, {0.45f, 0.26f, 0.22f}));
    int const green = scene.paint(marble({0.3f, 0.46f, 0.38f}, {0.75f, 0.76f, 0.7f}));
    int const paving = scene.paint(tiles({0.6f, 0.52f, 0.42f}, {0.22f, 0.2f, 0.18f}, 6)), column = scene.add(column_mesh());
    add_row(scene, column, {green, rose, pale}, 0, 4.1f);
    add_row(scene, column, {pale}, -3.4f, 3.1f);
    add_row(scene, column, {rose, pale}, -8, 3.3f);
    for (float z : {-3.4f, -8.f}) scene.place(scene.add(box({length, 0.5f, 0.75f}, 0.4f)), pale, {.translation = {0, 3.56f, z}});
    scene.place(scene.add(rectangle(length, 14, {length / 4, 3.5f})), paving, {.translation = {0, 0.14f, -4}});
}

void add_garden(SceneDescription& scene) {
    Town town{scene};
    int const grass = scene.paint(plaster({0.2f, 0.33f, 0.1f}));
    int const wall = scene.paint(bricks({0.62f, 0.48f, 0.36f}, {0.66f, 0.62f, 0.56f}, 8));
    scene.place(scene.add(rectangle(length, 20, {length / 5, 4})), grass, {.translation = {0, 0, -20}});
    scene.place(scene.add(rectangle(length, 2.6f, {length / 5.2f, 0.5f})), wall, {.translation = {0, 1.3f, -19}, .rotation = upright});
    for (int i = 0; i < 44; ++i) {
        float const x = -length / 2 + 4.4f * static_cast<float>(i) + static_cast<float>(i * 7 % 5);
        town.add_tree({x, 0, -14.5f - static_cast<float>(i * 3 % 4)}, 2.6f + 0.5f * static_cast<float>(i * 5 % 6));
        if (i % 3 == 0) town.add_house({x, 0, -25}, static_cast<float>(i * 11 % 23 - 11), {4.5f, 4 + static_cast<float>(i % 4), 4}, i / 3);
    }
}

/// `speed`: of the camera, in units per frame.
SceneDescription colonnade_past(float speed) {
    SceneDescription scene;
    scene.secondary_rays = false;
    add_daylight(scene, {0.6f, 0.9f, 1});
    add_hall(scene);
    add_garden(scene);
    scene.camera = [speed](float frame) {
        float const x = speed * (frame - 32 + 1.2f * std::sin(frame / 13));
        return look_at({x, 1.75f, 3.1f}, {x, 1.85f, -8}, 50);
    };
    return scene;
}

} // namespace

SceneDescription colonnade() { return colonnade_past(1.55f); }
SceneDescription colonnade_slow() { return colonnade_past(0.14f); }

} // namespace quell::tracer
