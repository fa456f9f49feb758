#pragma once

#include "../scene.hpp"
#include "model.hpp"

namespace quell::tracer::gltf {

// Each of these fills one part of the scene. Numbers of materials and nodes in the scene are the same as in the file; one more material
// follows, for primitives that have none.

/// Textures and materials.
void add_materials(Model const& model, SceneDescription& scene);
/// Nodes, with their animation.
void add_nodes(Model const& model, SceneDescription& scene);
/// Shapes and instances for all nodes that the file's scene shows. Needs nodes and materials.
void add_instances(Model const& model, SceneDescription& scene);
/// The file's camera, else one that frames everything. Needs instances.
void add_camera(Model const& model, SceneDescription& scene);
/// A sky, a sun and a ground, where there is nothing that emits. Needs instances.
void add_default_light(SceneDescription& scene);

} // namespace quell::tracer::gltf
