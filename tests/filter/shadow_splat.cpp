#include "../views.hpp"

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{61, 24};
float const nothing = std::bit_cast<float>(0x7f800000u), not_a_number = std::bit_cast<float>(0x7fc00000u);
View const view({0, 5, 6}, {0, 0, 0}, size);

/// Makes what a ShadowSplat has found the output: motion and width, or how much is known.
struct ShowTrack {
    using reads = Channels<ShadowTrack>;
    bool known = false;
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const t = px[shadow_track];
        return known ? vec3<Real>{t.w, t.w, t.w} : vec3<Real>{t.x, t.y, t.z};
    }
};
glm::dvec3 receiver(int x, int y) { return tests::ground(view, x, y); }
glm::dvec3 const lamp(0, 4, 0), moved(0.4, 0, 0);
/// The shadow of something 2 above the ground, which is all in shadow or only where `blocked` says.
template <class F> void fill_shadow(F& frame, auto&& blocked) {
    tests::fill_ground(frame, view);
    tests::fill(frame[light], [](int, int) { return glm::vec3(lamp); });
    tests::fill(frame[light_previous], [](int, int) { return glm::vec3(lamp); });
    auto const blocker_at = [&](int x, int y, glm::dvec3 by) {
        return blocked(x, y) ? glm::vec3(tests::meet(lamp, receiver(x, y) - lamp, {0, 2, 0}, {0, 1, 0}) + by) : glm::vec3(nothing);
    };
    tests::fill(frame[blocker], [&](int x, int y) { return blocker_at(x, y, {}); });
    tests::fill(frame[blocker_previous], [&](int x, int y) { return blocker_at(x, y, moved); });
}
template <class S> std::vector<glm::vec3> track(S const& splat, ShowTrack show, auto&& blocked) {
    auto const pipeline = Pipeline{radiance, Spatial{splat}, Spatial{show}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    fill_shadow(frame, blocked);
    // In a first frame the previous camera is this one.
    return tests::in_threes(tests::copy_of(run(pipeline, frame, history)));
}
auto const at = [](auto const& all, int x, int y) { return all[static_cast<std::size_t>(y * size.width + x)]; };
/// Light 4, blocker 2 above the ground: the shadow moves twice as far as the blocker.
glm::dvec2 motion_at(int x, int y) { return view.project(receiver(x, y) + moved * 2.0) - tests::centre(x, y); }
} // namespace

TEST_CASE("where no pixel is shadowed nothing is spread") {
    auto const none = [](int, int) { return false; };
    for (auto const& a : track(ShadowSplat<>{}, ShowTrack{true}, none)) REQUIRE(a.x == 0.f);
    for (auto const& a : track(ShadowSplat<>{}, ShowTrack{}, none)) REQUIRE(a == glm::vec3(0));
}

TEST_CASE("a lone shadowed pixel tells its neighbours how its shadow moves, and no one far away") {
    auto const lone = [](int x, int y) { return x == 30 && y == 12; };
    auto const motion_found = track(ShadowSplat<>{.light_size = 1.f}, ShowTrack{}, lone);
    auto const known = track(ShadowSplat<>{.light_size = 1.f}, ShowTrack{true}, lone);
    auto const wanted = motion_at(30, 12);
    for (glm::ivec2 const p : {glm::ivec2(30, 12), glm::ivec2(32, 12), glm::ivec2(28, 12), glm::ivec2(30, 14), glm::ivec2(29, 11),
                               glm::ivec2(32, 10), glm::ivec2(36, 12)}) {
        CHECK(at(known, p.x, p.y).x > 0);
        CHECK(std::abs(at(motion_found, p.x, p.y).x - wanted.x) < 0.05);
        CHECK(std::abs(at(motion_found, p.x, p.y).y - wanted.y) < 0.05);
    }
    CHECK(at(known, 30 + 13, 12).x == 0.f);
    CHECK(at(known, 30 - 13, 12).x == 0.f);
    CHECK(at(known, 2, 2).x == 0.f);
    // It knows best itself.
    CHECK(at(known, 30, 12).x > at(known, 32, 12).x);
}

TEST_CASE("in the middle of a shadow every pixel knows its motion and the width of the penumbra") {
    auto const all = track(ShadowSplat<>{.light_size = 0.5f}, ShowTrack{}, [](int, int) { return true; });
    PixelRays const rays(view.camera(), size);
    for (int y = 11; y < 13; ++y)
        for (int x = 14; x < size.width - 14; ++x) {
            // A mean over 12 pixels of what varies smoothly.
            CHECK(glm::length(glm::dvec2(at(all, x, y)) - motion_at(x, y)) < 0.2);
            // Blocker half way: the penumbra is as wide as the light.
            CHECK(at(all, x, y).z == doctest::Approx(0.5 / (view.depth(receiver(x, y)) * rays.pixel_size)).epsilon(0.05));
        }
}

TEST_CASE("the size of a light is estimated from its samples; a point has none") {
    constexpr auto pipeline = Pipeline{radiance, Spatial{ShadowSplat<>{}}, Spatial{ShowTrack{}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::mt19937 random(8);
    auto const width_for = [&](float side) {
        fill_shadow(frame, [](int, int) { return true; });
        std::uniform_real_distribution<float> part(-0.5f, 0.5f);
        tests::fill(frame[light], [&](int, int) { return glm::vec3(lamp) + glm::vec3(part(random) * side, 0, part(random) * side); });
        tests::fill(frame[light_previous], [&](int x, int y) { return frame[light].get(x, y); });
        tests::fill(frame[blocker], [&](int x, int y) {
            return glm::vec3(
                tests::meet(glm::dvec3(frame[light].get(x, y)), receiver(x, y) - glm::dvec3(frame[light].get(x, y)), {0, 2, 0}, {0, 1, 0}));
        });
        tests::fill(frame[blocker_previous], [&](int x, int y) { return frame[blocker].get(x, y); });
        auto const out = run(pipeline, frame, history);
        double sum = 0;
        for (int x = 14; x < size.width - 14; ++x) {
            REQUIRE(is_finite(out.get(2, x, 12)));
            sum += out.get(2, x, 12) * view.depth(receiver(x, 12)) * PixelRays(view.camera(), size).pixel_size / (size.width - 28);
        }
        return sum;
    };
    CHECK(width_for(0.f) < 1e-5);
    CHECK(width_for(0.8f) == doctest::Approx(0.8).epsilon(0.15));
}

TEST_CASE("a lit picture uses no history, and gets wider filters nowhere; bad samples stay finite") {
    constexpr auto pipeline = Pipeline{visibility, Spatial{ShadowSplat{}}, Temporal{SplattedShadowMotion{}, Exponential{.alpha = 0.1f}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    fill_shadow(frame, [](int, int) { return false; });
    run(pipeline, frame, history); // black: fill_still
    tests::fill(frame[visibility], [](int, int) { return 1.f; });
    for (float const a : tests::copy_of(run(pipeline, frame, history))) REQUIRE(a == 1.f);

    for (float const bad : {not_a_number, nothing, 1e38f, 0.f}) {
        auto const breaks = [&](auto channel) {
            fill_shadow(frame, [](int, int) { return true; });
            tests::fill(frame[visibility], [](int x, int) { return x % 2 ? 1.f : 0.f; });
            for (int x = 0; x < size.width; x += 3)
                frame[channel].set(x, x % size.height, Value<decltype(channel)::components, float>(bad));
            CHECK(tests::all_finite(tests::copy_of(run(pipeline, frame, history))));
            CHECK(tests::all_finite(tests::copy_of(run(pipeline, frame, history))));
        };
        breaks(light), breaks(light_previous), breaks(blocker), breaks(blocker_previous), breaks(position), breaks(normal), breaks(depth);
    }
}

namespace {
/// A shadow that comes from far to the right, and the parts of pixels that its track has.
struct FarShadow {
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{{px.position().x + 900.3125f, px.position().y}, Real(1.f)};
    }
};
struct PartsOfPixels {
    using Signal = Visibility;
    using reads = Channels<ShadowTrack>;
    QUELL_KERNEL auto filter(auto px) const {
        auto const x = px[shadow_track].x;
        return x - quell::floor(x);
    }
};
} // namespace

TEST_CASE("tracks are as exact as motion where history and scratch are in half") {
    constexpr auto show = Pipeline{visibility, Spatial{ShadowSplat<FarShadow>{}}, Spatial{PartsOfPixels{}}};
    Frame frame{size, show};
    History history{size, show, Planar<Float16>{}};
    tests::fill_still(frame);
    frame.camera = view.camera();
    tests::fill(frame[light], [](int, int) { return glm::vec3(0, 9, 0); });
    for (float const part : tests::copy_of(run(show, frame, history))) REQUIRE(part == doctest::Approx(0.3125).epsilon(0.002));
}
