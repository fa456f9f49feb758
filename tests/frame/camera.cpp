#include <quell/quell.hpp>

#include <doctest/doctest.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

using namespace quell;

TEST_CASE("a camera that looks along +z shows the same points in the same places, and its view then looks along -z") {
    glm::vec3 const eye(1, 2, -3), target(0.5f, 1, 4), up(0, 1, 0);
    auto const view = glm::lookAtLH(eye, target, up);
    // A finite range of depth, and Direct3D's reversed one without end.
    glm::mat4 endless(0.f);
    endless[0][0] = 1.2f, endless[1][1] = 2.1f, endless[2][3] = 1.f, endless[3][2] = 0.1f;
    for (auto const& projection : {glm::perspectiveLH_ZO(0.8f, 1.5f, 0.1f, 50.f), endless}) {
        auto const camera = camera_looking_along_z(view, projection, {0.25f, -0.125f});
        CHECK(camera.clip_from_world() == projection * view);
        CHECK((camera.view * glm::vec4(target, 1.f)).z < -6.f);
        CHECK(camera.jitter == glm::vec2(0.25f, -0.125f));
    }
}
