#include "worlds.hpp"

#include <quell/core/error.hpp>
#include <tracer/gltf/gltf.hpp>

#include <string>

using namespace quell;
using namespace quell::tracer;

namespace {

/// The subject of the Error that f throws; empty where it throws none.
std::string refused(auto&& f) {
    try {
        f();
    } catch (Error const& error) {
        CHECK(!error.found.empty());
        CHECK(!error.remedy.empty());
        return error.subject;
    }
    return {};
}

SceneDescription floor_from(glm::vec3 eye, glm::vec3 target) {
    auto scene = world(eye, target);
    scene.place(scene.add(rectangle(100, 100)), scene.add(Material{}));
    return scene;
}

} // namespace

TEST_CASE("a camera looks straight down, and straight up") {
    constexpr Extent size{9, 9};
    auto const down = pictures_of<Channels<Position, Instance>>(floor_from({1, 2, 3}, {1, 0, 3}), {.size = size});
    for (auto const& each : down[instance].pixels) CHECK(each.x == 1);
    CHECK(glm::distance(pixel(down[position], 4, 4), glm::vec3{1, 0, 3}) < 1e-5f);
    // -z is at the top, x to the right, as just off the vertical.
    CHECK(pixel(down[position], 4, 0).z < 2.5f);
    CHECK(pixel(down[position], 8, 4).x > 1.5f);
    auto const nearly = pictures_of<Channels<Position>>(floor_from({1, 2, 3.01f}, {1, 0, 3}), {.size = size});
    CHECK(glm::distance(pixel(nearly[position], 8, 0), pixel(down[position], 8, 0)) < 0.05f);
    auto const up = pictures_of<Channels<Position, Instance>>(floor_from({1, -2, 3}, {1, 0, 3}), {.size = size});
    CHECK(glm::distance(pixel(up[position], 4, 4), glm::vec3{1, 0, 3}) < 1e-5f);
}

TEST_CASE("a camera of one's own that looks nowhere is refused") {
    auto const subject_of = [](CameraChoice const& choice) {
        return refused([&] {
            auto scene = floor_from({0, 2, 3}, {0, 0, 0});
            choose_camera(scene, choice);
        });
    };
    glm::vec3 const some{0, 1, 0};
    CHECK(subject_of({.eye = glm::vec3{0, 2, 0}, .target = glm::vec3{0}, .field_of_view = 179}).empty());
    CHECK(subject_of({.eye = some, .target = some}) == "--eye");
    CHECK(subject_of({.eye = glm::vec3{not_a_number, 1, 1}}) == "--eye");
    CHECK(subject_of({.eye = glm::vec3{1e30f, 1, 1}}) == "scene 'world of a test'");
    CHECK(subject_of({.target = glm::vec3{1, infinity, 1}}) == "--target");
    CHECK(subject_of({.dolly = glm::vec3{not_a_number}}) == "--dolly");
    CHECK(subject_of({.orbit = infinity}) == "--orbit");
    for (float const degrees : {0.f, 180.f, -30.f, 1e9f, not_a_number}) CHECK(subject_of({.field_of_view = degrees}) == "--fov");
}

TEST_CASE("a camera that comes to nothing on its way is refused at that frame") {
    auto scene = floor_from({0, 2, 3}, {0, 0, 0});
    scene.camera = [pose = scene.camera(0)](float frame) {
        auto shrinking = pose;
        for (int i = 0; i < 3; ++i) shrinking.world_from_camera[i] *= 3 - frame;
        return shrinking;
    };
    PreparedScene prepared{std::move(scene)};
    prepared.move_to(2);
    CHECK(refused([&] { prepared.move_to(3); }) == "scene 'world of a test'");
}
