#pragma once

#include "light_point.hpp"
#include "trace.hpp"

namespace quell::live {

// The light of a pixel in three parts, each with what its motion follows from: see docs/channels.md. They add up to what a path brings:
//     direct * visibility + mirrored + diffuse * indirect
// Each function traces rays of its own, with random numbers of its own: a host calls those whose values it wants.

/// How the surface of a pixel takes light.
struct Reflectance {
    Vector diffuse{1, 1, 1}; ///< of light from everywhere; 1 for what emits and for the sky
    Vector mirrored{};       ///< of light from one direction; black: it mirrors nothing
    float spread = 0;        ///< how far mirrored light scatters: Material::roughness
    bool scatters = false;   ///< whether it has diffuse light at all

    [[nodiscard]] QUELL_LIVE bool mirrors() const { return luminance(mirrored) > 0; }
    /// The roughness of GGX whose lobe is about as wide: half of its light comes from within the same angle.
    [[nodiscard]] QUELL_LIVE float roughness() const { return mirrors() ? smaller(1, 0.42f * sqrtf(spread)) : 1; }
};
QUELL_LIVE Reflectance reflectance_of(Scene const& scene, Seen const& seen) {
    if (seen.hit.shape < 0) return {};
    auto const& material = scene.materials[scene.shapes[seen.hit.shape].material];
    if (emits(material)) return {};
    auto const colour = colour_at(material, seen.hit.local, seen.hit.local_outwards);
    if (material.is_metal) return {{}, colour, material.roughness, false};
    float const share = mirrored_share(material, seen.ray.direction, seen.hit.normal);
    return {colour * (1 - share), Vector{share, share, share}, material.roughness, true};
}

/// The point that a ray has hit.
QUELL_LIVE Followed followed(Scene const& scene, Hit const& hit) {
    return hit.shape < 0 ? Followed{} : followed(scene.shapes[hit.shape], hit.local);
}
/// Where rays leave a surface.
QUELL_LIVE Vector above(Hit const& hit) { return hit.point + hit.normal * surface_offset; }

/// Light from lights, apart from its shadow.
struct DirectLight {
    Vector direct{};      ///< reflected as if nothing were in between, without noise; of what emits, and of the sky: their light
    float visibility = 1; ///< 0 where something is between the surface and the one point of a light that is asked
    Followed light{};     ///< that point
    Followed blocker{};   ///< what is in between, nearest to the surface
};
/// What lights send if nothing is in between, and one shadow ray.
QUELL_LIVE DirectLight direct_light(Scene const& scene, Seen const& seen, Reflectance const& reflectance, Random random) {
    DirectLight value;
    if (!reflectance.scatters) {
        if (!reflectance.mirrors()) value.direct = Path(scene, random, seen.ray).follow(seen.hit, 1);
        return value;
    }
    auto const from = above(seen.hit), normal = seen.hit.normal;
    Vector irradiance;
    Reservoir reservoir{random.next()};
    int chosen = -1;
    for (int i = 0; i < scene.light_count; ++i) {
        auto const part = irradiance_of(scene, scene.lights[i], from, normal);
        irradiance += part;
        if (reservoir.takes(luminance(part))) chosen = i;
    }
    value.direct = reflectance.diffuse * irradiance * (1 / pi);
    if (chosen < 0) return value;
    value.light = light_point(scene, scene.lights[chosen], from, normal, random);
    auto const to = value.light.now - from;
    float const distance = length(to);
    auto const hit = nearest(scene, {from, to * (1 / distance)});
    if (hit.shape >= 0 && hit.shape != scene.lights[chosen].shape && hit.distance < distance)
        value.visibility = 0, value.blocker = followed(scene, hit);
    return value;
}

/// Light that a surface mirrors.
struct MirroredLight {
    Vector radiance{}; ///< times the reflectance
    Followed hit{};    ///< what is seen in the mirror
};
/// Light along one mirrored path. It meets at most so many surfaces, the mirror among them.
QUELL_LIVE MirroredLight mirrored_light(Scene const& scene, Seen const& seen, Reflectance const& reflectance, int surfaces, Random random) {
    MirroredLight value;
    if (surfaces < 2 || !reflectance.mirrors()) return value;
    Path path(scene, random, {above(seen.hit), seen.ray.direction});
    path.reflect(seen.hit, reflectance.spread, {1, 1, 1});
    if (!(luminance(path.carried) > 0)) return value;
    auto const hit = nearest(scene, path.ray);
    value.radiance = path.follow(hit, surfaces, 1) * reflectance.mirrored;
    value.hit = followed(scene, hit);
    return value;
}

/// Light that other surfaces and the sky send to a surface.
struct IndirectLight {
    Vector radiance{};         ///< from one direction, which is as likely as its cosine is large; not times the reflectance
    Vector direction{0, 1, 0}; ///< unit vector to where it comes from
};
/// Light along one path. It meets at most so many surfaces, the first one among them.
QUELL_LIVE IndirectLight indirect_light(Scene const& scene, Seen const& seen, Reflectance const& reflectance, int surfaces, Random random) {
    IndirectLight value;
    if (!reflectance.scatters) return value;
    value.direction = normalized(seen.hit.normal * 1.0001f + random.direction());
    if (surfaces < 2) return value;
    Path path(scene, random, {above(seen.hit), value.direction});
    path.by_lights = true;
    value.radiance = path.follow(nearest(scene, path.ray), surfaces, 1);
    return value;
}

} // namespace quell::live
