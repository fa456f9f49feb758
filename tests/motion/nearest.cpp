#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{32, 12};
/// All of the past, but for a millionth.
constexpr auto past_only = Pipeline{visibility, Temporal{SurfaceMotion<SameDepth>{}, Exponential{.alpha = 1e-6f}, Nearest{}}};
} // namespace

TEST_CASE("the nearest fetch takes one pixel as it is, where it shows the same surface") {
    Frame frame{size, past_only};
    History history{size, past_only};
    tests::fill_still(frame);
    tests::fill(frame[depth], [](int x, int) { return x < 8 ? 30.f : 3.f; });
    tests::fill(frame[visibility], [](int x, int y) { return x % 3 == 0 && y % 2 == 0 ? 1.f : 0.25f; });
    run(past_only, frame, history);
    tests::fill(frame[motion], [](int, int) { return glm::vec2(-4.4f, 0.3f); });
    tests::fill(frame[visibility], [](int, int) { return 0.5f; });
    auto const out = run(past_only, frame, history);
    for (int y = 0; y < size.height; ++y)
        for (int x = 12; x < size.width; ++x) {
            float const seen = (x - 4) % 3 == 0 && y % 2 == 0 ? 1.f : 0.25f;
            REQUIRE(out.get(0, x, y) == doctest::Approx(seen).epsilon(1e-4));
        }
    // These came from another surface.
    for (int x = 8; x < 12; ++x) REQUIRE(out.get(0, x, 5) == doctest::Approx(0.5));
}
