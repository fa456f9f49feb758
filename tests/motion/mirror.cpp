#include "../views.hpp"

#include <baselines/glossy_motion.hpp>

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{61, 24};
float const not_a_number = std::bit_cast<float>(0x7fc00000u), infinite = std::bit_cast<float>(0x7f800000u);

/// A flat mirror on the ground, in which a leaning wall is seen. `then` is all that was otherwise.
struct Reflection {
    glm::dvec3 wall_moved{0}, mirror_moved{0}; ///< from now to then
    double mirror_turned = 0;                  ///< radians, about the x axis
    double near = 0;                           ///< how far from the mirror things are, instead of the wall
    View now{{0, 6, 6}, {0, 0, 1}, size}, then{now};

    glm::dmat3 turn() const { return glm::dmat3(glm::rotate(glm::dmat4(1), mirror_turned, glm::dvec3(1, 0, 0))); }
    glm::dvec3 seen(int x, int y) const { return tests::ground(now, x, y); }
    glm::dvec3 hit(int x, int y) const {
        auto const towards = now.direction(tests::centre(x, y));
        if (near > 0) return seen(x, y) + glm::dvec3(towards.x, -towards.y, towards.z) * near;
        return tests::meet(seen(x, y), {towards.x, -towards.y, towards.z}, {0, 0, -10}, glm::normalize(glm::dvec3(0.1, -0.2, 1)));
    }
    glm::dvec3 normal_then() const { return turn() * glm::dvec3(0, 1, 0); }
    glm::dvec2 truth(int x, int y) const { return then.project(tests::mirrored(hit(x, y) + wall_moved, mirror_moved, normal_then())); }
    void fill_then(auto& frame) const { frame.camera = then.camera(); }
    void fill_now(auto& frame) const {
        frame.camera = now.camera();
        auto const f = [&](auto&& what) { return [&, what](int x, int y) { return glm::vec3(what(x, y)); }; };
        tests::fill(frame[position], f([&](int x, int y) { return seen(x, y); }));
        tests::fill(frame[receiver_previous], f([&](int x, int y) { return turn() * seen(x, y) + mirror_moved; }));
        tests::fill(frame[normal], f([&](int, int) { return glm::dvec3(0, 1, 0); }));
        tests::fill(frame[depth], [&](int x, int y) { return static_cast<float>(now.depth(seen(x, y))); });
        tests::fill(frame[glossy_hit], f([&](int x, int y) { return hit(x, y); }));
        tests::fill(frame[glossy_hit_previous], f([&](int x, int y) { return hit(x, y) + wall_moved; }));
    }
    template <class M> std::vector<glm::vec3> said(M const& source, auto&& change) const {
        return tests::places(
            source, size, [&](auto& frame) { fill_then(frame); },
            [&](auto& frame) {
                fill_now(frame);
                change(frame);
            });
    }
    template <class M> std::vector<glm::vec3> said(M const& source) const {
        return said(source, [](auto&) {});
    }
    template <class M> double error(M const& source) const {
        return tests::farthest(said(source), size, [&](int x, int y) { return truth(x, y); });
    }
};
View const elsewhere{{0.4, 6.2, 6.1}, {0.1, -0.2, 1.1}, size, {0.1, 1, 0}};

Reflection const cases[] = {
    {},
    {.wall_moved{0.4, 0.3, 0}},
    {.wall_moved{0, 0, -0.5}},
    {.mirror_moved{0, -0.2, 0}},
    {.mirror_moved{0.5, 0, 0.3}}, // along itself
    {.mirror_turned = 0.03},
    {.then = elsewhere},
    {.wall_moved{0.4, 0.3, 0.2}, .then = elsewhere},
    {.wall_moved{-0.4, 0.1, 0.2}, .mirror_moved{0.1, 0.1, 0}, .mirror_turned = -0.02, .then = elsewhere},
};
} // namespace

TEST_CASE("in a flat mirror the image of what moves is followed, with still and moving mirror and camera") {
    for (auto const& world : cases) {
        CHECK(world.error(MirrorMotion{}) < 0.05);
        CHECK(world.error(ImageMotion{}) < 0.05);
        CHECK(world.error(MirrorMotion{ThinLens{}}) < 0.05);
    }
    CHECK(cases[0].error(MirrorMotion{}) < 1e-3);
    CHECK(cases[0].error(ImageMotion{}) < 1e-3);
}

TEST_CASE("the place that is found is where a ray of then, reflected, meets the same point") {
    auto const& world = cases[8];
    auto const found = world.said(MirrorMotion{});
    double worst = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const& a = found[static_cast<std::size_t>(y * size.width + x)];
            auto const towards = world.then.direction({a.x, a.y}), n = world.normal_then();
            auto const at = tests::meet(world.then.eye, towards, world.mirror_moved, n);
            auto const onward = tests::mirrored(towards, {}, n), wanted = world.hit(x, y) + world.wall_moved - at;
            worst = std::max(worst, glm::length(wanted - onward * glm::dot(wanted, onward)) / glm::length(wanted));
        }
    CHECK(worst < 1e-3);
}

TEST_CASE("when nothing moves, ImageMotion is the identity for any hit, also one that no mirror would show there") {
    Reflection const world;
    std::mt19937 random(4);
    auto const rough = [&](auto& frame) {
        tests::fill(frame[glossy_hit], [&](int x, int y) {
            std::uniform_real_distribution<float> off(-1, 1);
            return glm::vec3(world.hit(x, y)) + glm::vec3(off(random), off(random), off(random)) * 0.5f + glm::vec3(0, 0.6f, 0);
        });
        tests::fill(frame[glossy_hit_previous], [&](int x, int y) { return frame[glossy_hit].get(x, y); });
    };
    CHECK(tests::farthest(world.said(ImageMotion{}, rough), size, tests::centre) < 1e-3);
    CHECK(tests::farthest(world.said(ImageMotion{ThinLens{}}, rough), size, tests::centre) < 1e-3);
}

TEST_CASE("roughness 0 is MirrorMotion exactly; rough surfaces are it in the mean, and scatter") {
    Reflection const world{.wall_moved{0.4, 0.3, 0.2}, .near = 2, .then = elsewhere};
    auto const mirror = world.said(MirrorMotion{});
    auto const glossy_at = [&](float r) {
        return world.said(GlossyMotion{}, [&](auto& frame) { tests::fill(frame[roughness], [&](int, int) { return r; }); });
    };
    CHECK(glossy_at(0) == mirror);
    for (float const r : {0.1f, 0.3f, 1.f}) {
        auto const places = glossy_at(r);
        glm::dvec2 mean(0), squares(0);
        auto const count = static_cast<double>(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            REQUIRE((is_finite(places[i].x) && is_finite(places[i].y)));
            glm::dvec2 const off(places[i].x - mirror[i].x, places[i].y - mirror[i].y);
            mean += off / count, squares += off * off / count;
        }
        CHECK(std::abs(mean.x) < 3.5 * std::sqrt(squares.x / count));
        CHECK(std::abs(mean.y) < 3.5 * std::sqrt(squares.y / count));
        if (r == 0.3f) CHECK((squares.x > 0.1 && squares.x < 1 && squares.y > 0.1 && squares.y < 1));
    }
}

TEST_CASE("a reflection that can't be followed is said to be none") {
    Reflection const world{.wall_moved{0.3, 0, 0}};
    auto const bad = [&](auto const& source) {
        auto const none = [&](auto channel, glm::vec3 a) {
            INFO(std::string(decltype(channel)::name) << " " << a.x << " " << a.y);
            CHECK(tests::none_valid(world.said(source, [&](auto& frame) {
                if constexpr (std::remove_reference_t<decltype(frame)>::channels::template has<Roughness>)
                    tests::fill(frame[roughness], [](int, int) { return 0.4f; });
                tests::fill(frame[channel], [&](int, int) { return a; });
            })));
        };
        for (float const a : {not_a_number, infinite, -infinite}) {
            none(glossy_hit, glm::vec3(a)), none(glossy_hit_previous, glm::vec3(a)), none(glossy_hit_previous, glm::vec3(1, a, 1));
            none(normal, glm::vec3(a)), none(receiver_previous, glm::vec3(a));
        }
        none(normal, glm::vec3(0));                      // collapsed
        none(glossy_hit_previous, glm::vec3(0, -1, -2)); // behind the mirror
        none(glossy_hit_previous, glm::vec3(0, 1, 40));  // the image is behind the camera
    };
    bad(MirrorMotion{});
    bad(ImageMotion{});
    bad(GlossyMotion{});
    bad(MirrorMotion{ThinLens{}});
}

TEST_CASE("where a reflection can't be followed the next source is asked, roughness may be anything, and all stays finite") {
    constexpr auto with = Pipeline{visibility, Temporal{FirstValid{GlossyMotion{}, StillMotion{}}, Exponential{.alpha = 0.5f}}};
    constexpr auto without = Pipeline{visibility, Temporal{StillMotion{}, Exponential{.alpha = 0.5f}}};
    Reflection const world{.wall_moved{0.9, 0, 0}};
    auto const after = [&](auto const& pipeline, auto&& change) {
        return tests::after(pipeline, Frame{size, with, without}, world, change);
    };
    auto const still = after(without, [](auto&) {});
    CHECK(tests::difference(after(with, [](auto&) {}), still) > 0.1);
    for (float const a : {not_a_number, infinite, 1e38f, 0.f}) {
        auto const broken = [&](auto channel, float r) {
            return after(with, [&](auto& frame) {
                tests::fill(frame[channel], [&](int, int) { return Value<decltype(channel)::components, float>(a); });
                if (!std::is_same_v<decltype(channel), Roughness>) tests::fill(frame[roughness], [&](int, int) { return r; });
            });
        };
        for (float const r : {0.f, 1.f}) {
            if (a != 0) CHECK(tests::difference(broken(glossy_hit_previous, r), still) == 0);
            CHECK(tests::all_finite(broken(glossy_hit_previous, r)));
            CHECK(tests::all_finite(broken(position, r)));
            CHECK(tests::all_finite(broken(receiver_previous, r)));
            CHECK(tests::all_finite(broken(normal, r)));
            CHECK(tests::all_finite(broken(depth, r)));
        }
        CHECK(tests::all_finite(broken(roughness, 0)));
    }
}
