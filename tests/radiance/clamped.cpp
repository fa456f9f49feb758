#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{20, 12};

/// What a pixel shows, frame by frame, of light that comes from one cone after the other and is `light(frame)`.
template <class P> std::vector<glm::vec3> shown(P const& denoise, auto&& light) {
    Frame frame{size, denoise};
    History history{size, denoise};
    std::vector<glm::vec3> colours;
    for (int i = 0; i < 9; ++i) {
        tests::fill_still(frame);
        glm::vec3 const n(0, 0, 1), from = cone::Axes<float>(n).at[i % cone::count];
        if constexpr (decltype(frame)::channels::template has<Normal>) {
            tests::fill(frame[normal], [&](int, int) { return n; });
            tests::fill(frame[indirect_direction], [&](int, int) { return from; });
        }
        tests::fill(frame[indirect], [&](int, int) { return light(i); });
        auto const out = run(denoise, frame, history);
        colours.emplace_back(out.get(0, 7, 5), out.get(1, 7, 5), out.get(2, 7, 5));
    }
    return colours;
}
template <class B> constexpr auto in_cones(B const& blending) {
    return Pipeline{indirect, Temporal{StillMotion{}, blending}, Spatial{ConeGather{}}};
}
void check_near(std::vector<glm::vec3> const& a, std::vector<glm::vec3> const& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) CHECK(a[i][c] == doctest::Approx(b[i][c]).epsilon(1e-4));
}
} // namespace

TEST_CASE("a clamp around cones brings their light to the clamped colour, darker or brighter") {
    glm::vec3 const a(10, 1, 0), b(1, 1, 5);
    for (bool swapped : {false, true}) {
        auto const light = [&](int i) { return (i < 5) == swapped ? b : a; };
        check_near(shown(in_cones(Clamped{WithCones{RunningMean{}}}), light),
                   shown(Pipeline{indirect, Temporal{StillMotion{}, Clamped{RunningMean{}}}}, light));
    }
}

TEST_CASE("cones that a clamp leaves alone are as without it") {
    auto const light = [](int) { return glm::vec3(2); };
    check_near(shown(in_cones(Clamped{WithCones{RunningMean{}}}), light), shown(in_cones(WithCones{RunningMean{}}), light));
}
