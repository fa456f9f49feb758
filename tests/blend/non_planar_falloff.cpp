#include "../views.hpp"

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{41, 24};
View const view({0, 0, 5}, {0, 0, 0}, size);

/// History from a fixed way off.
struct Shifted {
    glm::vec2 by;
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const p = px.position();
        return Reprojection<Real>{{p.x + by.x, p.y + by.y}, Real(1.f)};
    }
};
/// A wall that faces the camera, then at another depth: history of 1 meets a present of 0, so that what comes out is 1 - alpha. `change` is
/// made to the present.
template <class B> float kept_of_the_past(B const& blending, glm::vec2 by, float depth_then, int x, int y, auto&& change) {
    auto const pipeline = Pipeline{visibility, Temporal{Shifted{by}, blending}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    auto const see = [&](float z, float value) {
        frame.camera = view.camera();
        if constexpr (decltype(frame)::channels::template has<Depth>) {
            PixelRays const rays(frame.camera, size);
            tests::fill(frame[depth], [&](int, int) { return z; });
            tests::fill(frame[normal], [&](int, int) { return glm::vec3(0, 0, 1); });
            tests::fill(frame[position], [&](int i, int j) { return rays.position(glm::vec2(tests::centre(i, j)), z); });
            tests::fill(frame[receiver_previous], [&](int i, int j) { return frame[position].get(i, j); });
        }
        tests::fill(frame[visibility], [&](int, int) { return value; });
    };
    see(depth_then, 1.f);
    run(pipeline, frame, history);
    see(5.f, 0.f);
    change(frame);
    return run(pipeline, frame, history).get(0, x, y);
}
template <class B> float kept_of_the_past(B const& blending, glm::vec2 by, float depth_then, int x, int y) {
    return kept_of_the_past(blending, by, depth_then, x, y, [](auto&) {});
}
constexpr auto falloff = NonPlanarFalloff{Exponential{.alpha = 0.1f}};
} // namespace

TEST_CASE("on one plane, alpha is the inner policy's") {
    for (glm::vec2 const by : {glm::vec2(0), glm::vec2(9, 0), glm::vec2(-6, 7)}) {
        CHECK(kept_of_the_past(falloff, by, 5.f, 18, 9) == doctest::Approx(0.9).epsilon(1e-4));
        CHECK(kept_of_the_past(Exponential{.alpha = 0.1f}, by, 5.f, 18, 9) == doctest::Approx(0.9).epsilon(1e-4));
    }
}

TEST_CASE("off the plane by an angle, alpha is 1 - G (1 - alpha) (eq. 4)") {
    PixelRays const rays(view.camera(), size);
    glm::vec2 const by(10, 0);
    int const x = 15, y = 9;
    for (float const z : {4.95f, 4.9f, 5.1f, 4.8f, 5.2f, 4.6f, 3.f, 9.f}) {
        glm::dvec3 const here(rays.position(glm::vec2(tests::centre(x, y)), 5.f));
        glm::dvec3 const there(rays.position(glm::vec2(tests::centre(x, y)) + by, z));
        double const off = std::acos(glm::dot(glm::normalize(there - here), glm::dvec3(0, 0, 1))) - std::acos(0.0);
        double const wanted = 0.9 * std::exp(-off * off / (2 * 0.1 * 0.1));
        CHECK(std::abs(kept_of_the_past(falloff, by, z, x, y) - wanted) < 0.01);
        // One frame of history, of which half would count.
        CHECK(std::abs(kept_of_the_past(NonPlanarFalloff{RunningMean{}}, by, z, x, y) - wanted * 0.5 / 0.9) < 0.01);
    }
    CHECK(kept_of_the_past(falloff, by, 3.f, x, y) < 1e-3f);
}

TEST_CASE("what is seen at its own place again keeps its past, and a miss or NaN is no surface") {
    // Within two pixels the direction says nothing.
    CHECK(kept_of_the_past(falloff, {1, 0}, 5.02f, 18, 9) == doctest::Approx(0.9).epsilon(1e-4));
    CHECK(kept_of_the_past(falloff, {10, 0}, std::bit_cast<float>(0x7f800000u), 18, 9) == 0.f);
    CHECK(kept_of_the_past(falloff, {10, 0}, std::bit_cast<float>(0x7fc00000u), 18, 9) == 0.f);
    // Nor is it one now: where a motion source finds a past for a miss, it is not used, and nothing becomes NaN.
    for (float const nowhere : {std::bit_cast<float>(0x7f800000u), std::bit_cast<float>(0x7fc00000u)})
        CHECK(kept_of_the_past(falloff, {10, 0}, 5.f, 18, 9, [&](auto& frame) {
                  tests::fill(frame[depth], [&](int, int) { return nowhere; });
                  tests::fill(frame[position], [&](int, int) { return glm::vec3(nowhere); });
                  tests::fill(frame[receiver_previous], [&](int, int) { return glm::vec3(nowhere); });
              }) == 0.f);
    // From outside the image there is no past at all.
    CHECK(kept_of_the_past(falloff, {100, 0}, 5.f, 18, 9) == 0.f);
}

TEST_CASE("a receiver that was nowhere has no past, nor has one so far away that its distance is not finite") {
    for (float const bad : {std::bit_cast<float>(0x7fc00000u), std::bit_cast<float>(0x7f800000u)})
        CHECK(kept_of_the_past(falloff, {10, 0}, 5.f, 18, 9, [&](auto& frame) {
                  tests::fill(frame[receiver_previous], [&](int, int) { return glm::vec3(0, bad, 0); });
              }) == 0.f);
    CHECK(kept_of_the_past(falloff, {10, 0}, 3e38f, 18, 9) == 0.f);
}
