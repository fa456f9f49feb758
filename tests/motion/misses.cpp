#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{32, 16};
float const infinite = std::bit_cast<float>(0x7f800000u), not_a_number = std::bit_cast<float>(0x7fc00000u);

/// How much is kept of a history of 1, from depth to depth and from normal to normal.
float kept(float depth_then, glm::vec3 normal_then, float depth_now, glm::vec3 normal_now) {
    constexpr auto pipeline = Pipeline{visibility, Temporal{SurfaceMotion{}, Exponential{.alpha = 0.25f}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    auto const show = [&](float z, glm::vec3 n, float value) {
        tests::fill_still(frame);
        tests::fill(frame[depth], [=](int, int) { return z; });
        tests::fill(frame[normal], [=](int, int) { return n; });
        tests::fill(frame[visibility], [=](int, int) { return value; });
        return run(pipeline, frame, history).get(0, 7, 7);
    };
    show(depth_then, normal_then, 1.f);
    return show(depth_now, normal_now, 0.f);
}
} // namespace

TEST_CASE("a miss finds the history of a miss, and no other, whatever hosts leave in its normal") {
    glm::vec3 const faces(0, 0, -1);
    for (glm::vec3 const none : {glm::vec3(0), glm::vec3(not_a_number), glm::vec3(0, 0, 1)}) {
        CHECK(kept(infinite, none, infinite, none) == 0.75f);
        CHECK(kept(4.f, faces, infinite, none) == 0.f);
        CHECK(kept(infinite, none, 4.f, faces) == 0.f);
    }
    CHECK(kept(4.f, faces, 4.f, faces) == 0.75f);
    CHECK(kept(4.f, faces, 4.f, -faces) == 0.f);
}
