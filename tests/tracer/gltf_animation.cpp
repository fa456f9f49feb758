#include "../temporary_folder.hpp"

#include <tracer/gltf/gltf.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace quell::tracer;

namespace {

std::string bytes_of(std::vector<float> const& numbers) {
    return {reinterpret_cast<char const*>(numbers.data()), numbers.size() * sizeof(float)};
}

/// Two nodes with a triangle, which one animation moves along x: the first by 1 within a second, the second by 2 within two seconds.
constexpr auto two_lengths = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"animations":[{"samplers":[{"input":1,"output":2},{"input":3,"output":4}],
               "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}},{"sampler":1,"target":{"node":1,"path":"translation"}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
             {"bufferView":0,"byteOffset":36,"componentType":5126,"count":2,"type":"SCALAR"},
             {"bufferView":0,"byteOffset":44,"componentType":5126,"count":2,"type":"VEC3"},
             {"bufferView":0,"byteOffset":68,"componentType":5126,"count":2,"type":"SCALAR"},
             {"bufferView":0,"byteOffset":76,"componentType":5126,"count":2,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":100}],"buffers":[{"byteLength":100,"uri":"numbers.bin"}]})";

} // namespace

TEST_CASE("an animation's channels of different lengths start over together, and the shorter hold still until then") {
    quell::tests::Folder const folder;
    quell::tests::write_bytes(folder / "moving.gltf", two_lengths);
    quell::tests::write_bytes(folder / "numbers.bin", bytes_of({0, 0, 0, 1, 0, 0, 0, 1, 0, // the triangle
                                                                0, 1, 0, 0, 0, 1, 0, 0,    // times and places of the first
                                                                0, 2, 0, 0, 0, 2, 0, 0})); // of the second
    auto const scene = load_gltf(folder / "moving.gltf");
    auto const at = [&](int node, float seconds) { return scene.node_matrix(node, seconds * frames_per_second)[3].x; };
    for (float const start : {0.f, 2.f, 6.f}) {
        INFO(start);
        CHECK(at(0, start + 0.5f) == doctest::Approx(0.5));
        CHECK(at(1, start + 0.5f) == doctest::Approx(0.5));
        CHECK(at(0, start + 1.5f) == doctest::Approx(1));
        CHECK(at(1, start + 1.5f) == doctest::Approx(1.5));
    }
}
