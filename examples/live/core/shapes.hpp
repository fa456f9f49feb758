#pragma once

#include "vector.hpp"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace quell::live {

/// Where a shape stands: its centre, turned about the y axis.
struct Pose {
    Vector centre{};            ///< world space
    float sine = 0, cosine = 1; ///< of the angle

    QUELL_LIVE Vector direction_to_local(Vector d) const { return {cosine * d.x - sine * d.z, d.y, sine * d.x + cosine * d.z}; }
    QUELL_LIVE Vector direction_to_world(Vector d) const { return {cosine * d.x + sine * d.z, d.y, cosine * d.z - sine * d.x}; }
    QUELL_LIVE Vector to_local(Vector p) const { return direction_to_local(p - centre); }
    QUELL_LIVE Vector to_world(Vector p) const { return centre + direction_to_world(p); }
};

QUELL_LIVE Pose posed(Vector centre, float turned = 0) { return {centre, sinf(turned), cosf(turned)}; }

/// A sphere or a box. From inside, a box is a room.
struct Shape {
    bool is_sphere = false; ///< else a box
    Vector half{};          ///< half of a box's size; a sphere's radius is x
    Pose now{}, before{};   ///< in this frame and in the previous one
    int material = 0;       ///< its number in the scene
};

/// A half-line. What it hits is found from a little behind its origin on.
struct Ray {
    Vector origin{}, direction{}; ///< the direction's length is the unit of distances
};

constexpr float nothing_hit = 1e30f; ///< a distance
constexpr float nearest_hit = 1e-4f; ///< of a ray that starts on a surface

/// The distance to a sphere about the origin.
QUELL_LIVE float distance_to_sphere(Ray const& r, float radius) {
    float const a = dot(r.direction, r.direction), b = dot(r.origin, r.direction);
    auto const aside = r.origin - r.direction * (b / a); // the way to the line: in float b * b - a * c loses far spheres
    float const rest = radius * radius - dot(aside, aside);
    if (rest < 0) return nothing_hit;
    float const half_chord = sqrtf(rest / a), near = -b / a - half_chord, far = -b / a + half_chord;
    return near > nearest_hit ? near : far > nearest_hit ? far : nothing_hit;
}

/// Where a ray is within a box: from near to far, if far is not the smaller one.
struct Span {
    float near, far;
};
QUELL_LIVE Span slab_span(Vector const& origin, Vector const& inverse_direction, Vector const& half) {
#if defined(__wasm_simd128__) // whose minima of single floats are branches
    auto const inverted = wasm_v128_load(&inverse_direction);
    auto const middle = wasm_f32x4_mul(wasm_v128_load(&origin), wasm_f32x4_neg(inverted));
    auto const reach = wasm_f32x4_mul(wasm_f32x4_abs(inverted), wasm_v128_load(&half));
    auto const low = wasm_f32x4_sub(middle, reach), high = wasm_f32x4_add(middle, reach);
    auto const near =
        wasm_f32x4_pmax(wasm_f32x4_pmax(low, wasm_i32x4_shuffle(low, low, 1, 1, 1, 1)), wasm_i32x4_shuffle(low, low, 2, 2, 2, 2));
    auto const far =
        wasm_f32x4_pmin(wasm_f32x4_pmin(high, wasm_i32x4_shuffle(high, high, 1, 1, 1, 1)), wasm_i32x4_shuffle(high, high, 2, 2, 2, 2));
    return {wasm_f32x4_extract_lane(near, 0), wasm_f32x4_extract_lane(far, 0)};
#else
    Vector const middle = -(origin * inverse_direction);
    Vector const reach{fabsf(inverse_direction.x) * half.x, fabsf(inverse_direction.y) * half.y, fabsf(inverse_direction.z) * half.z};
    return {larger(larger(middle.x - reach.x, middle.y - reach.y), middle.z - reach.z),
            smaller(smaller(middle.x + reach.x, middle.y + reach.y), middle.z + reach.z)};
#endif
}

/// The distance to a box about the origin, whose sides the axes go through.
QUELL_LIVE float distance_to_box(Vector origin, Vector inverse_direction, Vector half) {
    auto const [near, far] = slab_span(origin, inverse_direction, half);
    if (near > far) return nothing_hit;
    return near > nearest_hit ? near : far > nearest_hit ? far : nothing_hit;
}

/// Whether a ray meets a box about the origin before `most`.
QUELL_LIVE bool meets_box(Vector origin, Vector inverse_direction, Vector half, float most) {
    auto const span = slab_span(origin, inverse_direction, half);
    return span.near <= span.far && span.far > 0 && span.near < most;
}

/// 1 / a, finite: a ray that never leaves a slab shall not make NaN of 0 * infinity.
QUELL_LIVE float finite_inverse(float a) { return 1 / (fabsf(a) > 1e-12f ? a : 1e-12f); }
QUELL_LIVE Vector inverse(Vector a) { return {finite_inverse(a.x), finite_inverse(a.y), finite_inverse(a.z)}; }

/// The distance to a shape in this frame; `inverse_direction` is that of the ray.
QUELL_LIVE float distance_to(Shape const& shape, Ray const& ray, Vector inverse_direction) {
    auto const& pose = shape.now;
    if (shape.is_sphere) return distance_to_sphere({ray.origin - pose.centre, ray.direction}, shape.half.x);
    if (pose.sine == 0) return distance_to_box(ray.origin - pose.centre, inverse_direction, shape.half);
    return distance_to_box(pose.to_local(ray.origin), inverse(pose.direction_to_local(ray.direction)), shape.half);
}

/// The outward normal at a point of the surface, both in the shape's own space.
QUELL_LIVE Vector local_normal(Shape const& shape, Vector p) {
    if (shape.is_sphere) return normalized(p);
    float const x = fabsf(p.x) - shape.half.x, y = fabsf(p.y) - shape.half.y, z = fabsf(p.z) - shape.half.z;
    if (x >= y && x >= z) return {p.x < 0 ? -1.f : 1.f, 0, 0};
    if (y >= z) return {0, p.y < 0 ? -1.f : 1.f, 0};
    return {0, 0, p.z < 0 ? -1.f : 1.f};
}

} // namespace quell::live
