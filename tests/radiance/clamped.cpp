#include "../frames.hpp"

using namespace quell;

TEST_CASE("light that is the same in all cones stays so where a clamp makes it darker or brighter, and where the surface is turned then") {
    constexpr Extent size{20, 12};
    constexpr Pipeline denoise{indirect, Temporal{StillMotion{}, Clamped{WithCones{RunningMean{}}}, ConeFetch{}}};
    glm::vec3 const up(0, 0, 1);
    cone::Axes<float> const axes(up);
    for (float const light : {0.5f, 2.f}) {
        Frame frame{size, denoise};
        History history{size, denoise};
        float seen = 0;
        for (int i = 0; i < 8; ++i) {
            tests::fill_still(frame);
            auto const n = i < 7 ? up : axes.at[3];
            tests::fill(frame[normal], [&](int, int) { return n; });
            tests::fill(frame[indirect_direction], [&](int, int) { return i < 6 ? axes.at[i] : n; });
            // In the last frame two adjacent pixels differ, so that turned light is within what is seen.
            float const contrast = i < 7 ? 0.f : 0.9f;
            tests::fill(frame[indirect],
                        [&](int x, int y) { return glm::vec3((i < 6 ? 1.f : light) * (1 + ((x + y) % 2 == 0 ? contrast : -contrast))); });
            auto const out = run(denoise, frame, history);
            seen = (out.get(0, 7, 5) + out.get(0, 8, 5)) / 2;
        }
        CHECK(seen == doctest::Approx(light).epsilon(2e-3));
    }
}
