#pragma once

#include "scene.hpp"

namespace quell::live {

/// A direction to a light, and what comes from there if nothing is between.
struct LightSample {
    Vector direction{}; ///< unit vector
    float distance = 0; ///< to the light
    Vector weighted{};  ///< radiance over the density of such directions; black: none comes
    int shape = -1;     ///< the light's
};

/// A unit vector that is at an angle to another one.
QUELL_LIVE Vector turned_away(Vector axis, float cosine, Turn around) {
    Vector const other = fabsf(axis.x) > 0.7f ? Vector{0, 1, 0} : Vector{1, 0, 0};
    auto const across = normalized(cross(axis, other)), along = cross(axis, across);
    float const sine = sqrtf(larger(0, 1 - cosine * cosine));
    return axis * cosine + across * (sine * around.cosine) + along * (sine * around.sine);
}

/// Towards an even choice of directions within a cone.
QUELL_LIVE Vector in_cone(Vector axis, float least_cosine, Random& random) {
    float const cosine = 1 - random.next() * (1 - least_cosine);
    return turned_away(axis, cosine, turn_by(random.next()));
}

QUELL_LIVE LightSample towards_rectangle(Shape const& shape, Vector emission, Vector from, Random& random) {
    float const u = 2 * random.next() - 1, v = 2 * random.next() - 1;
    auto const to = shape.now.to_world({u * shape.half.x, -shape.half.y, v * shape.half.z}) - from;
    float const distance = length(to), cosine = to.y / distance; // it faces down
    float const area = 4 * shape.half.x * shape.half.z;
    return {to * (1 / distance), distance, emission * (larger(0, cosine) * area / (distance * distance))};
}

QUELL_LIVE LightSample towards_sphere(Shape const& shape, Vector emission, Vector from, Random& random) {
    auto const to = shape.now.centre - from;
    float const distance = length(to), sine = shape.half.x / distance;
    if (sine >= 1) return {};
    float const least_cosine = sqrtf(1 - sine * sine);
    auto const direction = in_cone(to * (1 / distance), least_cosine, random);
    return {direction, distance, emission * (2 * pi * (1 - least_cosine))};
}

/// A sample of one of the lights, as seen from a point.
QUELL_LIVE LightSample sample_lights(Scene const& scene, Vector from, Random& random) {
    if (scene.light_count == 0) return {};
    int chosen = 0;
    for (float rest = random.next(); chosen + 1 < scene.light_count && rest >= scene.lights[chosen].share; ++chosen)
        rest -= scene.lights[chosen].share;
    auto const& light = scene.lights[chosen];
    LightSample sample;
    if (light.kind == LightKind::sun) {
        sample = {in_cone(scene.sky.towards_sun, scene.sky.sun_cosine, random), nothing_hit,
                  scene.sky.sun * (2 * pi * (1 - scene.sky.sun_cosine))};
    } else {
        auto const& shape = scene.shapes[light.shape];
        auto const emission = scene.materials[shape.material].emission;
        sample = light.kind == LightKind::sphere ? towards_sphere(shape, emission, from, random)
                                                 : towards_rectangle(shape, emission, from, random);
    }
    sample.weighted = sample.weighted * (1 / light.share), sample.shape = light.shape;
    return sample;
}

/// What a surface that emits sends back along a ray. Rectangles that are sampled shine downwards alone.
QUELL_LIVE Vector emission_of(Scene const& scene, Hit const& hit) {
    for (int i = 0; i < scene.light_count; ++i)
        if (scene.lights[i].shape == hit.shape && scene.lights[i].kind == LightKind::rectangle && hit.local_outwards.y > -0.5f) return {};
    return scene.materials[scene.shapes[hit.shape].material].emission;
}

/// Whether a shape's light arrives by samples of lights.
QUELL_LIVE bool is_sampled(Scene const& scene, int shape) {
    for (int i = 0; i < scene.light_count; ++i)
        if (scene.lights[i].shape == shape) return true;
    return false;
}

} // namespace quell::live
