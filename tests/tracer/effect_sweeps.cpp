#include "worlds.hpp"

#include <tracer/scenes/scenes.hpp>
#include <tracer/scenes/turn.hpp>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{64, 48};
using Wanted = Channels<SweepOf<Visibility>, SweepOf<Glossy>, Sweep, Time, Position, Visibility, Light, Blocker, GlossyHit, Instance>;
constexpr float frame = 5;

static_assert(SweepOf<Visibility>::name == "sweep_visibility");
static_assert(SweepOf<Glossy>::name == "sweep_glossy");
static_assert(Rays<Channels<SweepOf<Visibility>>>::shadow && !Rays<Channels<SweepOf<Visibility>>>::glossy);
static_assert(Rays<Channels<SweepOf<Glossy>>>::glossy && !Rays<Channels<SweepOf<Glossy>>>::reflected_radiance);
static_assert(!Rays<Channels<Sweep, SweepBend, Time>>::shadow && !Rays<Channels<Sweep, SweepBend, Time>>::glossy);

/// A ground in y = 0 with a plate above it and a light above both, each with a velocity (per frame).
struct Velocities {
    glm::vec3 ground{0.f}, plate{0.f}, light{0.f}, camera{0.f};
};

Pose moving_at(glm::vec3 place, glm::vec3 velocity, glm::quat rotation = {1, 0, 0, 0}) {
    return [=](float time) { return Transform{place + velocity * (time - frame), rotation}.matrix(); };
}

constexpr int ground_instance = 1;

SceneDescription yard(Velocities const& velocities, Material const& ground = {}) {
    auto scene = world({0, 0, 0}, {0, 0, -1});
    scene.camera = [=](float time) {
        auto const moved = velocities.camera * (time - frame);
        return look_at(glm::vec3{0, 6, 4} + moved, moved, 45);
    };
    scene.place(scene.add(rectangle(12, 12)), scene.add(ground), moving_at({}, velocities.ground));
    scene.place(scene.add(box({1, 0.05f, 1})), scene.add(Material{}), moving_at({0.3f, 1, 0}, velocities.plate));
    scene.place(scene.add(rectangle(0.3f, 0.3f)), scene.add(Material{.emission = glm::vec3{900.f}}),
                moving_at({-2, 9, 1}, velocities.light, turn(180, {1, 0, 0})));
    return scene;
}

Pictures<Wanted> rendered(SceneDescription scene) {
    return pictures_of<Wanted>(std::move(scene), {.size = size, .frame = static_cast<int>(frame), .shutter = 1});
}

/// Where a point that moves at an even speed appears at a time of the shutter, given where it is at time t.
glm::vec2 shown(SceneDescription const& scene, glm::vec3 at_t, glm::vec3 velocity, float t, float time) {
    return projected(scene.camera_at(frame + time, size), at_t + velocity * (time - t), size);
}

void for_each_pixel(auto&& f) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) f(x, y);
}

void check_shadows(Velocities const& velocities) {
    auto const scene = yard(velocities);
    auto const pictures = rendered(scene);
    int shadowed = 0, lit = 0;
    for_each_pixel([&](int x, int y) {
        if (pixel(pictures[instance], x, y).x != ground_instance) return;
        auto const found = glm::vec2(pixel(pictures[SweepOf<Visibility>{}], x, y)), own = glm::vec2(pixel(pictures[sweep], x, y));
        if (pixel(pictures[visibility], x, y).x > 0) {
            CHECK(found == own);
            ++lit;
            return;
        }
        float const t = pixel(pictures[quell::time], x, y).x;
        auto const place = [&](float time) {
            auto const light = pixel(pictures[Light{}], x, y) + velocities.light * (time - t);
            auto const blocker = pixel(pictures[Blocker{}], x, y) + velocities.plate * (time - t);
            float const height = velocities.ground.y * time; // it starts at 0
            auto const shadow = light + (blocker - light) * ((height - light.y) / (blocker.y - light.y));
            return projected(scene.camera_at(frame + time, size), shadow, size);
        };
        CHECK(glm::distance(found, place(1) - place(0)) < 0.02f);
        ++shadowed;
    });
    CHECK(shadowed > 20);
    CHECK(lit > 500);
}

} // namespace

TEST_CASE("the shadow of what moves is swept over its receiver") { check_shadows({.plate = {1.1f, 0, 0.3f}}); }
TEST_CASE("a blocker that comes down sweeps its shadow towards itself") { check_shadows({.plate = {0, -0.5f, 0}}); }
TEST_CASE("a light that moves sweeps the shadows of what stands still") { check_shadows({.light = {3, 0.5f, -1}}); }
TEST_CASE("shadows on a receiver that moves") { check_shadows({.ground = {0.4f, 0, 0.7f}}); }
TEST_CASE("shadows on a receiver that rises") { check_shadows({.ground = {0.2f, 0.3f, 0}}); }
TEST_CASE("everything moves before a moving camera") {
    check_shadows({.ground = {0, 0.2f, 0.3f}, .plate = {0.7f, 0.2f, 0}, .light = {0, 1, 2}, .camera = {-0.5f, 0.2f, 0}});
}

TEST_CASE("before a moving camera shadows of what stands still sweep as the ground does") {
    auto const pictures = rendered(yard({.camera = {0.8f, 0, 0.2f}}));
    for_each_pixel([&](int x, int y) {
        auto const found = glm::vec2(pixel(pictures[SweepOf<Visibility>{}], x, y));
        CHECK(glm::distance(found, glm::vec2(pixel(pictures[sweep], x, y))) < 0.01f);
    });
}

TEST_CASE("a reflection is swept as the mirror image of what moves") {
    Material const mirror{.base = glm::vec3{1.f}, .metallic = 1, .roughness = 0};
    for (auto const& velocities : {Velocities{.plate = {1.1f, 0.4f, -0.5f}}, Velocities{.plate = {0.6f, 0, 0}, .camera = {0, 0.3f, 0.7f}},
                                   Velocities{.ground = {0.9f, 0, 0.2f}, .plate = {0.1f, 0.3f, 0}}}) {
        auto const scene = yard(velocities, mirror);
        auto const pictures = rendered(scene);
        int reflected = 0, misses = 0;
        for_each_pixel([&](int x, int y) {
            if (pixel(pictures[instance], x, y).x != ground_instance) return;
            auto const found = glm::vec2(pixel(pictures[SweepOf<Glossy>{}], x, y));
            auto const hit = pixel(pictures[glossy_hit], x, y);
            if (!is_finite(hit)) {
                CHECK(found == glm::vec2(pixel(pictures[sweep], x, y)));
                ++misses;
                return;
            }
            if (hit.y > 3) return; // the light
            float const t = pixel(pictures[quell::time], x, y).x;
            glm::vec3 const upside_down{1, -1, 1};
            auto const at = [&](float time) { return shown(scene, hit * upside_down, velocities.plate * upside_down, t, time); };
            CHECK(glm::distance(found, at(1) - at(0)) < 0.02f);
            ++reflected;
        });
        CHECK(reflected > 20);
        CHECK(misses > 500);
    }
}

TEST_CASE("what is neither shadowed nor reflecting, and the sky, has the sweep of its surface for all effects") {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    scene.camera = [](float time) { return look_at({0.3f * time, 0, 4}, {0.5f * time, 0, 0}, 40); };
    scene.place(scene.add_sphere(), scene.add(Material{.metallic = 1}), moving_at({}, {0.5f, 0, 0}));
    auto const pictures = rendered(std::move(scene));
    CHECK(pictures[SweepOf<Visibility>{}].pixels == pictures[sweep].pixels);
    CHECK(pictures[SweepOf<Glossy>{}].pixels == pictures[sweep].pixels);
}

TEST_CASE("where nothing moves no effect does, exactly") {
    auto const pictures = rendered(yard({}, Material{.base = glm::vec3{1.f}, .metallic = 0.5f, .roughness = 0.3f}));
    for (auto const& value : pictures[SweepOf<Visibility>{}].pixels) CHECK(value == glm::vec3{0.f});
    for (auto const& value : pictures[SweepOf<Glossy>{}].pixels) CHECK(value == glm::vec3{0.f});
}

TEST_CASE("in flyby a shadow and a reflection sweep over what stands still") {
    PreparedScene scene{built_in_scene("flyby")};
    Pictures<Wanted> pictures{{96, 54}};
    render<Wanted>(scene, {.size = {96, 54}, .frame = 32, .shutter = 0.5f}, pictures);
    int shadows = 0, reflections = 0;
    for (std::size_t i = 0; i < pictures[sweep].pixels.size(); ++i) {
        bool const still = glm::length(pictures[sweep].pixels[i]) == 0;
        shadows += still && glm::length(pictures[SweepOf<Visibility>{}].pixels[i]) * 5 > 25 ? 1 : 0;
        reflections += still && glm::length(pictures[SweepOf<Glossy>{}].pixels[i]) * 5 > 15 ? 1 : 0;
    }
    CHECK(shadows > 25);
    CHECK(reflections > 12);
}
