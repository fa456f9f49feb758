#pragma once

#include "embree.hpp"
#include "ray.hpp"
#include "scene.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace quell::tracer {

/// Holes in a mesh, as a texture's alpha draws them.
struct AlphaTest {
    TriangleMesh const* mesh;
    Texture const* texture;
    float cutoff;
};

/// Embree's view of a scene: one acceleration structure per shape, and one above them for the instances.
class Acceleration {
public:
    /// The description has to outlive this, and stay where it is.
    explicit Acceleration(SceneDescription const& scene);

    /// Vertex positions of a deforming shape at the moments of the open shutter.
    void deform(int shape, std::vector<TriangleMesh> const& moments);
    /// Placements of an instance at those moments.
    void place(int instance, std::vector<glm::mat4> const& moments);
    /// To be called once after all changes.
    void commit();

    [[nodiscard]] Hit intersect(Ray const& ray) const;
    [[nodiscard]] bool occluded(Ray const& ray) const;

private:
    struct Part {
        EmbreePointer<RTCScene> scene;
        EmbreePointer<RTCGeometry> geometry;
        std::unique_ptr<AlphaTest> alpha_test;
    };

    Part& part_of(SceneInstance const& instance);
    Part build(Shape const& shape) const;
    void add_alpha_test(Part& part, Shape const& shape, Material const& material) const;
    void check() const;

    SceneDescription const& description;
    EmbreePointer<RTCDevice> device;
    EmbreePointer<RTCScene> world;
    std::map<std::pair<int, int>, Part> parts; ///< by shape, and by material where that has holes
    std::vector<EmbreePointer<RTCGeometry>> instances;
};

} // namespace quell::tracer
