#include "../views.hpp"

using namespace quell;

namespace {
constexpr Extent size{24, 16};
tests::View const view({0, 0, 5}, {0, 0, 0}, size);

struct NormalThen {
    using reads = detail::TangentPlaneChannels;
    static constexpr bool needs_camera = true;
    QUELL_KERNEL auto filter(auto px) const { return detail::tangent_plane_then(px).normal; }
};
} // namespace

TEST_CASE("normals of then have turned with their surface, whether they face the camera or away from it") {
    constexpr auto show = Pipeline{radiance, Spatial{NormalThen{}}};
    for (double const angle : {0.05, 0.3, -0.3})
        for (double const side : {1.0, -1.0}) {
            glm::dmat3 const turn(glm::rotate(glm::dmat4(1), angle, glm::dvec3(0.6, 0.8, 0)));
            auto const wall = [](int x, int y) { return tests::meet(view.eye, view.direction(tests::centre(x, y)), {}, {0, 0, 1}); };
            Frame frame{size, show};
            History history{size, show};
            tests::fill_still(frame);
            frame.camera = view.camera();
            tests::fill(frame[position], [&](int x, int y) { return glm::vec3(wall(x, y)); });
            tests::fill(frame[receiver_previous], [&](int x, int y) { return glm::vec3(turn * wall(x, y)); });
            tests::fill(frame[normal], [&](int, int) { return glm::vec3(0, 0, side); });
            for (auto const& n : tests::in_threes(tests::copy_of(run(show, frame, history))))
                REQUIRE(glm::length(glm::dvec3(n) - turn * glm::dvec3(0, 0, side)) < 1e-3);
        }
}
