#include <doctest/doctest.h>
#include <quell/resolve/anti_alias.hpp>

#include <cmath>
#include <deque>
#include <limits>
#include <vector>

using namespace quell;

namespace {

constexpr Extent size{24, 9};

/// A thing in front of a wall, and what moves it: samples at the pixels' centres.
struct Scene {
    float edge = 12.f;                  ///< the thing lies left of it, in frame 0
    float speed = 0.5f;                 ///< pixels per frame, of the thing
    float in_front = 2.f, behind = 4.f; ///< depths
    float brightness = 1.f;             ///< of the wall
};

struct TestFrame {
    ImageOf<Planar<>, Albedo> colour{size}, light{size};
    ImageOf<Planar<>, Depth> depth{size};
    ImageOf<Planar<>, Motion> to_previous{size}, to_next{size};

    TestFrame(Scene const& scene, int number) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                bool const is_thing = static_cast<float>(x) + .5f < scene.edge + scene.speed * static_cast<float>(number);
                depth.view().set(0, x, y, is_thing ? scene.in_front : scene.behind);
                for (int c = 0; c < 3; ++c) {
                    colour.view().set(c, x, y, is_thing ? .25f : scene.brightness);
                    light.view().set(c, x, y, is_thing ? 2.f : 1.f);
                }
                to_previous.view().set(0, x, y, is_thing ? -scene.speed : 0.f), to_previous.view().set(1, x, y, 0.f);
                to_next.view().set(0, x, y, is_thing ? scene.speed : 0.f), to_next.view().set(1, x, y, 0.f);
            }
    }
    [[nodiscard]] ColouredFrame<> view() const { return {colour.view(), depth.view(), to_previous.view(), to_next.view()}; }
};

/// Frames -`each_side` to `each_side`, and what is made of frame 0.
struct AntiAliasedRow {
    std::deque<TestFrame> before, after;
    TestFrame here;
    ImageOf<Planar<>, Albedo> to{size};

    AntiAliasedRow(Scene const& scene, AntiAliased policy, auto const& executor, int each_side = 4, float past_brightness = 1.f)
        : here(scene, 0) {
        auto past = scene;
        past.brightness = past_brightness;
        for (int k = 1; k <= each_side; ++k) before.emplace_back(past, -k), after.emplace_back(past, k);
        std::vector<ColouredFrame<>> all_before, all_after;
        for (auto const& frame : before) all_before.push_back(frame.view());
        for (auto const& frame : after) all_after.push_back(frame.view());
        anti_alias(policy, executor, here.view(), all_before, all_after, here.light.view(), to.view());
    }
    [[nodiscard]] float at(int x) const { return to.view().get(1, x, 4); }
};

} // namespace

TEST_CASE("what one surface shows stays as it is") {
    AntiAliasedRow const made({}, {}, Simd{});
    for (int const x : {2, 7, 18, 22}) CHECK(made.at(x) == doctest::Approx(x < 12 ? .5f : 1.f).epsilon(1e-5));
}

TEST_CASE("an edge is as mixed as its pixel is covered, by light of both sides") {
    // The thing ends at 12.3: in pixel 12 it covers .3, and no single frame shows more than all or nothing.
    AntiAliasedRow const made({.edge = 12.3f, .speed = 0.37f}, {}, Simd{});
    CHECK(made.here.colour.view().get(1, 12, 4) == 1.f);
    float const covered = (1.f - made.at(12)) / (1.f - .5f);
    CHECK(covered > .15f);
    CHECK(covered < .45f);
    CHECK(made.at(14) == doctest::Approx(1.f).epsilon(1e-4));
    CHECK(made.at(10) == doctest::Approx(.5f).epsilon(1e-4));
}

TEST_CASE("a thing that touches what stands still leaves no trail on it") {
    AntiAliasedRow const made({.speed = 3.f, .in_front = 4.f}, {}, Simd{}); // no depth tells them apart
    for (int x = 14; x < size.width; ++x) CHECK(made.at(x) == doctest::Approx(1.f).epsilon(1e-5));
    AntiAliasedRow const at_rest({.speed = 0.f}, {}, Simd{});
    CHECK(at_rest.at(14) == doctest::Approx(1.f).epsilon(1e-5));
}

TEST_CASE("what changes by itself is not averaged, where that is asked for") {
    // Beside an edge: where colours are all alike, none is averaged.
    CHECK(AntiAliasedRow({}, {.change = .1f}, Simd{}, 4, 3.f).at(12) < 1.001f);
    CHECK(AntiAliasedRow({}, {}, Simd{}, 4, 3.f).at(12) > 1.2f);
    CHECK(AntiAliasedRow({}, {}, Simd{}, 4, 3.f).at(20) == 1.f);
}

TEST_CASE("means of many samples keep most of their own") {
    auto const own = [](float weight) {
        AntiAliasedRow const made({.edge = 12.3f, .speed = 0.37f}, {.own = weight, .by_surface = false}, Simd{});
        return std::abs(made.at(12) - made.here.colour.view().get(1, 12, 4) * made.here.light.view().get(1, 12, 4));
    };
    CHECK(own(1e6f) < 1e-4f);
    CHECK(own(1.f) > own(16.f));
}

TEST_CASE("no frame around, and values that are not finite") {
    AntiAliasedRow const alone({}, {}, Simd{}, 0);
    for (int x = 1; x + 1 < size.width; ++x) CHECK(std::isfinite(alone.at(x)));
    CHECK(alone.at(20) == doctest::Approx(1.f).epsilon(1e-5));
    Scene broken;
    broken.behind = std::numeric_limits<float>::infinity();
    broken.speed = std::numeric_limits<float>::quiet_NaN();
    AntiAliasedRow const made(broken, {}, Simd{});
    for (int x = 0; x < size.width; ++x) CHECK(std::isfinite(made.at(x)));
}

TEST_CASE("frames count up to the first of another size, and after this one as far as motion is known") {
    Scene const scene{.edge = 12.3f, .speed = 0.37f};
    TestFrame const here(scene, 0), first(scene, -1), second(scene, -2), next(scene, 1), after_next(scene, 2);
    auto const made = [&](ColouredFrame<> const& now, std::vector<ColouredFrame<>> const& before,
                          std::vector<ColouredFrame<>> const& after) {
        ImageOf<Planar<>, Albedo> to(size);
        anti_alias({}, Simd{}, now, before, after, here.light.view(), to.view());
        std::vector<float> row;
        for (int x = 0; x < size.width; ++x) row.push_back(to.view().get(1, x, 4));
        return row;
    };
    auto const without_next = [](TestFrame const& frame) {
        auto view = frame.view();
        view.to_next = {}, view.knows_next = false;
        return view;
    };
    ImageOf<Planar<>, Depth> const small(Extent{3, 2});
    auto const of_another_size = [&](TestFrame const& frame) {
        auto view = frame.view();
        view.depth = small.view();
        return view;
    };
    auto const plain = made(here.view(), {}, {});
    CHECK(made(here.view(), {first.view()}, {}) != plain);
    CHECK(made(here.view(), {of_another_size(first), second.view()}, {}) == plain);
    CHECK(made(here.view(), {first.view(), of_another_size(second)}, {}) == made(here.view(), {first.view()}, {}));
    auto const one_after = made(here.view(), {}, {next.view()});
    CHECK(one_after != plain);
    CHECK(made(without_next(here), {}, {next.view(), after_next.view()}) == plain);
    CHECK(made(here.view(), {}, {without_next(next), without_next(after_next)}) == one_after);
    CHECK(made(here.view(), {}, {next.view(), of_another_size(after_next)}) == one_after);
}

TEST_CASE("packs and single pixels agree") {
    AntiAliasedRow const packs({.edge = 12.3f, .speed = 0.37f}, {}, Simd{}), singles({.edge = 12.3f, .speed = 0.37f}, {}, Serial{});
    for (int x = 0; x < size.width; ++x) CHECK(packs.at(x) == doctest::Approx(singles.at(x)).epsilon(1e-5));
}
