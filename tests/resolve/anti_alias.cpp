#include <doctest/doctest.h>
#include <quell/resolve/anti_alias.hpp>

#include <cmath>
#include <deque>
#include <limits>
#include <random>
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
    float texture = 1.f;                ///< every other column of it is so many times as bright
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
                    colour.view().set(c, x, y, is_thing ? .25f : scene.brightness * (x % 2 == 0 ? 1.f : scene.texture));
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
    AntiAliasedRow const made({.speed = 3.f, .in_front = 4.f, .texture = .9f}, {}, Simd{}); // no depth tells them apart
    for (int x = 14; x < size.width; ++x) CHECK(made.at(x) >= .9f);
    AntiAliasedRow const at_rest({.speed = 0.f}, {}, Simd{});
    CHECK(at_rest.at(14) == doctest::Approx(1.f).epsilon(1e-5));
}

TEST_CASE("of three surfaces, a wall before the sky lies behind with it, however far the sky is") {
    TestFrame const here({.speed = 0.f, .behind = 30.f}, 0);
    for (int y = 0; y < size.height; ++y)
        for (int x = 13; x < size.width; ++x) here.depth.view().set(0, x, y, std::numeric_limits<float>::infinity());
    ImageOf<Planar<>, Albedo> to(size);
    anti_alias({.deviation = .6f, .by_surface = true}, Simd{}, here.view(), {}, {}, here.light.view(), to.view());
    float const beside = std::exp(-.5f / .36f), covered = beside / (1.f + 2.f * beside); // by the thing, of the wall's only column
    CHECK(to.view().get(1, 12, 4) == doctest::Approx(covered * .5f + 1.f - covered));
}

TEST_CASE("what changes by itself is not averaged, where that is asked for") {
    // Beside an edge: where colours are all alike, none is averaged.
    CHECK(AntiAliasedRow({}, {.change = .1f}, Simd{}, 4, 3.f).at(12) < 1.001f);
    CHECK(AntiAliasedRow({}, {}, Simd{}, 4, 3.f).at(12) > 1.2f);
    CHECK(AntiAliasedRow({}, {}, Simd{}, 4, 3.f).at(20) == 1.f);
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

TEST_CASE("what goes elsewhere by more than 0.4 pixels and a part of the way says nothing, in any direction") {
    Scene const scene{.texture = .5f};
    for (float const way : {0.f, 4.f})
        for (auto const& towards : {glm::vec2(1.f, 0.f), glm::vec2(0.f, -1.f), glm::vec2(-.6f, .8f)}) {
            INFO(way, ", ", towards.x);
            TestFrame here(scene, 0), before(scene, 0);
            auto const says = [&](float off) {
                for (int y = 0; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x) {
                        here.to_previous.view().set(0, x, y, way), here.to_previous.view().set(1, x, y, 0.f);
                        before.to_next.view().set(0, x, y, off * towards.x - way), before.to_next.view().set(1, x, y, off * towards.y);
                        for (int c = 0; c < 3; ++c) before.colour.view().set(c, x, y, .9f);
                    }
                auto const made = [&](std::vector<ColouredFrame<>> const& frames) {
                    ImageOf<Planar<>, Albedo> to(size);
                    anti_alias({}, Simd{}, here.view(), frames, {}, here.light.view(), to.view());
                    std::vector<float> row;
                    for (int x = 0; x < size.width; ++x) row.push_back(to.view().get(1, x, 4));
                    return row;
                };
                return made({before.view()}) != made({});
            };
            float const most = std::sqrt(.16f + .0025f * way * way);
            CHECK(says(.99f * most));
            CHECK(!says(1.01f * most));
        }
}

TEST_CASE("each surface has the Gaussian mean of its samples in all frames, and of the pixel what it covers of all of them") {
    // Walls of random colours behind each other, seen at random places of their pixels by a camera that moves.
    constexpr glm::vec2 motion{.3f, -.2f};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(.1f, .9f);
    auto const frame_at = [&](int frame) {
        TestFrame made({}, 0);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                made.depth.view().set(0, x, y, x + y / 3 + frame < 12 ? 2.f : 4.f);
                for (int c = 0; c < 3; ++c) made.colour.view().set(c, x, y, number(random)), made.light.view().set(c, x, y, number(random));
                for (int c = 0; c < 2; ++c) made.to_previous.view().set(c, x, y, motion[c]), made.to_next.view().set(c, x, y, -motion[c]);
            }
        return made;
    };
    std::deque<TestFrame> frames;
    std::vector<ColouredFrame<>> views;
    for (int frame = 0; frame < 5; ++frame) { // this one, two before it, and two after it
        views.push_back(frames.emplace_back(frame_at(frame % 3)).view());
        views.back().jitter = {number(random) - .5f, number(random) - .5f};
    }
    auto const get = [](auto const& image, int x, int y) { return static_cast<double>(image.get(1, x, y)); };
    for (bool const by_surface : {true, false}) {
        AntiAliased const policy{.deviation = .6f, .own = .7f, .by_surface = by_surface};
        ImageOf<Planar<>, Albedo> to(size);
        anti_alias(policy, Simd{}, views[0], std::span(views).subspan(1, 2), std::span(views).subspan(3, 2), frames[0].light.view(),
                   to.view());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double weights[2]{}, colours[2]{}, lit[2]{}, lights[2]{}, whole = 0.; // of the front, and of the back
                auto const here = [&](int i, int j) { return frames[0].depth.view().get(0, i, j) < 3.f ? 0 : 1; };
                auto const add = [&](ColouredFrame<> const& frame, int surface, glm::dvec2 place) {
                    auto const from = place - glm::dvec2(frame.jitter);
                    int const column = std::clamp(static_cast<int>(std::floor(from.x)), 0, size.width - 1),
                              row = std::clamp(static_cast<int>(std::floor(from.y)), 0, size.height - 1);
                    double found = 0., sum = 0., all = 0.;
                    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, size.height - 1); ++j)
                        for (int i = std::max(column - 1, 0); i <= std::min(column + 1, size.width - 1); ++i) {
                            glm::dvec2 const off(i + .5 - from.x, j + .5 - from.y);
                            double const w = std::exp(-.5 * glm::dot(off, off) / .36);
                            all += w;
                            if ((frame.depth.get(0, i, j) < 3.f ? 0 : 1) != surface) continue;
                            found += w, sum += w * get(frame.colour, i, j);
                            if (&frame == &views[0]) lit[surface] += w, lights[surface] += w * get(frames[0].light.view(), i, j);
                        }
                    if (found > 0. && (by_surface || &frame != &views[0]))
                        weights[surface] += found, colours[surface] += sum, whole += surface == 0 ? all : 0.;
                    return found > 0.;
                };
                glm::dvec2 const centre(x + .5, y + .5), along(motion);
                for (int const surface : {0, 1}) {
                    if (!add(views[0], surface, centre)) continue;
                    for (int const side : {1, -1})
                        for (int k = 1; k <= 2; ++k) {
                            auto const place = centre + along * static_cast<double>(side * k);
                            if (place.x < 0. || place.y < 0. || place.x >= size.width || place.y >= size.height) break;
                            if (!add(views[static_cast<std::size_t>(side > 0 ? k : 2 + k)], surface, place)) break;
                        }
                }
                auto const shown = [&](int surface) {
                    double const light =
                        by_surface && here(x, y) != surface ? lights[surface] / lit[surface] : get(frames[0].light.view(), x, y);
                    return weights[surface] > 0. ? light * colours[surface] / weights[surface] : 0.;
                };
                bool const is_two = lit[0] > 0. && lit[1] > 0.;
                double const one = is_two        ? (weights[1] > 0. ? std::min(weights[0] / std::max(whole, 1e-20), 1.) : 1.)
                                   : lit[0] > 0. ? 1.
                                                 : 0.;
                double wanted = one * shown(0) + (1. - one) * shown(1);
                double const its = is_two ? whole : weights[0] + weights[1],
                             plain = get(views[0].colour, x, y) * get(frames[0].light.view(), x, y);
                if (!by_surface) wanted = (wanted * its + .7 * plain) / (its + .7);
                INFO(x, ", ", y);
                CHECK(to.view().get(1, x, y) == doctest::Approx(wanted).epsilon(1e-4));
            }
    }
}
