#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{32, 8};
constexpr glm::vec3 front(0, 0, 1), side(1, 0, 0);
constexpr int edge = 21; // the first column that faces to the side

/// What a pixel beside an edge shows whose history lies this far to the right: partly beyond the edge, where nothing is accepted.
template <class P> float beside_edge(P const& denoise, float to_the_right) {
    Frame frame{size, denoise};
    History history{size, denoise};
    float seen = 0;
    for (int i = 0; i < 6; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[normal], [](int x, int) { return x < edge ? front : side; });
        cone::Axes<float> const ahead(front), aside(side);
        tests::fill(frame[indirect_direction], [&](int x, int) { return (x < edge ? ahead : aside).at[i]; });
        tests::fill(frame[indirect], [&](int, int) { return glm::vec3(static_cast<float>(1 << i)); });
        if (i == 5) tests::fill(frame[motion], [&](int, int) { return glm::vec2(to_the_right, 0); });
        seen = run(denoise, frame, history).get(0, edge - 1, 4);
    }
    return seen;
}
} // namespace

TEST_CASE("cones are turned by the normal of a past that was accepted, though another is nearer") {
    constexpr auto denoise = Pipeline{indirect, Temporal{SurfaceMotion{}, WithCones{RunningMean{}}, ConeFetch{}}};
    auto const still = beside_edge(denoise, 0.f);
    // The pixel's own column is one of the two, one of the nine around, and the nearest.
    for (float const motion : {0.6f, 1.3f, 0.4f}) CHECK(beside_edge(denoise, motion) == doctest::Approx(still).epsilon(1e-5));
}
