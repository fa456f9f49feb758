#include "gltf.hpp"

#include "../scenes/scenes.hpp"
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

SceneDescription open_scene(std::string const& name_or_path, CameraChoice const& camera) {
    auto const extension = std::filesystem::path{name_or_path}.extension();
    if (extension == ".gltf" || extension == ".glb") return load_gltf(name_or_path, camera);
    auto scene = built_in_scene(name_or_path);
    choose_camera(scene, camera);
    return scene;
}

} // namespace quell::tracer
