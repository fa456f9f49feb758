#include "../frames.hpp"

#include <baselines/presets.hpp>

using namespace quell;

namespace {
constexpr Extent size{61, 24};

glm::vec3 unit(glm::vec3 a) { return a * (1 / std::sqrt(glm::dot(a, a))); }

/// Random guides, directions over the hemisphere of each pixel's normal, and light by direction.
template <class F> void fill_with(F& frame, unsigned seed, auto&& light) {
    tests::fill_randomly(frame, seed);
    std::mt19937 random(seed);
    std::normal_distribution<float> number;
    tests::fill(frame[indirect_direction], [&](int x, int y) {
        return unit(frame[normal].get(x, y) + unit(glm::vec3(number(random), number(random), number(random))) * 0.999f);
    });
    tests::fill(frame[indirect], [&](int x, int y) { return light(frame[indirect_direction].get(x, y)); });
}

template <class P> void furnace(P const& denoise) {
    Frame frame{size, denoise};
    History history{size, denoise};
    for (unsigned i = 0; i < 5; ++i) {
        fill_with(frame, i, [](glm::vec3) { return glm::vec3(1); });
        auto const out = tests::copy_of(run(denoise, frame, history));
        for (float const a : out) REQUIRE(std::abs(a - 1.f) < 1e-5f);
    }
}
template <class P> void furnace_with_nan(P const& denoise) {
    Frame frame{size, denoise};
    History history{size, denoise};
    float const bad = std::bit_cast<float>(0x7fc00000u);
    for (unsigned i = 0; i < 6; ++i) {
        fill_with(frame, i, [](glm::vec3) { return glm::vec3(1); });
        if (i == 1) frame[indirect].set(20, 9, glm::vec3(bad));
        if (i == 2) frame[indirect_direction].set(20, 9, glm::vec3(bad));
        if (i == 3) frame[normal].set(20, 9, glm::vec3(bad)), frame[normal].set(40, 12, glm::vec3(0));
        if (i == 4) frame[motion].set(20, 9, glm::vec2(bad)), frame[depth].set(40, 12, bad);
        auto const out = tests::copy_of(run(denoise, frame, history));
        for (float const a : out) REQUIRE(std::abs(a - 1.f) < 1e-5f);
    }
}
/// An environment that is brightest above one side; every pixel has the same normal, so the truth is one number.
template <class P> void static_scene(P const& denoise) {
    constexpr Extent small{32, 16};
    Frame frame{small, denoise};
    History history{small, denoise};
    std::mt19937 random(3);
    std::normal_distribution<float> number;
    glm::vec3 const n = unit({0.2f, 0.3f, 0.9f}), w = unit({0.7f, 0.7f, 0.1f});
    tests::fill_still(frame);
    tests::fill(frame[normal], [&](int, int) { return n; });
    auto const light = [&](glm::vec3 d) { return std::pow(std::max(0.f, glm::dot(w, d)), 2.f) + 0.1f; };
    double out_sum = 0, in_sum = 0;
    int count = 0;
    for (int i = 0; i < 120; ++i) {
        tests::fill(frame[indirect_direction],
                    [&](int, int) { return unit(n + unit(glm::vec3(number(random), number(random), number(random))) * 0.9999f); });
        tests::fill(frame[indirect], [&](int x, int y) { return glm::vec3(light(frame[indirect_direction].get(x, y))); });
        auto const out = tests::copy_of(run(denoise, frame, history));
        for (float const a : tests::copy_of(frame[indirect].view())) in_sum += a;
        if (i < 20) continue;
        for (float const a : out) out_sum += a, ++count;
    }
    in_sum /= 120.0 * static_cast<double>(small.pixels()) * 3;
    CHECK(out_sum / count == doctest::Approx(in_sum).epsilon(0.005));
}
} // namespace

TEST_CASE("white furnace: light of 1 from everywhere comes out as 1, whatever moves and turns") {
    furnace(presets::dual_cone(indirect));
    furnace(presets::dual_cone_paper(indirect));
}
TEST_CASE("NaN in light, directions, normals and motion neither spreads nor blackens") {
    furnace_with_nan(presets::dual_cone(indirect));
    furnace_with_nan(presets::dual_cone_paper(indirect));
}
TEST_CASE("a static scene's mean over frames is the irradiance: nothing is gained or lost by cones and filter") {
    static_scene(presets::dual_cone(indirect));
    static_scene(presets::dual_cone_paper(indirect));
}
