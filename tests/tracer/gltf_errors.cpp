#include "../temporary_folder.hpp"

#include <quell/core/error.hpp>
#include <tracer/gltf/gltf.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace quell;
using namespace quell::tracer;

namespace {

struct Folder : quell::tests::Folder {
    [[nodiscard]] std::filesystem::path write(std::string const& name, std::string const& content) const {
        quell::tests::write_bytes(path / name, content);
        return path / name;
    }
};

/// One triangle, whose positions are embedded: (0 0 0) (1 0 0) (0 1 0).
std::string triangle(std::string const& material, std::string const& indices = "", std::string const& more = "",
                     std::string const& accessor_count = "3") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0})" +
           indices + (material.empty() ? "" : R"(,"material":0)") + R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
           accessor_count +
           R"(,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":3}],)" +
           R"("buffers":[{"byteLength":40,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAEJAA=="}])" +
           (material.empty() ? "" : R"(,"materials":[)" + material + "]") + more + "}";
}

void check_error(std::filesystem::path const& file, std::string const& found) {
    CAPTURE(file.string());
    try {
        static_cast<void>(load_gltf(file));
        FAIL("no error");
    } catch (Error const& error) {
        CHECK(error.subject == file.string());
        CHECK_MESSAGE(error.found.find(found) != std::string::npos, error.found);
        CHECK(!error.remedy.empty());
        CHECK(std::string{error.what()}.find('\n') == std::string::npos);
    }
}

} // namespace

TEST_CASE("a whole little file loads") {
    Folder const folder;
    auto const scene = load_gltf(
        folder.write("good.gltf", triangle(R"({"pbrMetallicRoughness":{"baseColorFactor":[0.2,0.4,0.6,1],"metallicFactor":0}})")));
    REQUIRE(scene.instances.size() >= 1);
    CHECK(scene.shapes[0].mesh.triangles.size() == 1);
    CHECK(scene.materials[0].base.y == doctest::Approx(0.4f));
}

TEST_CASE("files that are missing or no glTF are refused by name") {
    Folder const folder;
    check_error(folder.path / "absent.gltf", "no such file");
    check_error(folder.write("text.gltf", "hello"), "");
    check_error(folder.write("empty.glb", ""), "");
    check_error(folder.write("short.glb", std::string{"glTF\2\0\0\0\xff\0\0\0", 12}), "");
}

TEST_CASE("a missing buffer is refused by its name") {
    Folder const folder;
    auto content = triangle("");
    auto const uri = content.find("data:application");
    content.replace(uri, content.find('"', uri) - uri, "nowhere.bin");
    check_error(folder.write("buffer.gltf", content), "nowhere.bin");
}

TEST_CASE("a missing or broken texture is refused by its name") {
    Folder const folder;
    std::string const material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
    std::string const more = R"(,"textures":[{"source":0}],"images":[{"uri":"paint.png"}])";
    check_error(folder.write("texture.gltf", triangle(material, "", more)), "paint.png");
    static_cast<void>(folder.write("paint.png", "no image"));
    check_error(folder.write("texture.gltf", triangle(material, "", more)), "");
    check_error(folder.write("number.gltf", triangle(material)), "texture 0 of 0");
}

TEST_CASE("ranges and numbers that point nowhere are refused") {
    Folder const folder;
    check_error(folder.write("long.gltf", triangle("", "", "", "4000")), "reaches beyond");
    check_error(folder.write("index.gltf", triangle("", R"(,"indices":1)")), "vertex beyond");
    check_error(folder.write("accessor.gltf", triangle("", R"(,"indices":7)")), "");
    auto content = triangle("");
    content.replace(content.find(R"({"mesh":0})"), 10, R"({"mesh":0,"children":[0]})");
    check_error(folder.write("circle.gltf", content), "contain each other");
    content = triangle("");
    content.replace(content.find(R"({"mesh":0})"), 10, R"({"name":"x"})");
    check_error(folder.write("nothing.gltf", content), "no triangles");
}

TEST_CASE("nodes that are no tree are refused") {
    Folder const folder;
    auto const with_nodes = [](std::string const& nodes) {
        auto content = triangle("");
        return content.replace(content.find(R"([{"mesh":0}])"), 12, nodes);
    };
    // Each of these would take all the stack or all the memory there is.
    check_error(folder.write("shared.gltf", with_nodes(R"([{"children":[1]},{"children":[0],"mesh":0},{"children":[0]}])")), "node 0");
    check_error(folder.write("twice.gltf", with_nodes(R"([{"children":[1,1]},{"mesh":0}])")), "node 1");
    std::string chain = "[";
    for (int i = 1; i < 100000; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
    check_error(folder.write("deep.gltf", with_nodes(chain + R"({"mesh":0}])")), "deep");
}

TEST_CASE("indices that are no whole numbers, and zeros without end, are refused") {
    Folder const folder;
    auto content = triangle("", R"(,"indices":1)");
    // Floats read at an odd place are tiny.
    content.replace(content.find(R"("bufferView":1,"componentType":5121)"), 35, R"("bufferView":0,"byteOffset":13,"componentType":5126)");
    check_error(folder.write("float.gltf", content), "one of its indices is");
    content = triangle("", "", "", "200000000");
    content.erase(content.find(R"("bufferView":0,)"), 15);
    check_error(folder.write("zeros.gltf", content), "200000000");
}

TEST_CASE("cameras that see nothing are refused") {
    Folder const folder;
    auto const with_camera = [](std::string const& yfov, std::string const& scale) {
        auto content = triangle("", "", R"(,"cameras":[{"type":"perspective","perspective":{"yfov":)" + yfov + R"(,"znear":0.1}}])");
        return content.replace(content.find(R"([{"mesh":0}])"), 12, R"([{"mesh":0},{"camera":0,"scale":[)" + scale + "]}]");
    };
    CHECK(load_gltf(folder.write("good.gltf", with_camera("0.7", "2,2,2"))).camera(0).vertical_field_of_view == doctest::Approx(0.7));
    check_error(folder.write("narrow.gltf", with_camera("0", "1,1,1")), "yfov");
    check_error(folder.write("wide.gltf", with_camera("3.2", "1,1,1")), "yfov");
    check_error(folder.write("nothing.gltf", with_camera("0.7", "0,0,0")), "node 1");
    check_error(folder.write("flat.gltf", with_camera("0.7", "1,0,1")), "node 1");
}
