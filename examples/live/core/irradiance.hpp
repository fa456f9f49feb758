#pragma once

#include "lights.hpp"

namespace quell::live {

/// What a surface gets of a cone of even radiance 1: of a sphere or the sun. Snyder's integral (1996) where the horizon cuts the cone.
/// @param cosine of the angle between the surface's normal and the cone's axis
/// @param sine2  squared sine of the angle about the axis, below 1
QUELL_LIVE float irradiance_of_cone(float cosine, float sine2) {
    if (cosine * cosine >= sine2) return cosine > 0 ? pi * sine2 * cosine : 0;
    float const sine = sqrtf(larger(0, 1 - cosine * cosine)), cotangent = sqrtf(1 / sine2 - 1);
    float const y = smaller(1, larger(-1, -cotangent * cosine / sine)), chord = sine * sqrtf(1 - y * y);
    return larger(0, (cosine * acosf(y) - cotangent * chord) * sine2 + atan2f(chord, cotangent));
}

/// Part of the irradiance of a polygon: the angle that an edge is seen in, by how far its plane faces the normal. Lambert's formula.
QUELL_LIVE float edge_part(Vector a, Vector b, Vector normal) {
    auto const across = cross(a, b);
    float const sine = length(across);
    return sine > 0 ? dot(across, normal) * (atan2f(sine, dot(a, b)) / sine) : 0;
}

/// What a surface gets of the lower side of a box of even radiance 1.
QUELL_LIVE float irradiance_of_rectangle(Shape const& shape, Vector from, Vector normal) {
    float const low = -shape.half.y;
    if (shape.now.to_local(from).y >= low) return 0;
    auto const corner = [&](float x, float z) { return shape.now.to_world({x * shape.half.x, low, z * shape.half.z}) - from; };
    Vector const corners[] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    Vector sinks, rises; // where the outline crosses the horizon
    float sum = 0;
    for (int i = 0; i < 4; ++i) {
        auto a = corners[i], b = corners[(i + 1) % 4];
        float const a_height = dot(a, normal), b_height = dot(b, normal);
        if (a_height <= 0 && b_height <= 0) continue;
        auto const crossing = mix(a, b, a_height / (a_height - b_height));
        if (a_height <= 0) a = rises = crossing;
        if (b_height <= 0) b = sinks = crossing;
        sum += edge_part(a, b, normal);
    }
    return fabsf(sum + edge_part(sinks, rises, normal)) * 0.5f;
}

/// The cone that a round light is seen in.
struct Cone {
    Vector axis{};   ///< unit vector
    float cosine{};  ///< of the angle about it
    Vector radiance; ///< in all of it
};
QUELL_LIVE Cone cone_of(Scene const& scene, Light const& light, Vector from) {
    if (light.kind == LightKind::sun) return {scene.sky.towards_sun, scene.sky.sun_cosine, scene.sky.sun};
    auto const& shape = scene.shapes[light.shape];
    auto const to = shape.now.centre - from;
    float const distance = length(to), sine = smaller(1, shape.half.x / distance);
    return {to * (1 / distance), sqrtf(1 - sine * sine), scene.materials[shape.material].emission};
}

/// What a surface gets of a light if nothing is in between, without noise.
QUELL_LIVE Vector irradiance_of(Scene const& scene, Light const& light, Vector from, Vector normal) {
    if (light.kind == LightKind::rectangle) {
        auto const& shape = scene.shapes[light.shape];
        return scene.materials[shape.material].emission * irradiance_of_rectangle(shape, from, normal);
    }
    auto const cone = cone_of(scene, light, from);
    if (cone.cosine <= 0) return {};
    return cone.radiance * irradiance_of_cone(dot(cone.axis, normal), 1 - cone.cosine * cone.cosine);
}

} // namespace quell::live
