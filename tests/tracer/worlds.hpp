#pragma once

#include <tracer/pictures.hpp>
#include <tracer/render.hpp>
#include <tracer/shapes.hpp>

#include <doctest/doctest.h>

namespace quell::tracer {

/// A description with a camera that stands still.
inline SceneDescription world(glm::vec3 eye, glm::vec3 target, float field_of_view = 60) {
    SceneDescription scene;
    scene.name = "world of a test";
    scene.camera = [pose = look_at(eye, target, field_of_view)](float) { return pose; };
    return scene;
}

/// Renders a description's channels into pictures.
template <class Wanted> Pictures<Wanted> pictures_of(SceneDescription scene, RenderSettings const& settings) {
    PreparedScene prepared{std::move(scene)};
    Pictures<Wanted> pictures{settings.size};
    render<Wanted>(prepared, settings, pictures);
    return pictures;
}

inline glm::vec3 pixel(metrics::Picture const& picture, int x, int y) {
    return picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) + static_cast<std::size_t>(x)];
}

inline bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Where a point appears by the camera's matrices, in pixels: quell's convention, apart from the tracer's own projection.
inline glm::vec2 projected(Camera const& camera, glm::vec3 point, Extent size) {
    auto const clip = camera.clip_from_world() * glm::vec4(point, 1.f);
    return {(clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(size.width),
            (0.5f - 0.5f * clip.y / clip.w) * static_cast<float>(size.height)};
}

} // namespace quell::tracer
