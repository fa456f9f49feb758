#pragma once

#include "scene.hpp"

namespace quell::live {

/// What a reader of the page can move in a scene.
struct Moment {
    float time = 0;    ///< seconds, of all that moves by itself
    float light = 0.5; ///< where the light stands, 0 to 1
};

/// Builds a scene as it is at one moment; a scene of another moment then gives it what was before.
struct SceneBuilder {
    Scene scene;
    Moment at;

    QUELL_LIVE int plain(Vector colour) { return scene.add(Material{.colour = colour}); }
    /// A shape that no other is near.
    QUELL_LIVE int alone(int shape) {
        scene.close_group();
        return shape;
    }
    QUELL_LIVE int metal(Vector colour, float roughness) {
        return scene.add(Material{.colour = colour, .is_metal = true, .roughness = roughness});
    }
};

/// A room of 5.2 x 2.7 x 6 under a lamp that can be moved. A crate slides to and fro, with a block that turns on it.
QUELL_LIVE Scene room(Moment at) {
    SceneBuilder b{{}, at};
    auto& scene = b.scene;
    int const walls = scene.add(Material{.colour = {0.8f, 0.78f, 0.74f}, .pattern = Pattern::room});
    int const parquet =
        scene.add(Material{.colour = {0.5f, 0.3f, 0.16f}, .pattern = Pattern::planks, .scale = 3.2f, .roughness = 0.08f, .coat = 0.05f});
    int const panel = scene.add(Material{.emission = {24, 21.5f, 18}}), bulb = scene.add(Material{.emission = {16, 8, 3.2f}});
    int const wood = scene.add(Material{.colour = {0.62f, 0.42f, 0.22f}, .pattern = Pattern::planks, .scale = 7});
    int const steel = b.metal({0.9f, 0.9f, 0.9f}, 0.02f), gold = b.metal({1, 0.74f, 0.36f}, 0.3f);
    int const rubber = b.plain({0.12f, 0.16f, 0.5f}),
              china = scene.add(Material{.colour = {0.72f, 0.78f, 0.86f}, .roughness = 0.05f, .coat = 0.06f});
    int const crate =
        scene.add(Material{.colour = {0.85f, 0.68f, 0.2f}, .second = {0.14f, 0.16f, 0.2f}, .pattern = Pattern::checker, .scale = 5.7143f});
    int const toy = b.plain({0.25f, 0.7f, 0.3f});

    b.alone(scene.add_box({5.2f, 2.7f, 6}, {0, 1.35f, 0}, walls));
    b.alone(scene.add_box({5.2f, 0.04f, 6}, {0, 0, 0}, parquet));
    int const lamp = b.alone(scene.add_box({1.4f, 0.04f, 0.9f}, {-1.6f + 3.2f * at.light, 2.66f, 0.1f}, panel));
    int const globe = scene.add_sphere(0.16f, {-1.85f, 1.0f, -2.1f}, bulb);
    scene.add_box({1.3f, 0.06f, 0.8f}, {-1.7f, 0.75f, -2.1f}, wood);
    scene.add_box({0.06f, 0.72f, 0.7f}, {-2.25f, 0.36f, -2.1f}, wood);
    scene.add_box({0.06f, 0.72f, 0.7f}, {-1.15f, 0.36f, -2.1f}, wood);
    scene.add_sphere(0.17f, {-1.35f, 0.95f, -1.95f}, china);
    scene.close_group();
    b.alone(scene.add_sphere(0.42f, {-1.75f, 0.44f, -0.4f}, steel));
    scene.add_sphere(0.34f, {1.9f, 0.36f, -2.1f}, gold);
    scene.add_sphere(0.2f, {1.2f, 0.22f, -1.55f}, rubber);
    scene.close_group();
    scene.add_box({1.5f, 0.05f, 0.3f}, {1.1f, 1.45f, -2.84f}, wood);
    constexpr Vector covers[] = {
        {0.6f, 0.15f, 0.12f}, {0.15f, 0.35f, 0.55f}, {0.75f, 0.6f, 0.2f}, {0.2f, 0.45f, 0.25f}, {0.45f, 0.2f, 0.45f}};
    for (int i = 0; i < 5; ++i) {
        float const height = 0.3f + 0.04f * static_cast<float>(i * 53 % 4);
        scene.add_box({0.11f, height, 0.22f}, {0.6f + 0.14f * static_cast<float>(i), 1.475f + height / 2, -2.84f}, b.plain(covers[i]));
    }
    scene.close_group();
    float const phase = 0.9f * at.time, x = 1.1f * sinf(phase), turned = 0.35f + 0.45f * sinf(phase);
    scene.add_box({0.7f, 0.7f, 0.7f}, {x, 0.37f, -0.3f}, crate, turned);
    scene.add_box({0.26f, 0.26f, 0.26f}, {x, 0.85f, -0.3f}, toy, 1.7f * at.time);
    scene.close_group();
    scene.add(Light{LightKind::rectangle, lamp, 0.8f});
    scene.add(Light{LightKind::sphere, globe, 0.2f});
    return scene;
}

/// A court before a wall with pillars, under a sun that can be moved. A cart goes round a mirror ball; a gate swings.
QUELL_LIVE Scene court(Moment at) {
    SceneBuilder b{{}, at};
    auto& scene = b.scene;
    int const tiles =
        scene.add(Material{.colour = {0.6f, 0.55f, 0.47f}, .second = {0.44f, 0.4f, 0.35f}, .pattern = Pattern::checker, .scale = 1.25f});
    int const stone = b.plain({0.72f, 0.68f, 0.6f});
    int const brick =
        scene.add(Material{.colour = {0.6f, 0.27f, 0.18f}, .second = {0.6f, 0.57f, 0.52f}, .pattern = Pattern::bricks, .scale = 5});
    int const wood = scene.add(Material{.colour = {0.42f, 0.27f, 0.15f}, .pattern = Pattern::planks, .scale = 4});
    int const leaves = b.plain({0.16f, 0.34f, 0.09f}), mirror = b.metal({0.92f, 0.92f, 0.92f}, 0);
    int const red = scene.add(Material{.colour = {0.7f, 0.09f, 0.06f}, .roughness = 0.03f, .coat = 0.05f}),
              black = b.plain({0.05f, 0.05f, 0.06f});

    b.alone(scene.add_box({60, 0.2f, 60}, {0, -0.1f, 0}, tiles));
    scene.add_box({9, 3.2f, 0.3f}, {0, 1.6f, -3.4f}, brick);
    scene.add_box({9, 0.18f, 1.9f}, {0, 2.75f, -2.4f}, wood);
    for (int i = 0; i < 5; ++i) scene.add_box({0.26f, 2.66f, 0.26f}, {-3.6f + 1.8f * static_cast<float>(i), 1.33f, -1.65f}, stone);
    scene.close_group();
    scene.add_box({1.1f, 0.5f, 1.1f}, {-3.3f, 0.25f, 0.9f}, stone);
    scene.add_sphere(0.62f, {-3.3f, 0.95f, 0.9f}, leaves);
    scene.close_group();
    scene.add_box({1.1f, 0.5f, 1.1f}, {3.4f, 0.25f, 0.6f}, stone);
    scene.add_sphere(0.55f, {3.4f, 0.9f, 0.6f}, leaves);
    scene.close_group();
    scene.add_box({0.7f, 0.3f, 0.7f}, {0, 0.15f, 0.4f}, stone);
    scene.add_sphere(0.5f, {0, 0.8f, 0.4f}, mirror);
    scene.close_group();

    float const round = 0.6f * at.time, sine = sinf(round), cosine = cosf(round);
    Vector const cart{1.75f * cosine, 0, 0.4f + 1.75f * sine};
    scene.add_box({0.55f, 0.34f, 0.9f}, {cart.x, 0.32f, cart.z}, red, -round);
    scene.add_box({0.5f, 0.26f, 0.4f}, {cart.x, 0.62f, cart.z}, red, -round);
    scene.add_box({0.62f, 0.16f, 0.7f}, {cart.x, 0.08f, cart.z}, black, -round);
    scene.close_group();
    float const swing = 1.1f + 0.9f * sinf(0.8f * at.time);
    scene.add_box({1.3f, 1.7f, 0.07f}, {2.4f + 0.65f * cosf(swing), 0.9f, 1.9f - 0.65f * sinf(swing)}, wood, swing);
    scene.add_box({0.14f, 1.9f, 0.14f}, {2.4f, 0.95f, 1.9f}, stone);
    scene.close_group();

    float const way = pi * (0.14f + 0.72f * at.light), height = sinf(way);
    scene.sky = {.zenith = {0.22f, 0.42f, 0.85f},
                 .horizon = {0.75f, 0.85f, 1},
                 .sun = {},
                 .towards_sun = normalized({cosf(way), 0.7f * height, 0.6f})};
    scene.sky.sun_cosine = cosf(0.02f), scene.sky.towards_sun_before = scene.sky.towards_sun;
    float const low = 1 - height;
    scene.sky.sun = Vector{1, 0.92f - 0.3f * low, 0.8f - 0.5f * low} * 3600;
    scene.add(Light{LightKind::sun, -1, 1});
    return scene;
}

constexpr int scene_count = 2;

QUELL_LIVE Scene scene_by_number(int number, Moment at) { return number == 1 ? court(at) : room(at); }

/// How the camera starts in each scene.
QUELL_LIVE Orbit first_orbit(int number) {
    return number == 1 ? Orbit{{0, 0.9f, -0.5f}, 0.35f, 0.22f, 6.2f, 0.75f} : Orbit{{-0.1f, 0.95f, -0.9f}, 0.12f, 0.1f, 3.55f, 0.9f};
}

/// The orbit in reach: above the ground, and in the room within its walls.
QUELL_LIVE Orbit within_reach(int number, Orbit orbit) {
    orbit.pitch = smaller(1.3f, larger(number == 1 ? -0.12f : -0.22f, orbit.pitch));
    if (number == 1) {
        orbit.distance = smaller(14, larger(2.5f, orbit.distance));
    } else {
        Vector const half{2.5f, 1.25f, 2.9f}, middle{0, 1.35f, 0};
        float const wall = distance_to_box(orbit.target - middle, inverse(towards_eye(orbit)), half);
        orbit.distance = smaller(wall, larger(0.8f, orbit.distance));
    }
    return orbit;
}

/// A scene with what it was one frame ago.
QUELL_LIVE Scene moving_scene(int number, Moment now, Moment before) {
    Scene scene = scene_by_number(number, now);
    Scene const then = scene_by_number(number, before);
    for (int i = 0; i < scene.shape_count; ++i) scene.shapes[i].before = then.shapes[i].now;
    scene.sky.towards_sun_before = then.sky.towards_sun;
    return scene;
}

} // namespace quell::live
