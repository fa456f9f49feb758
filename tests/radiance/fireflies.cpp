#include "../frames.hpp"

#include <baselines/colour_cones.hpp>

using namespace quell;

namespace {
constexpr Extent size{32, 16};

/// What comes out where one sample is a thousand times its neighbours', and whether it is what the statistics say.
template <class P> float lone_sample(P const& denoise, bool missing_beside_it = false) {
    Frame frame{size, denoise};
    History history{size, denoise};
    tests::fill_still(frame);
    tests::fill(frame[indirect], [](int x, int y) { return glm::vec3(x == 16 && y == 8 ? 1000.f : 1.f); });
    tests::fill(frame[indirect_direction], [](int, int) { return glm::vec3(0, 0.6f, 0.8f); });
    if (missing_beside_it) frame[indirect].set(17, 8, glm::vec3(std::bit_cast<float>(0x7fc00000u)));
    auto const out = run(denoise, frame, history);
    float const seen = out.get(0, 16, 8);
    CHECK(history.statistics().suppressed == doctest::Approx(1000 - seen));
    CHECK(out.get(0, 15, 8) == doctest::Approx(1));
    return seen;
}
} // namespace

TEST_CASE("a firefly is told by its light, not by its cones, which keep what they count") {
    constexpr auto colour = Pipeline{indirect, SuppressFireflies{}, Temporal{StillMotion{}, WithCones{RunningMean{}}}};
    constexpr auto cones = Pipeline{indirect, Cones{}, SuppressFireflies{}};
    for (bool missing : {false, true}) {
        CHECK(lone_sample(colour, missing) == doctest::Approx(2));
        CHECK(lone_sample(cones, missing) == doctest::Approx(2));
    }
    CHECK(lone_sample(Pipeline{indirect, Cones{}, SuppressFireflies{.limit = 8.f}}) == doctest::Approx(8));
}
