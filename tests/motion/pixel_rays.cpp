#include "../views.hpp"

using namespace quell;
using tests::View;

TEST_CASE("a place and a depth lead to a point of the world that projects to that place and depth, for any camera") {
    Extent const size{61, 24};
    for (View const& view : {View{{0, 0, 5}, {0, 0, 0}, size}, View{{3, 4, -5}, {0.3, 1, 2}, size, {0.3, 1, 0.2}},
                             View{{-2, 9, 1}, {-2.2, 0, 1.1}, size, {1, 0.1, 0}}}) {
        PixelRays const rays(view.camera(), size);
        CHECK(glm::length(glm::dvec3(rays.eye) - view.eye) < 1e-4);
        for (glm::vec2 const where :
             {glm::vec2(0), glm::vec2(61, 24), glm::vec2(60.5f, 0.5f), glm::vec2(17.3f, 9.9f), glm::vec2(30.5f, 12)})
            for (float const depth : {0.5f, 4.f, 30.f}) {
                glm::dvec3 const point(rays.position(where, depth));
                CHECK(glm::length(view.project(point) - glm::dvec2(where)) < 1e-3);
                CHECK(view.depth(point) == doctest::Approx(depth).epsilon(1e-5));
            }
        // A pixel's side at depth 1.
        auto const a = view.eye + view.direction({30.5, 12}), b = view.eye + view.direction({31.5, 12});
        CHECK(rays.pixel_size == doctest::Approx(glm::length(b - a) / view.depth(a)).epsilon(0.02));
    }
}

TEST_CASE("lens shift and a projection with reversed depth make no difference") {
    Extent const size{40, 40};
    View const view{{3, 4, -5}, {0.3, 1, 2}, size};
    auto camera = view.camera();
    camera.projection[2][0] = 0.2f, camera.projection[2][1] = -0.1f;
    camera.projection[2][2] = 0.01f, camera.projection[3][2] = 0.1f;
    PixelRays const rays(camera, size);
    glm::vec2 const where(7.25f, 31.5f);
    auto const clip = camera.clip_from_world() * glm::vec4(rays.position(where, 3.f), 1);
    CHECK(clip.w == doctest::Approx(3).epsilon(1e-5));
    CHECK((clip.x / clip.w + 1) * 20 == doctest::Approx(where.x).epsilon(1e-4));
    CHECK((1 - clip.y / clip.w) * 20 == doctest::Approx(where.y).epsilon(1e-4));
}
