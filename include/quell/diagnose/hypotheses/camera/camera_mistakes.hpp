#pragma once

#include <quell/diagnose/finding.hpp>
#include <quell/diagnose/hypotheses/camera/geometry.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/ext/matrix_transform.hpp>

#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A mistake of the geometry, and what the geometry is without it.
struct GeometryMistake {
    Mistake mistake;
    std::string without; ///< as evidence names it: "with the inverse of camera.view"
    std::string remedy;
    Geometry geometry;
};

/// Both cameras, changed alike.
template <class F> Geometry changed(Geometry geometry, F&& change) {
    change(geometry.now), change(geometry.then);
    return geometry;
}
inline void scale_view(Camera& camera, glm::vec3 signs) { camera.view = glm::scale(glm::mat4(1.f), signs) * camera.view; }
inline void scale_projection(Camera& camera, glm::vec2 by) {
    camera.projection = glm::scale(glm::mat4(1.f), glm::vec3(by, 1.f)) * camera.projection;
}
inline void transpose_rotation(Camera& camera) {
    auto const moved = camera.view[3];
    camera.view = glm::mat4(glm::transpose(glm::mat3(camera.view)));
    camera.view[3] = moved;
}

/// Rotation and inversion. The commoner of mistakes that look alike comes first.
inline std::vector<GeometryMistake> mistakes_of_view(Geometry const& own) {
    return {
        {Mistake::view_inverted, "with the inverse of camera.view",
         "set camera.view to the inverse of the camera's pose, if its last column is where the camera is in the world: it takes the world "
         "to "
         "the camera",
         changed(own, [](Camera& c) { c.view = glm::inverse(c.view); })},
        {Mistake::view_rotation_transposed, "with the rotation in camera.view transposed",
         "transpose the upper 3x3 of camera.view, if its last column is where the world's origin is for the camera: its rows are the "
         "camera's axes in world space",
         changed(own, transpose_rotation)},
    };
}

/// Axes that point the other way.
inline std::vector<GeometryMistake> mistakes_of_axes(Geometry const& own) {
    auto const with = [&](glm::vec3 signs) { return changed(own, [=](Camera& c) { scale_view(c, signs); }); };
    auto turned = with({1, -1, 1});
    turned.now.jitter.y *= -1.f, turned.then.jitter.y *= -1.f;
    return {
        {Mistake::camera_upside_down, "with the second row of camera.projection negated and jitter.y too",
         "where a picture shown row by row from row 0 down stands on its head, give all images with their first row at the top; else "
         "negate "
         "that row of the projection: row 0 is y = +1 of it",
         turned},
        {Mistake::camera_upside_down, "with the second row of camera.projection negated",
         "where a picture shown row by row from row 0 down stands on its head, give all images with their first row at the top; else "
         "negate "
         "that row of the projection: row 0 is y = +1 of it",
         with({1, -1, 1})},
        {Mistake::view_looks_backwards, "with the third row of camera.view negated", "negate it: quell's view looks down -z",
         with({1, 1, -1})},
        {Mistake::view_looks_backwards, "with the second and third rows of camera.view negated",
         "negate both: in quell's view y is up and z points backwards", with({1, -1, -1})},
        {Mistake::view_looks_backwards, "with the first and third rows of camera.view negated",
         "negate both: quell's view looks down -z, with x to the right", with({-1, 1, -1})},
        {Mistake::view_mirrored, "with the first row of camera.view negated", "negate it: in quell's view x points to the right",
         with({-1, 1, 1})},
        {Mistake::view_mirrored, "with the first and second rows of camera.view negated",
         "negate both: in quell's view x points to the right and y up", with({-1, -1, 1})},
    };
}

/// What is right with the camera, but not with depth or normals.
inline std::vector<GeometryMistake> mistakes_of_surfaces(Geometry const& own) {
    auto ray = own, normals = own;
    ray.ray_length = normals.view_normals = true;
    return {
        {Mistake::depth_is_ray_length, "with depth taken for the length of the ray",
         "write the distance along the view axis: the length of the ray times the cosine of its angle to that axis", ray},
        {Mistake::normal_in_view_space, "with normals taken for view space", "write normals in world space: transpose(mat3(view)) * n",
         normals},
    };
}

inline constexpr char make_depth_linear[] =
    "write the distance along the view axis in world units, +infinity where there is no surface: for depth d in [0, 1] "
    "near * far / (far - d * (far - near)), with near and far exchanged where it is reversed";

/// Depth that goes like its inverse. Near and far planes of all kinds leave their traces.
inline std::vector<GeometryMistake> mistakes_of_linearity(Geometry const& own) {
    std::vector<GeometryMistake> all;
    for (float const from : {0.f, 1.f, 1.0001f, 1.0003f, 1.001f, 1.003f, 1.01f}) {
        auto without = own;
        without.inverse_from = from;
        all.push_back({Mistake::depth_not_linear,
                       from > 0.f ? "with 1 / (" + number(static_cast<double>(from)) + " - depth) in place of depth"
                                  : std::string("with 1 / depth in place of depth"),
                       make_depth_linear, without});
    }
    return all;
}

/// A projection whose x and y are scaled by so much.
inline GeometryMistake mistake_of_projection(Geometry const& own, glm::vec2 by) {
    auto const without = changed(own, [=](Camera& c) { scale_projection(c, by); });
    auto const& p = own.now.projection;
    auto const is = pair(static_cast<double>(p[0][0]), static_cast<double>(p[1][1]));
    auto const should = pair(static_cast<double>(without.now.projection[0][0]), static_cast<double>(without.now.projection[1][1]));
    return {Mistake::field_of_view, "with " + should + " in place of " + is + " in camera.projection[0][0] and [1][1]",
            "look at the field of view (radians, vertical, whole or half) and at the aspect ratio that camera.projection is made from",
            without};
}

/// Depth in a unit that is so many of the camera's.
inline GeometryMistake mistake_of_unit(Geometry const& own, float unit) {
    auto without = own;
    without.unit = unit;
    return {Mistake::depth_unit, "with depth times " + number(static_cast<double>(unit)),
            "give depth and the positions in camera.view in one unit: one of them is " + number(static_cast<double>(1.f / unit)) +
                " times too large or small",
            without};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
