#include "gltf.hpp"

#include "parts.hpp"

namespace quell::tracer {

SceneDescription load_gltf(std::filesystem::path const& path, CameraChoice const& camera) {
    auto const model = gltf::load_model(path);
    SceneDescription scene;
    scene.name = path.stem().string();
    gltf::add_materials(model, scene);
    gltf::add_nodes(model, scene);
    gltf::add_instances(model, scene);
    gltf::add_camera(model, scene);
    // The camera first: what stands in for missing light isn't part of what it frames.
    choose_camera(scene, camera);
    gltf::add_default_light(scene);
    return scene;
}

} // namespace quell::tracer
