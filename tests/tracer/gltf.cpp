#include "../shared_data.hpp"
#include "worlds.hpp"

#include <tracer/gltf/gltf.hpp>

using namespace quell;
using namespace quell::tracer;

namespace {

struct Expectation {
    char const* file;
    bool moves;
    CameraChoice camera{};
};

using Wanted = Channels<Radiance, Motion, Depth, Instance, Albedo>;
constexpr Extent size{64, 36};

float largest_motion(Pictures<Wanted> const& pictures) {
    float largest = 0;
    for (std::size_t i = 0; i < pictures[motion].pixels.size(); ++i)
        if (pictures[instance].pixels[i].x > 0) largest = std::max(largest, glm::length(pictures[motion].pixels[i]));
    return largest;
}

void check_file(std::filesystem::path const& folder, Expectation const& expected) {
    CAPTURE(expected.file);
    PreparedScene scene{load_gltf(folder / expected.file, expected.camera)};
    Pictures<Wanted> pictures{size};
    float motion_found = 0;
    for (int frame : {0, 5, 12}) {
        render<Wanted>(scene, {.size = size, .frame = frame, .samples_per_pixel = 2}, pictures);
        motion_found = std::max(motion_found, largest_motion(pictures));
    }
    std::size_t hits = 0;
    for (std::size_t i = 0; i < pictures[radiance].pixels.size(); ++i) {
        CHECK(is_finite(pictures[radiance].pixels[i]));
        CHECK(is_finite(pictures[albedo].pixels[i]));
        hits += pictures[instance].pixels[i].x > 0 ? 1 : 0;
    }
    CHECK(hits > 100);
    CHECK((motion_found > 0.2f) == expected.moves);
}

} // namespace

TEST_CASE("glTF scenes of others load, move and render" * doctest::test_suite("shared data")) {
    auto const folder = quell::tests::shared("data/scenes");
    if (folder.empty()) return;
    check_file(folder, {"milk_truck/milktruck.gltf", true, {}});
    check_file(folder, {"vintage_desk_fan/vintageFan_animated.gltf", true, {}});
    check_file(folder, {"cesium_man/CesiumMan.glb", true, {}});
    check_file(folder, {"cornell_box/cornell_bevy.glb", false, {}});
    check_file(folder, {"cornell_box/cornell_suzanne_babylon.glb", false, {}});
    check_file(folder, {"pica_diorama/pica_local.gltf", true, {.orbit = 1}});
    check_file(folder, {"sponza/sponza.gltf",
                        true,
                        {.eye = glm::vec3{-9, 2.2f, -0.3f}, .target = glm::vec3{0, 3, 0}, .field_of_view = 70.f, .dolly = {0.1f, 0, 0}}});
}

TEST_CASE("a file's own camera is used" * doctest::test_suite("shared data")) {
    auto const folder = quell::tests::shared("data/scenes");
    if (folder.empty()) return;
    auto const scene = load_gltf(folder / "cornell_box/cornell_suzanne_babylon.glb");
    CHECK(scene.camera(0).vertical_field_of_view == doctest::Approx(1.0808390484719517));
    CHECK(glm::distance(glm::vec3(scene.camera(0).world_from_camera[3]), glm::vec3{0, 1.5f, 4.5f}) < 1e-4f);
}

TEST_CASE("emissive triangles are lights" * doctest::test_suite("shared data")) {
    auto const folder = quell::tests::shared("data/scenes");
    if (folder.empty()) return;
    PreparedScene scene{load_gltf(folder / "cornell_box/cornell_bevy.glb")};
    scene.move_to(0);
    CHECK(scene.emitter_count() >= 1);
    for (std::size_t i = 0; i < scene.emitter_count(); ++i) CHECK(scene.emitter(i, 0).radiance.x == doctest::Approx(100));
}
