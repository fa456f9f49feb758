#pragma once

#include "mesh.hpp"
#include "texture.hpp"
#include "transform.hpp"

#include <quell/frame/camera.hpp>

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace quell::tracer {

/// A thin lens: what is not at its distance of focus is blurred.
struct Lens {
    float radius = 0; ///< of its opening, in world units; 0: a pinhole, which sees all sharply
    float focus = 1;  ///< distance along the view axis at which all is sharp, in world units

    explicit operator bool() const { return radius > 0; }
};

/// How much of a surface there is: a window pane, a veil.
struct Coverage {
    float part = 1; ///< of the primary rays that meet it; the others go on behind it. All others pass it where it is less than 1.

    explicit operator bool() const { return part < 1; }
};

/// Metallic-roughness surface. Diffuse reflectance is base * (1 - metallic); the metallic part reflects by GGX with a reflectance of
/// base * metallic at normal incidence and `metallic` at grazing incidence. What emits neither reflects nor transmits.
struct Material {
    glm::vec3 base{0.8f};
    float metallic = 0;
    float roughness = 1;
    glm::vec3 emission{0.f};                        ///< radiance; every emitter is a light, seen by camera and reflections as well
    std::function<float(float frame)> brightness{}; ///< factor on `emission` over time; none means 1
    bool emits_both_sides = false; ///< otherwise only the side from which triangles look counter-clockwise; spheres emit outwards
    float alpha_cutoff = 0;        ///< texels of base with less alpha are holes; 0 means there are none
    int base_texture = -1;
    int metallic_roughness_texture = -1; ///< roughness in G, metallic in B
    int emission_texture = -1;
    Coverage coverage{};
};

/// A coordinate system, perhaps moving, perhaps inside another.
struct Node {
    int parent = -1;
    Pose pose;
};

struct SceneInstance {
    int shape = 0, material = 0;
    int node = -1; ///< -1: world
};

/// Radiance of what lies behind everything: a vertical gradient.
struct Background {
    glm::vec3 below{0.f}, above{0.f};

    [[nodiscard]] glm::vec3 radiance(glm::vec3 direction) const { return below + (above - below) * (0.5f + 0.5f * direction.y); }
    /// Its mean over the hemisphere around a normal, weighted by the cosine: what a surface that nothing stands before receives.
    [[nodiscard]] glm::vec3 ambient(glm::vec3 normal) const { return below + (above - below) * (0.5f + normal.y / 3); }
};

/// Where the camera stands at a moment. It looks down its own -z axis, y up.
struct CameraPose {
    glm::mat4 world_from_camera{1.f};
    float vertical_field_of_view = 0.9f; ///< radians
    Lens lens{};

    /// Whether rays can be sent from it: it is finite, near enough to the origin, looks somewhere, and sees between 0 and 180 degrees.
    [[nodiscard]] bool is_usable() const;
};

/// A world in y-up coordinates, each part of which is a function of time. Time counts frames: frame i shows time i, and what was
/// previous to it is time i - 1.
struct SceneDescription {
    std::string name;
    std::vector<Shape> shapes;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Node> nodes;
    std::vector<SceneInstance> instances;
    std::function<CameraPose(float frame)> camera;
    Background background;
    /// False: indirect light is what the background sends, whatever is in its way: exact, so without noise, and without rays.
    bool indirect_rays = true;
    /// False: a picture is unshadowed direct light and the background's ambient light, and no ray follows the primary one. Such a picture
    /// is noisy in nothing but time, as the input of SVGF for motion blur is (MB section 3). `indirect_rays` doesn't matter then.
    bool secondary_rays = true;

    int add(Shape shape);
    int add(TriangleMesh mesh);
    int add(Texture texture);
    int add(Material material);
    /// A material that scatters light evenly, in the colours of a texture or in one.
    int paint(Texture texture) { return add(Material{.base_texture = add(std::move(texture))}); }
    int paint(glm::vec3 colour) { return add(Material{.base = colour}); }
    int metal(glm::vec3 colour, float roughness) { return add(Material{.base = colour, .metallic = 1, .roughness = roughness}); }
    /// One that shines with this radiance.
    int glow(glm::vec3 radiance) { return add(Material{.emission = radiance}); }
    int add_node(Pose pose, int parent = -1);
    int add_sphere();
    int place(int shape, int material, Transform const& transform = {}, int parent = -1);
    /// The same for what moves. A template, so that a braced list can only mean a Transform.
    template <std::invocable<float> Motion> int place(int shape, int material, Motion pose, int parent = -1) {
        instances.push_back({shape, material, add_node(std::move(pose), parent)});
        return static_cast<int>(instances.size()) - 1;
    }

    [[nodiscard]] bool has_indirect_rays() const { return secondary_rays && indirect_rays; }
    [[nodiscard]] glm::mat4 node_matrix(int node, float frame) const;
    /// A shape's vertices at a moment; texture coordinates are left out.
    [[nodiscard]] TriangleMesh vertices_at(Shape const& shape, float frame) const;
    [[nodiscard]] Camera camera_at(float frame, Extent size) const;
};

/// From a node's space to the world; -1 is the world itself.
[[nodiscard]] glm::mat4 node_matrix(std::vector<Node> const& nodes, int node, float frame);

/// A camera that looks from one point at another. `field_of_view` is vertical, in degrees. Where it looks along `up`, the z axis takes its
/// place: a camera that looks straight down has -z at the top of the picture.
[[nodiscard]] CameraPose look_at(glm::vec3 eye, glm::vec3 target, float field_of_view, glm::vec3 up = {0, 1, 0});

[[nodiscard]] Camera camera_from(CameraPose const& pose, Extent size);

} // namespace quell::tracer
