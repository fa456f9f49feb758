// The tests' helpers want doctest; here it only has to be there.
#define DOCTEST_CONFIG_IMPLEMENT
#include "../frames.hpp"
#include "../io/foreign.hpp"

#include <iostream>

// Writes valid little inputs for the fuzzers to start from, into folders exr, gltf and frames.
using namespace quell;
using namespace quell::tests;

namespace {

void write_exr_seeds(std::filesystem::path const& folder) {
    Frame<Channels<Radiance, Depth, Motion, Instance>> frame({4, 3});
    fill_randomly(frame, 1);
    auto image = io::image_of(frame);
    io::put_camera(image, frame.camera, "_previous");
    image.attributes["frame"] = 7;
    io::write_exr(folder / "frame.exr", image);
    write_scan_lines(folder / "window.exr", box(-1, 2, 4, 5), box(0, 1, 6, 4), {"Z"});
    write_tiles(folder / "tiles.exr", box(0, 0, 17, 3), {"Z"});
    write_parts(folder / "parts.exr", box(0, 0, 3, 2), {{"right", box(0, 0, 3, 2), {"R"}}, {"left", box(1, 0, 3, 2), {"R"}}});
    write_sub_sampled(folder / "sub_sampled.exr", 4, 4);
}

/// Two triangles on a node that turns and follows a skin, an animated child, a camera, a mask, a sparse accessor.
constexpr char scene[] =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],)"
    R"("nodes":[{"mesh":0,"children":[1],"rotation":[0,0,0,1]},{"mesh":0,"skin":0,"translation":[1,2,3]},{"camera":0,"scale":[1,1,1]}],)"
    R"("cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}],"skins":[{"joints":[0,1],"inverseBindMatrices":6}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":0,"TEXCOORD_0":3,"JOINTS_0":4,"WEIGHTS_0":5},"indices":1,"material":0},)"
    R"({"attributes":{"POSITION":2},"mode":5}]}],)"
    R"("materials":[{"alphaMode":"MASK","doubleSided":true,"emissiveFactor":[1,0,0],"emissiveTexture":{"index":0},)"
    R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":2}}}],)"
    R"("textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],"images":[{"uri":"data:image/png;base64,)"
    R"(iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSuQmCC"}],)"
    R"("animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}},{"sampler":1,"target":{"node":0,"path":"rotation"}}],)"
    R"("samplers":[{"input":7,"output":0,"interpolation":"LINEAR"},{"input":7,"output":5,"interpolation":"STEP"}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"},)"
    R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}},)"
    R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"},{"bufferView":2,"componentType":5121,"count":3,"type":"VEC4"},)"
    R"({"bufferView":3,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"},{"bufferView":4,"componentType":5126,"count":2,"type":"MAT4"},)"
    R"({"bufferView":0,"componentType":5126,"count":3,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":3},{"buffer":0,"byteOffset":40,"byteLength":12},)"
    R"({"buffer":0,"byteOffset":52,"byteLength":12},{"buffer":0,"byteLength":128}],)";

/// Positions (0 0 0) (1 0 0) (0 1 0), indices 0 1 2, joints, weights, and zeros.
std::string content() {
    std::string bytes(128, '\0');
    float const one = 1.f;
    std::memcpy(bytes.data() + 12, &one, 4);
    std::memcpy(bytes.data() + 28, &one, 4);
    for (int i = 0; i < 3; ++i) bytes[static_cast<std::size_t>(36 + i)] = static_cast<char>(i);
    for (int i = 40; i < 64; i += 5) bytes[static_cast<std::size_t>(i)] = 1;
    return bytes;
}

std::string little_endian(std::size_t number) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 255);
    return bytes;
}

void write_gltf_seeds(std::filesystem::path const& folder) {
    auto const buffer = content();
    auto text = std::string(scene) + R"("buffers":[{"byteLength":128}]})";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    write_bytes(folder / "scene.glb", "glTF" + little_endian(2) + little_endian(28 + text.size() + buffer.size()) +
                                          little_endian(text.size()) + "JSON" + text + little_endian(buffer.size()) +
                                          std::string("BIN\0", 4) + buffer);
    // A triangle of zeros: all that it refers to is in the text.
    write_bytes(folder / "scene.gltf", std::string(scene) + R"("buffers":[{"byteLength":128,"uri":"data:application/octet-stream;base64,)" +
                                           std::string(171, 'A') + R"(="}]})");
    write_bytes(folder / "small.gltf",
                R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
                R"({"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3"}]})");
}

/// Every preset, with nothing, the signal, every guide or all that there is spoilt.
void write_frame_seeds(std::filesystem::path const& folder) {
    for (int preset = 0; preset < 24; ++preset)
        for (int spoilt : {0x00, 0x01, 0xfe, 0xff}) {
            std::string bytes{static_cast<char>(preset), 12, 6, 3, 40, 0};
            bytes += std::string(4, static_cast<char>(spoilt)) + little_endian(static_cast<std::size_t>(preset));
            write_bytes(folder / (std::to_string(preset) + "_" + std::to_string(spoilt)), bytes);
        }
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "write_seeds folder\n";
        return 2;
    }
    std::filesystem::path const folder = arguments[1];
    for (auto const* const name : {"exr", "gltf", "frames"}) std::filesystem::create_directories(folder / name);
    write_exr_seeds(folder / "exr");
    write_gltf_seeds(folder / "gltf");
    write_frame_seeds(folder / "frames");
    return 0;
}
