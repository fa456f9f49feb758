#pragma once

#include "lights.hpp"

namespace quell::live {

/// What quell reads of a pixel, see docs/channels.md.
struct PixelValue {
    Vector radiance{}, albedo{}, normal{}; ///< of the sky: its radiance, 1, no normal
    float depth = INFINITY;                ///< along the view axis
    ScreenPoint motion{};                  ///< to where it was in the previous frame, pixels
};

/// The reflectance that the radiance is to be divided by.
QUELL_LIVE Vector albedo_of(Material const& m, Vector colour) {
    if (emits(m)) return {1, 1, 1};
    return m.is_metal ? colour : Vector{m.coat, m.coat, m.coat} + colour * (1 - m.coat);
}

constexpr float surface_offset = 1e-3f; ///< of rays that leave a surface, along its normal

/// The share of light that the coat of a surface mirrors, by Schlick (1994).
/// @param direction towards the surface, of any length
QUELL_LIVE float mirrored_share(Material const& m, Vector direction, Vector normal) {
    float const cosine = -dot(normalized(direction), normal), rest = 1 - smaller(1, larger(0, cosine));
    return m.coat > 0 ? m.coat + (1 - m.coat) * rest * rest * rest * rest * rest : 0;
}

/// Light along a ray: paths of at most `surfaces` surfaces. Where they scatter, one sample of a light is taken.
struct Path {
    Scene const& scene;
    Random& random;
    Ray ray;
    Vector radiance, carried{1, 1, 1};
    bool by_lights = false; ///< light that the last surface has had from samples of lights does not count again

    QUELL_LIVE Path(Scene const& s, Random& r, Ray const& first) : scene(s), random(r), ray(first) {}

    QUELL_LIVE void add(Vector light, bool is_direct) {
        light = light * carried;
        float const brightness = luminance(light);
        radiance += !is_direct && brightness > scene.most_indirect ? light * (scene.most_indirect / brightness) : light;
    }
    QUELL_LIVE void leave() {
        add(sky_at(scene.sky, ray.direction), true);
        if (!by_lights && is_in_sun(scene.sky, ray.direction)) add(scene.sky.sun, false);
    }
    QUELL_LIVE void reflect(Hit const& hit, float roughness, Vector colour) {
        float const spread = roughness * random.next(); // by itself: compilers differ in which of two calls is first
        auto const mirrored = normalized(reflected(ray.direction, hit.normal)) + random.direction() * spread;
        carried = carried * (dot(mirrored, hit.normal) > 0 ? colour : Vector{});
        ray.direction = mirrored;
        by_lights = false;
    }
    QUELL_LIVE void scatter(Hit const& hit, Vector colour, bool is_direct) {
        carried = carried * colour;
        auto const light = sample_lights(scene, hit.point, random);
        float const cosine = dot(light.direction, hit.normal);
        if (cosine > 0 && luminance(light.weighted) > 0 && !is_hidden(scene, {ray.origin, light.direction}, light.distance, light.shape))
            add(light.weighted * (cosine / pi), is_direct);
        ray.direction = hit.normal * 1.0001f + random.direction();
        by_lights = true;
    }
    /// Goes on from what was hit; false where the path ends. `depth` counts surfaces.
    QUELL_LIVE bool step(Hit const& hit, int depth) {
        auto const& material = scene.materials[scene.shapes[hit.shape].material];
        if (emits(material)) {
            if (!by_lights || !is_sampled(scene, hit.shape)) add(emission_of(scene, hit), depth == 0);
            return false;
        }
        auto const colour = colour_at(material, hit.local, hit.local_outwards);
        ray.origin = hit.point + hit.normal * surface_offset;
        if (material.is_metal) {
            reflect(hit, material.roughness, colour);
        } else {
            float const mirrored = mirrored_share(material, ray.direction, hit.normal);
            if (mirrored > 0 && random.next() < mirrored)
                reflect(hit, material.roughness, {1, 1, 1});
            else
                scatter(hit, colour, depth == 0);
        }
        return luminance(carried) > 0;
    }
    /// Follows the path from a hit.
    /// @param depth how many surfaces the path has met before
    QUELL_LIVE Vector follow(Hit hit, int surfaces, int depth = 0) {
        for (;; ++depth) {
            if (hit.shape < 0) {
                leave();
                break;
            }
            if (!step(hit, depth) || depth + 1 == surfaces) break;
            hit = nearest(scene, ray);
        }
        return radiance;
    }
};

/// Two cameras, of this frame and of the previous one.
struct Cameras {
    Camera now{}, before{};
};

/// Where what a ray has hit was in the previous frame, less where it is.
QUELL_LIVE ScreenPoint motion_of(Scene const& scene, Cameras const& cameras, Hit const& hit, Vector direction, ScreenPoint at) {
    auto const from_eye = hit.shape < 0 ? direction : scene.shapes[hit.shape].before.to_world(hit.local) - cameras.before.eye;
    auto const then = cameras.before.project(from_eye);
    return {then.x - at.x, then.y - at.y};
}

/// How a picture is traced.
struct Tracing {
    int samples = 1;      ///< per pixel
    int surfaces = 3;     ///< that a path may meet
    uint32_t frame = 0;   ///< chooses the random numbers
    ScreenPoint jitter{}; ///< offset of all samples from the pixels' middles, pixels
};

/// What is seen through a pixel.
struct Seen {
    ScreenPoint at{}; ///< its place
    Ray ray{};        ///< from the eye
    Hit hit{};        ///< the first
};
QUELL_LIVE Seen seen_at(Scene const& scene, Cameras const& cameras, Tracing const& tracing, int x, int y) {
    ScreenPoint const at{static_cast<float>(x) + 0.5f + tracing.jitter.x, static_cast<float>(y) + 0.5f + tracing.jitter.y};
    Ray const ray{cameras.now.eye, cameras.now.direction(at)};
    return {at, ray, nearest(scene, ray)};
}

/// The guides of a pixel, without its radiance.
QUELL_LIVE PixelValue guides_of(Scene const& scene, Cameras const& cameras, Seen const& seen) {
    auto const& hit = seen.hit;
    PixelValue value{.albedo = {1, 1, 1}, .motion = motion_of(scene, cameras, hit, seen.ray.direction, seen.at)};
    if (hit.shape >= 0) {
        auto const& material = scene.materials[scene.shapes[hit.shape].material];
        value.albedo = albedo_of(material, colour_at(material, hit.local, hit.local_outwards));
        value.normal = hit.normal, value.depth = hit.distance;
    }
    return value;
}

/// The mean of a pixel's samples.
QUELL_LIVE Vector radiance_of(Scene const& scene, Seen const& seen, Tracing const& tracing, int x, int y) {
    Vector sum;
    for (int i = 0; i < tracing.samples; ++i) {
        Random random(x, y, tracing.frame, i);
        sum += Path(scene, random, seen.ray).follow(seen.hit, tracing.surfaces);
    }
    return sum * (1 / static_cast<float>(tracing.samples));
}

/// One pixel: its guides, and the mean of its samples. All go through one place of the pixel.
QUELL_LIVE PixelValue trace_pixel(Scene const& scene, Cameras const& cameras, Tracing const& tracing, int x, int y) {
    auto const seen = seen_at(scene, cameras, tracing, x, y);
    auto value = guides_of(scene, cameras, seen);
    value.radiance = radiance_of(scene, seen, tracing, x, y);
    return value;
}

} // namespace quell::live
