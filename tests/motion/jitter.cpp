#include "../views.hpp"

#include <baselines/glossy_motion.hpp>

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{40, 24};
View const view({0, 6, 6}, {0, 0, 1}, size);
constexpr glm::vec2 jitter{0.375f, -0.25f};

/// A still world, of which each pixel sees what lies beside its centre: a mirror on the ground that shows a wall, and the shadow of
/// something half way to a light.
void fill(auto& frame) {
    frame.camera = view.camera();
    frame.camera.jitter = jitter;
    auto const towards = [](int x, int y) { return view.direction(tests::centre(x, y) + glm::dvec2(jitter)); };
    auto const ground = [&](int x, int y) { return tests::meet(view.eye, towards(x, y), {}, {0, 1, 0}); };
    auto const put = [&](auto channel, auto&& f) {
        if constexpr (std::remove_cvref_t<decltype(frame)>::channels::template has<decltype(channel)>)
            tests::fill(frame[channel], [&](int x, int y) { return glm::vec3(f(x, y)); });
    };
    auto const put_both = [&](auto channel, auto previous, auto&& f) { put(channel, f), put(previous, f); };
    tests::fill_still(frame);
    put_both(position, receiver_previous, ground);
    put(normal, [](int, int) { return glm::dvec3(0, 1, 0); });
    put_both(light, light_previous, [](int, int) { return glm::dvec3(1, 7, 0); });
    put_both(blocker, blocker_previous, [&](int x, int y) { return (glm::dvec3(1, 7, 0) + ground(x, y)) * 0.5; });
    put_both(glossy_hit, glossy_hit_previous, [&](int x, int y) {
        return tests::meet(ground(x, y), towards(x, y) * glm::dvec3(1, -1, 1), {0, 0, -10}, glm::normalize(glm::dvec3(0.1, -0.2, 1)));
    });
}
} // namespace

TEST_CASE_TEMPLATE("samples beside the pixels' centres don't move a still world's history", Source, PositionMotion<>, ShadowMotion,
                   MirrorMotion<>, ImageMotion<>, GlossyMotion<>) {
    auto const found = tests::places(
        Source{}, size, [](auto& frame) { fill(frame); }, [](auto& frame) { fill(frame); });
    CHECK(tests::farthest(found, size, [](int x, int y) { return tests::centre(x, y); }) < 1e-3);
}

namespace {
/// History from three pixels to the right.
struct FromTheRight {
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{{px.position().x + 3.f, px.position().y}, Real(1.f)};
    }
};
} // namespace

TEST_CASE("samples beside the pixels' centres lie on their plane") {
    constexpr auto pipeline = Pipeline{visibility, Temporal{FromTheRight{}, NonPlanarFalloff{Exponential{.alpha = 0.1f}}}};
    auto const show = [](float value) {
        return [=](auto& frame) {
            fill(frame);
            tests::fill(frame[depth], [&](int x, int y) { return static_cast<float>(view.depth(frame[position].get(x, y))); });
            tests::fill(frame[visibility], [=](int, int) { return value; });
        };
    };
    auto const out = tests::last_of_two(pipeline, Frame{size, pipeline}, show(1.f), show(0.f));
    CHECK(out[12 * size.width + 20] == doctest::Approx(0.9).epsilon(0.01));
}
