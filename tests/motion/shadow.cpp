#include "../views.hpp"

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{61, 24};
float const not_a_number = std::bit_cast<float>(0x7fc00000u), infinite = std::bit_cast<float>(0x7f800000u);

/// A point light over a ground; in every pixel something between the two is in the light's way. `then` is all that was otherwise.
struct Shadow {
    glm::dvec3 light_moved{0}, blocker_moved{0}, ground_moved{0}; ///< from now to then
    double ground_turned = 0;                                     ///< radians, about the z axis
    View now{{0, 5, 6}, {0, 0, 0}, size}, then{now};

    static constexpr glm::dvec3 light{1, 6, -1};
    glm::dmat3 turn() const { return glm::dmat3(glm::rotate(glm::dmat4(1), ground_turned, glm::dvec3(0, 0, 1))); }
    glm::dvec3 receiver(int x, int y) const { return tests::ground(now, x, y); }
    glm::dvec3 receiver_then(int x, int y) const { return turn() * receiver(x, y) + ground_moved; }
    /// The blocker is a plane 2.5 above the ground.
    glm::dvec3 blocker(int x, int y) const { return tests::meet(light, receiver(x, y) - light, {0, 2.5, 0}, {0, 1, 0}); }
    /// By similar triangles.
    glm::dvec2 truth(int x, int y) const {
        auto const l = light + light_moved, b = blocker(x, y) + blocker_moved;
        return then.project(tests::meet(l, b - l, ground_moved, turn() * glm::dvec3(0, 1, 0)));
    }
    void fill_then(auto& frame) const { frame.camera = then.camera(); }
    void fill_now(auto& frame) const {
        frame.camera = now.camera();
        auto const f = [&](auto&& what) { return [&, what](int x, int y) { return glm::vec3(what(x, y)); }; };
        tests::fill(frame[position], f([&](int x, int y) { return receiver(x, y); }));
        tests::fill(frame[receiver_previous], f([&](int x, int y) { return receiver_then(x, y); }));
        tests::fill(frame[normal], f([&](int, int) { return glm::dvec3(0, 1, 0); }));
        tests::fill(frame[quell::light], f([&](int, int) { return light; }));
        tests::fill(frame[light_previous], f([&](int, int) { return light + light_moved; }));
        tests::fill(frame[quell::blocker], f([&](int x, int y) { return blocker(x, y); }));
        tests::fill(frame[blocker_previous], f([&](int x, int y) { return blocker(x, y) + blocker_moved; }));
    }
    std::vector<glm::vec3> said(auto&& change) const {
        return tests::places(
            ShadowMotion{}, size, [&](auto& frame) { fill_then(frame); },
            [&](auto& frame) {
                fill_now(frame);
                change(frame);
            });
    }
    std::vector<glm::vec3> said() const {
        return said([](auto&) {});
    }
    double error() const {
        return tests::farthest(said(), size, [&](int x, int y) { return truth(x, y); });
    }
};
View const elsewhere{{0.4, 5.2, 6.1}, {0.1, -0.2, 0.1}, size, {0.1, 1, 0}};
} // namespace

TEST_CASE("a shadow is followed by similar triangles: blocker, light, receiver, camera, each moving and all") {
    CHECK(Shadow{}.error() < 1e-3);
    CHECK(Shadow{.blocker_moved{0.3, 0, -0.2}}.error() < 0.05);
    CHECK(Shadow{.blocker_moved{0.1, 0.2, 0}}.error() < 0.05);
    CHECK(Shadow{.light_moved{-0.4, 0.1, 0.3}}.error() < 0.05);
    CHECK(Shadow{.ground_moved{0, -0.3, 0}}.error() < 0.05);
    // Along itself the ground can move as it likes.
    CHECK(Shadow{.ground_moved{0.7, 0, -0.4}}.error() < 0.05);
    CHECK(Shadow{.ground_turned = 0.06}.error() < 0.05);
    CHECK(Shadow{.then = elsewhere}.error() < 0.05);
    CHECK(
        Shadow{.light_moved{-0.4, 0.1, 0.3}, .blocker_moved{0.3, 0.1, -0.2}, .ground_moved{0.2, -0.1, 0}, .ground_turned = -0.04}.error() <
        0.05);
    CHECK(Shadow{
              .light_moved{0.2, 0, 0.3}, .blocker_moved{0.3, 0.1, -0.2}, .ground_moved{0, 0.1, 0}, .ground_turned = 0.04, .then = elsewhere}
              .error() < 0.05);
}

TEST_CASE("a blocker moved sideways moves its shadow by the ratio of distances from the light") {
    // Light 6 above the ground, blocker 2.5: the shadow goes 6 / 3.5 times as far.
    Shadow const world{.blocker_moved{0.35, 0, 0}};
    auto const wanted = [&](int x, int y) { return world.now.project(world.receiver(x, y) + glm::dvec3(0.6, 0, 0)); };
    CHECK(tests::farthest(world.said(), size, wanted) < 0.05);
}

TEST_CASE("a shadow that can't be followed is said to be none") {
    Shadow const world{.blocker_moved{0.3, 0, 0}};
    auto const bad = [&](auto channel, auto value) {
        INFO(std::string(decltype(channel)::name));
        CHECK(tests::none_valid(world.said([&](auto& frame) { tests::fill(frame[channel], value); })));
    };
    for (float const a : {not_a_number, infinite, -infinite}) {
        auto const everywhere = [&](int, int) { return glm::vec3(a); };
        auto const one = [&](int, int) { return glm::vec3(1, a, 1); };
        bad(light_previous, everywhere), bad(blocker, everywhere), bad(blocker_previous, everywhere), bad(light_previous, one);
        bad(receiver_previous, everywhere), bad(normal, everywhere);
    }
    bad(normal, [](int, int) { return glm::vec3(0); });
    // The blocker where the light is: no direction.
    bad(blocker_previous, [](int, int) { return glm::vec3(Shadow::light); });
    // Light line along the plane.
    bad(blocker_previous, [](int x, int) { return glm::vec3(Shadow::light) + glm::vec3(static_cast<float>(x + 1), 0, 0.5f); });
    // Behind the light: the line meets the ground on the other side. Behind the receiver: before the blocker.
    bad(blocker_previous, [&](int x, int y) { return glm::vec3(Shadow::light * 2.0 - world.blocker(x, y)); });
    bad(blocker_previous, [&](int x, int y) { return glm::vec3(world.receiver(x, y) * 2.0 - Shadow::light); });
    // The place where the shadow was is behind the camera of then.
    CHECK(tests::none_valid(Shadow{.then = View{{0, 5, 6}, {0, 8, 30}, size}}.said()));
}

TEST_CASE("where a shadow can't be followed, the next source is asked, and nothing that is not finite comes out") {
    constexpr auto with = Pipeline{visibility, Temporal{FirstValid{ShadowMotion{}, StillMotion{}}, Exponential{.alpha = 0.5f}}};
    constexpr auto without = Pipeline{visibility, Temporal{StillMotion{}, Exponential{.alpha = 0.5f}}};
    Shadow const world{.blocker_moved{0.9, 0, 0}};
    auto const after = [&](auto const& pipeline, auto&& change) {
        return tests::after(pipeline, Frame{size, with, without}, world, change);
    };
    auto const still = after(without, [](auto&) {});
    CHECK(tests::difference(after(with, [](auto&) {}), still) > 0.1);
    for (float const a : {not_a_number, infinite, -infinite, 1e38f, 0.f}) {
        auto const broken = [&](auto channel) {
            return after(with, [&](auto& frame) { tests::fill(frame[channel], [&](int, int) { return glm::vec3(a); }); });
        };
        if (a != 0) CHECK(tests::difference(broken(blocker_previous), still) == 0);
        CHECK(tests::all_finite(broken(light_previous)));
        CHECK(tests::all_finite(broken(position)));
        CHECK(tests::all_finite(broken(receiver_previous)));
        CHECK(tests::all_finite(broken(normal)));
        if (a != 1e38f) CHECK(tests::difference(broken(normal), still) == 0);
    }
}
