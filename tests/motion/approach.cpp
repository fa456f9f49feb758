#include "../views.hpp"

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{40, 24};
/// A camera that comes nearer to a wall by an eighth in a frame.
View const then({0, 0, 8}, {0, 0, 0}, size), now({0, 0, 7}, {0, 0, 0}, size);

/// What is left of a history of 1, of surfaces in this depth.
std::vector<float> kept(float depth_then) {
    constexpr auto pipeline = Pipeline{visibility, Temporal{PositionMotion{}, Exponential{.alpha = 1e-6f}}};
    auto const see = [](View const& view, float z, float value) {
        return [=](auto& frame) {
            frame.camera = view.camera();
            tests::fill(frame[depth], [=](int, int) { return z; });
            tests::fill(frame[normal], [](int, int) { return glm::vec3(0, 0, 1); });
            tests::fill(frame[visibility], [=](int, int) { return value; });
            tests::fill(frame[receiver_previous], [=](int x, int y) {
                return glm::vec3(tests::meet(view.eye, view.direction(tests::centre(x, y)), {}, {0, 0, 1}));
            });
        };
    };
    return tests::last_of_two(pipeline, Frame{size, pipeline}, see(then, depth_then, 1.f), see(now, 7.f, 0.f));
}
} // namespace

TEST_CASE("what comes nearer fast is looked for in the depth that it had") {
    for (float const a : kept(8.f)) REQUIRE(a == doctest::Approx(1));
    // Something else was where it is now.
    for (float const a : kept(7.f)) REQUIRE(a < 1e-3f);
}
