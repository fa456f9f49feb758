#include "../temporary_folder.hpp"

#include <quell/core/error.hpp>
#include <tracer/bounds.hpp>
#include <tracer/gltf/gltf.hpp>

#include <cstdint>
#include <cstdlib>
#include <string_view>

// libFuzzer's program for glTF files: any bytes are a scene, whose parts refer to what there is at any moment, or an Error.
using namespace quell;
using namespace quell::tracer;

namespace {

/// Under the name that suits them: binary files say what they are.
std::filesystem::path write(std::string const& bytes) {
    static tests::Folder const folder;
    auto const file = folder / (bytes.starts_with("glTF") ? "any.glb" : "any.gltf");
    tests::write_bytes(file, bytes);
    return file;
}

void check(bool holds) {
    if (!holds) std::abort();
}
template <class Item> bool has(std::vector<Item> const& list, int number) {
    return number >= 0 && static_cast<std::size_t>(number) < list.size();
}

void check_references(SceneDescription const& scene) {
    for (auto const& instance : scene.instances) {
        check(has(scene.shapes, instance.shape) && has(scene.materials, instance.material));
        check(instance.node == -1 || has(scene.nodes, instance.node));
    }
    for (auto const& shape : scene.shapes)
        for (auto const& corners : shape.mesh.triangles)
            for (int i = 0; i < 3; ++i) check(corners[i] < shape.mesh.positions.size());
    for (auto const& material : scene.materials)
        for (int const texture : {material.base_texture, material.metallic_roughness_texture, material.emission_texture})
            check(texture == -1 || has(scene.textures, texture));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    auto const file = write({reinterpret_cast<char const*>(data), size});
    try {
        auto const scene = load_gltf(file, {.orbit = 1.f});
        check_references(scene);
        for (float const frame : {0.f, -1.f, 7.3f}) {
            static_cast<void>(bounds_of(scene, frame));
            static_cast<void>(scene.camera_at(frame, {16, 9}));
        }
        for (auto const& texture : scene.textures) static_cast<void>(texture.at({0.3f, -1.7f}, 0.1f));
    } catch (Error const& error) {
        check(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
    return 0;
}
