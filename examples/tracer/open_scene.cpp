#include "gltf/gltf.hpp"
#include "scenes/scenes.hpp"

namespace quell::tracer {

SceneDescription open_scene(std::string const& name_or_path, CameraChoice const& camera) {
    auto const extension = std::filesystem::path{name_or_path}.extension();
    if (extension == ".gltf" || extension == ".glb") return load_gltf(name_or_path, camera);
    auto scene = built_in_scene(name_or_path);
    choose_camera(scene, camera);
    return scene;
}

} // namespace quell::tracer
