#pragma once

#include "acceleration.hpp"
#include "emitter.hpp"
#include "ray.hpp"
#include "scene.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace quell::tracer {

enum class When { now, before };

/// Enough moments for a quarter turn within the shutter to look round: the chord then errs by 0.5% of the radius.
inline constexpr int default_shutter_keys = 9;
/// As many as Embree allows.
inline constexpr int max_shutter_keys = 129;

/// Something at evenly spaced moments of the open shutter (one moment while the shutter is closed), and the same one frame earlier.
template <class Value> struct Moments {
    std::vector<Value> now, before;
    [[nodiscard]] std::vector<Value> const& at(When when) const { return when == When::now ? now : before; }
};

/// A scene with its acceleration structures, standing at one frame. What doesn't deform is built once; from frame to frame only the
/// placements change. Not copyable, as Embree points into the description.
class PreparedScene {
public:
    explicit PreparedScene(SceneDescription description);
    PreparedScene(PreparedScene const&) = delete;
    PreparedScene& operator=(PreparedScene const&) = delete;

    /// Moves everything to a frame. The shutter opens at the frame's moment and stays open for this part of the frame time; 0 freezes
    /// time. Placements, vertices and the camera are those of the description at so many evenly spaced moments of the open shutter, the
    /// first and the last included, and move in a straight line from one to the next. Free of cost where nothing changes.
    void move_to(float frame, float shutter = 0, int keys = default_shutter_keys);

    /// The same scene standing one frame before this one, for what has to be traced in both. It is made when first asked for.
    [[nodiscard]] PreparedScene const& one_frame_earlier();

    /// What a ray meets that no other ray passes: surfaces of partial coverage are left out.
    [[nodiscard]] Hit intersect(Ray const& ray) const;
    [[nodiscard]] bool occluded(Ray const& ray) const;
    /// What a primary ray meets.
    /// @param met a number in [0, 1): a surface is met where it is below the surface's coverage
    [[nodiscard]] Hit first_hit(Ray const& ray, float met) const;
    [[nodiscard]] bool has_lens() const { return static_cast<bool>(cameras.now.front().lens); }
    [[nodiscard]] bool has_partial_coverage() const { return partial_coverage; }
    /// Whether samples at one place in the image see different points.
    [[nodiscard]] bool spreads_primary_rays() const { return has_lens() || has_partial_coverage(); }

    /// From an instance's own space to the world.
    [[nodiscard]] glm::mat4 placement(int instance, float time, When when) const;
    /// Where the point that was hit is at a time of the open shutter, in this frame or the one before.
    [[nodiscard]] glm::vec3 point(Hit const& hit, float time, When when) const;
    /// Corner i (0..2) of a triangle that was hit, in the instance's own space.
    [[nodiscard]] glm::vec3 corner(Hit const& hit, int i, float time, When when) const;
    [[nodiscard]] glm::vec3 corner_normal(Hit const& hit, int i, float time) const;

    [[nodiscard]] std::size_t emitter_count() const { return sources.size(); }
    [[nodiscard]] Emitter emitter(std::size_t index, float time) const;
    /// Where a point of an emitter is at another time of the open shutter.
    [[nodiscard]] glm::vec3 emitter_point(std::size_t index, glm::vec3 position, float time, float other) const;
    /// Whether light from this instance is part of `direct`, so that indirect rays must not count it again.
    [[nodiscard]] bool is_light(int instance) const { return lights[static_cast<std::size_t>(instance)]; }
    /// Factor on its material's emission at this frame.
    [[nodiscard]] float brightness(int instance) const { return brightnesses[static_cast<std::size_t>(instance)]; }

    [[nodiscard]] SceneDescription const& description() const { return scene; }
    [[nodiscard]] Shape const& shape(int instance) const;
    [[nodiscard]] Material const& material(int instance) const;
    [[nodiscard]] float frame() const { return current_frame; }
    [[nodiscard]] float shutter() const { return current_shutter; }
    /// The camera at a time of the open shutter, in this frame or the one before.
    [[nodiscard]] CameraPose camera(float time, When when) const;

    /// A digest of everything that pictures of the current frame depend on: all members of the description, and what its functions of
    /// time give while the shutter is open.
    [[nodiscard]] std::uint64_t content_hash() const;

private:
    /// A light as the description has it: a sphere, or these vertices of a mesh.
    struct EmitterSource {
        int instance;
        int corner_count;
        glm::uvec4 vertices;
        glm::vec3 radiance;
    };

    /// The nearest surface that `meets(coverage)` says is met; it is asked about those of partial coverage.
    [[nodiscard]] Hit nearest_of(Ray ray, auto const& meets) const;
    [[nodiscard]] Hit located(Ray const& ray) const;
    void find_emitters();
    void find_emitters_of(int instance);
    void deform_shapes();
    void place_instances();
    [[nodiscard]] CameraPose usable_camera(float frame) const;
    void light_up();
    [[nodiscard]] glm::vec3 mean_emission_texel(int instance, int count, glm::uvec4 corners) const;
    [[nodiscard]] std::vector<float> moments_before(float earlier) const;
    [[nodiscard]] auto at_moments(auto const& value_at) const;
    [[nodiscard]] glm::vec3 local_vertex(int instance, unsigned vertex, float time, When when) const;
    [[nodiscard]] Emitter emitter_at(EmitterSource const& source, float time) const;

    SceneDescription scene;
    Acceleration acceleration;
    std::vector<EmitterSource> sources;
    std::vector<bool> lights;
    std::vector<float> brightnesses;
    std::vector<Moments<glm::mat4>> placements;      // per instance
    std::vector<Moments<TriangleMesh>> deformations; // per shape; empty for rigid ones
    std::vector<std::vector<Emitter>> emitters;      // per moment
    Moments<CameraPose> cameras;
    bool partial_coverage = false;
    float current_frame = -infinity, current_shutter = 0;
    int current_keys = default_shutter_keys;
    std::unique_ptr<PreparedScene> earlier;
};

} // namespace quell::tracer
