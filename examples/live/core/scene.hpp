#pragma once

#include "camera.hpp"
#include "materials.hpp"
#include "random.hpp"
#include "shapes.hpp"

namespace quell::live {

/// What light paths aim at.
enum class LightKind { rectangle, sphere, sun };

/// A light that is sampled. Its emission is that of the shape's material; the sun's is its own.
struct Light {
    LightKind kind = LightKind::rectangle; ///< a rectangle is the lower side of a box
    int shape = -1;                        ///< its number in the scene; none is the sun's
    float share = 1;                       ///< of all samples that go to this one
};

/// What is around everything.
struct Sky {
    Vector zenith{}, horizon{};  ///< radiance straight up, and from the horizon down
    Vector sun{};                ///< radiance of its disk
    Vector towards_sun{0, 1, 0}; ///< unit vector
    float sun_cosine = 1;        ///< of the angle that its disk has about its middle; 1: no sun
    Vector towards_sun_before{}; ///< in the previous frame
};

/// Neighbouring shapes, with a box around them: rays that miss it miss them all.
struct Group {
    int first = 0, count = 0; ///< shapes
    Vector centre{}, half{};  ///< of the box
};

/// All that is traced. The arrays are as large as the largest scene.
struct Scene {
    static constexpr int most_shapes = 40, most_materials = 24, most_lights = 4, most_groups = 16;
    Shape shapes[most_shapes];
    Material materials[most_materials];
    Light lights[most_lights];
    Group groups[most_groups];
    int shape_count = 0, material_count = 0, light_count = 0, group_count = 0;
    Sky sky{};
    float most_indirect = 12; ///< limit of what a sample may bring by way of a second surface: rare brighter ones are cut

    QUELL_LIVE int add(Material const& m) {
        materials[material_count] = m;
        return material_count++;
    }
    /// A shape that may have moved since the previous frame.
    QUELL_LIVE int add(Shape const& s) {
        shapes[shape_count] = s;
        return shape_count++;
    }
    /// Makes a group of all shapes that are in none yet.
    QUELL_LIVE void close_group() {
        int const first = group_count > 0 ? groups[group_count - 1].first + groups[group_count - 1].count : 0;
        Vector low{nothing_hit, nothing_hit, nothing_hit}, high = -low;
        for (int i = first; i < shape_count; ++i) {
            auto const& [is_sphere, half, now, before, material] = shapes[i];
            float const across = is_sphere || now.sine == 0 ? 0 : sqrtf(half.x * half.x + half.z * half.z);
            Vector const reach{larger(half.x, across), half.y, larger(half.z, across)};
            auto const from = now.centre - reach, to = now.centre + reach;
            low = {smaller(low.x, from.x), smaller(low.y, from.y), smaller(low.z, from.z)};
            high = {larger(high.x, to.x), larger(high.y, to.y), larger(high.z, to.z)};
        }
        groups[group_count++] = {first, shape_count - first, (low + high) * 0.5f, (high - low) * 0.5f};
    }
    QUELL_LIVE int add_box(Vector size, Vector centre, int material, float turned = 0) {
        auto const pose = posed(centre, turned);
        return add(Shape{false, size * 0.5f, pose, pose, material});
    }
    QUELL_LIVE int add_sphere(float radius, Vector centre, int material) {
        auto const pose = posed(centre);
        return add(Shape{true, {radius, radius, radius}, pose, pose, material});
    }
    QUELL_LIVE void add(Light const& l) { lights[light_count++] = l; }
};

/// What a ray hit.
struct Hit {
    float distance = nothing_hit;      ///< in the length of the ray's direction
    int shape = -1;                    ///< its number; -1: nothing
    Vector local{}, point{};           ///< where, in the shape's own space and in the world
    Vector local_outwards{}, normal{}; ///< the normal in the shape's own space, and in the world towards the ray's origin
};

/// Radiance of the sky, without the sun.
QUELL_LIVE Vector sky_at(Sky const& sky, Vector direction) {
    return mix(sky.horizon, sky.zenith, sqrtf(larger(0, direction.y / length(direction))));
}
QUELL_LIVE bool is_in_sun(Sky const& sky, Vector direction) {
    return sky.sun_cosine < 1 && dot(direction, sky.towards_sun) > sky.sun_cosine * length(direction);
}

/// Whether a shape of a group may be nearer than `most`.
QUELL_LIVE bool may_hit(Group const& group, Ray const& ray, Vector inverse_direction, float most) {
    return group.count == 1 || meets_box(ray.origin - group.centre, inverse_direction, group.half, most);
}

QUELL_LIVE Hit nearest(Scene const& scene, Ray const& ray) {
    Hit hit;
    auto const inverse_direction = inverse(ray.direction);
    for (int g = 0; g < scene.group_count; ++g) {
        auto const& group = scene.groups[g];
        if (!may_hit(group, ray, inverse_direction, hit.distance)) continue;
        for (int i = group.first; i < group.first + group.count; ++i) {
            float const distance = distance_to(scene.shapes[i], ray, inverse_direction);
            if (distance < hit.distance) hit.distance = distance, hit.shape = i;
        }
    }
    if (hit.shape < 0) return hit;
    auto const& shape = scene.shapes[hit.shape];
    hit.point = ray.origin + ray.direction * hit.distance;
    hit.local = shape.now.to_local(hit.point);
    hit.local_outwards = local_normal(shape, hit.local);
    auto const outwards = shape.now.direction_to_world(hit.local_outwards);
    hit.normal = dot(outwards, ray.direction) > 0 ? -outwards : outwards;
    return hit;
}

/// Whether something lies on the way to a light: anything but `light` that is nearer than `distance`.
QUELL_LIVE bool is_hidden(Scene const& scene, Ray const& ray, float distance, int light) {
    auto const inverse_direction = inverse(ray.direction);
    for (int g = 0; g < scene.group_count; ++g) {
        auto const& group = scene.groups[g];
        if (!may_hit(group, ray, inverse_direction, distance)) continue;
        for (int i = group.first; i < group.first + group.count; ++i)
            if (i != light && distance_to(scene.shapes[i], ray, inverse_direction) < distance) return true;
    }
    return false;
}

} // namespace quell::live
