#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Height of the cloth: waves across waves, so that hardly any of it is flat.
float cloth_height(float x, float z) {
    float const folds = std::sin(2.3f * x + 1.2f * std::sin(1.1f * z)) + 0.7f * std::sin(2.9f * z - 0.8f * x);
    return 0.11f * folds + 0.03f * std::sin(7 * x + 4 * z);
}

TriangleMesh cloth_mesh() {
    return surface(160, 120, [](float u, float v) {
        float const x = 9 * (u - 0.5f), z = 7 * (0.5f - v) - 0.5f;
        return glm::vec3{x, cloth_height(x, z), z};
    });
}

/// An apple of radius 1 around the origin: wide above, with a deep dent at the stem and a shallow one below.
TriangleMesh apple_mesh() {
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= 96; ++i) {
        float const angle = pi * static_cast<float>(i) / 96, out = std::sin(angle), up = -std::cos(angle);
        float const dent = std::exp(-out * out / 0.12f) * (up > 0 ? -0.42f : 0.22f);
        profile.emplace_back(out * (0.98f + 0.12f * up), 0.88f * up + dent);
    }
    return turned(profile, 128);
}

void add_apples(SceneDescription& scene) {
    int const apple = scene.add(apple_mesh()), stem = scene.add(moved(cylinder(0.035f, 0.05f, 0.55f, 12), {0, 0.4f, 0}));
    int const red = scene.paint({0.62f, 0.06f, 0.04f}), green = scene.paint({0.38f, 0.56f, 0.08f});
    int const yellow = scene.paint({0.8f, 0.58f, 0.1f}), wood = scene.paint({0.2f, 0.12f, 0.06f});
    struct Place {
        glm::vec2 place;
        float size, tilt;
        int material;
    };
    for (auto const& [place, size, tilt, material] :
         {Place{{-1.05f, 0.3f}, 0.52f, 14, red}, Place{{0.15f, -0.35f}, 0.56f, -10, green}, Place{{1.15f, 0.45f}, 0.5f, 22, red},
          Place{{-0.25f, 0.95f}, 0.42f, -24, yellow}, Place{{1.75f, -0.7f}, 0.54f, 8, yellow}, Place{{-1.95f, -0.8f}, 0.55f, -14, green}}) {
        Transform const transform{
            {place.x, cloth_height(place.x, place.y) + 0.86f * size, place.y}, turn(tilt, {0.4f, 0, 1}), glm::vec3{size}};
        scene.place(apple, material, transform);
        scene.place(stem, wood, transform);
    }
    int const ceramic = scene.paint({0.86f, 0.86f, 0.82f});
    scene.place(scene.add_sphere(), ceramic, {.translation = {0.75f, cloth_height(0.75f, 1.35f) + 0.2f, 1.35f}, .scale = glm::vec3{0.24f}});
}

} // namespace

SceneDescription apples() {
    SceneDescription scene;
    scene.place(scene.add(cloth_mesh()), scene.paint(checker({0.8f, 0.77f, 0.7f}, {0.66f, 0.58f, 0.52f}, 12)));
    scene.place(scene.add(rectangle(16, 8, {3, 1.5f})), scene.paint(plaster({0.42f, 0.5f, 0.56f})),
                {.translation = {0, 3, -4}, .rotation = upright});
    add_apples(scene);
    // The light swings over the table from one side to the other; in the middle of its way, at frame 26, it is at its fastest.
    scene.place(scene.add(rectangle(0.7f, 0.7f)), scene.glow({84, 77, 66}), [](float frame) {
        float const phase = (frame - 26) / 16;
        glm::vec3 const place{2.9f * std::sin(phase), 1.9f + 0.35f * std::cos(phase), 0.5f + 0.9f * std::sin(phase)};
        return Transform{place, facing(-place)}.matrix();
    });
    scene.background = {{0.05f, 0.05f, 0.06f}, {0.2f, 0.22f, 0.26f}};
    scene.camera = [](float) { return look_at({0, 2.7f, 4.1f}, {0, 0.1f, 0.1f}, 40); };
    return scene;
}

} // namespace quell::tracer
