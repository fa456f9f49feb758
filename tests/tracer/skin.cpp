#include "worlds.hpp"

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{40, 40};

/// A sheet that faces the viewer. Its left half follows one joint, its right half another, with a smooth transition.
SceneDescription two_joints() {
    auto scene = world({0, 0, 3}, {0, 0, 0}, 50);
    Shape sheet;
    sheet.mesh = surface(16, 16, [](float u, float v) { return glm::vec3{2 * u - 1, 2 * v - 1, 0}; });
    int const still = scene.add_node(fixed({}));
    int const moving = scene.add_node([](float frame) {
        return Transform{{0, 0, 0.1f * frame}, glm::angleAxis(0.1f * frame, glm::vec3{0, 0, 1})}.matrix();
    });
    sheet.skin.joints = {still, moving};
    sheet.skin.inverse_bind.assign(2, glm::mat4{1.f});
    for (auto const& position : sheet.mesh.positions) {
        float const right = glm::clamp(position.x + 0.5f, 0.f, 1.f);
        sheet.skin.vertex_joints.emplace_back(0, 1, 0, 0);
        sheet.skin.vertex_weights.emplace_back(1 - right, right, 0, 0);
    }
    scene.instances.push_back({scene.add(std::move(sheet)), scene.add(Material{}), -1});
    return scene;
}

} // namespace

TEST_CASE("a skinned point's previous position is where its joints carried it") {
    auto const pictures = pictures_of<Channels<Position, ReceiverPrevious, Instance>>(two_joints(), {.size = size, .frame = 3});
    int fixed_points = 0, moved_points = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (pixel(pictures[instance], x, y).x == 0) continue;
            auto const now = pixel(pictures[position], x, y), before = pixel(pictures[receiver_previous], x, y);
            if (now.x < -0.65f) {
                CHECK(now == before);
                ++fixed_points;
            }
            // Where only the second joint acts: undo its placement of frame 3, apply that of frame 2.
            auto const back = glm::angleAxis(-0.1f, glm::vec3{0, 0, 1});
            if (now.x < 0.8f || now.z < 0.2999f) continue;
            CHECK(glm::distance(back * glm::vec3(now.x, now.y, 0) + glm::vec3{0, 0, 0.2f}, before) < 1e-4f);
            ++moved_points;
        }
    CHECK(fixed_points > 50);
    CHECK(moved_points > 20);
}

TEST_CASE("a deforming mesh is rebuilt every frame and remembers the frame before") {
    auto scene = world({0, 0, 3}, {0, 0, 0}, 50);
    Shape sheet;
    sheet.mesh = surface(8, 8, [](float u, float v) { return glm::vec3{2 * u - 1, 2 * v - 1, 0}; });
    sheet.deformation = [](float frame, TriangleMesh& mesh) {
        for (auto& position : mesh.positions) position.z = 0.02f * frame * frame * (1 + position.x);
    };
    scene.place(scene.add(std::move(sheet)), scene.add(Material{}));
    PreparedScene prepared{std::move(scene)};
    for (int frame : {5, 2, 9}) {
        Pictures<Channels<Position, ReceiverPrevious, Instance>> pictures{size};
        render<Channels<Position, ReceiverPrevious, Instance>>(prepared, {.size = size, .frame = frame}, pictures);
        auto const now = pixel(pictures[position], 18, 20), before = pixel(pictures[receiver_previous], 18, 20);
        auto const f = static_cast<float>(frame);
        REQUIRE(pixel(pictures[instance], 18, 20).x == 1);
        CHECK(now.z == doctest::Approx(0.02f * f * f * (1 + now.x)).epsilon(1e-4));
        CHECK(before.z == doctest::Approx(0.02f * (f - 1) * (f - 1) * (1 + now.x)).epsilon(1e-4));
        CHECK(before.x == doctest::Approx(now.x).epsilon(1e-4));
    }
}
