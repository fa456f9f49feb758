#include "../views.hpp"

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{61, 24};

/// A strip in front of a wall, in one frame. Screen positions in pixels.
struct Strip {
    float left, width = 16;
    glm::vec2 motion, wall_motion{0}; ///< to the frame before

    [[nodiscard]] bool covers(int x) const { return static_cast<float>(x) >= left && static_cast<float>(x) < left + width; }
    void fill(auto& frame) const {
        tests::fill(frame[depth], [&](int x, int) { return covers(x) ? 3.f : 10.f; });
        tests::fill(frame[quell::motion], [&](int x, int) { return covers(x) ? motion : wall_motion; });
    }
};
std::vector<glm::vec3> said(Strip const& then, Strip const& now) {
    return tests::places(
        DualMotion{}, size, [&](auto& frame) { then.fill(frame); }, [&](auto& frame) { now.fill(frame); });
}
glm::vec2 at(std::vector<glm::vec3> const& places, int x, int y) {
    auto const& a = places[static_cast<std::size_t>(y * size.width + x)];
    CHECK(a.z > 0);
    return {a.x, a.y};
}
} // namespace

TEST_CASE("what an occluder uncovers takes its history from as far on the occluder's other side (eq. 6)") {
    // The strip goes right by 5: columns 20 to 24 are new, and x' is x less what the strip has moved by.
    auto const places = said({.left = 20, .motion{-5, 0}}, {.left = 25, .motion{-5, 0}});
    for (int x = 20; x < 25; ++x)
        for (int y = 0; y < size.height; ++y)
            CHECK(glm::length(at(places, x, y) - glm::vec2(tests::centre(x, y)) + glm::vec2(5, 0)) < 0.05f);
}

TEST_CASE("also between pixels, up and down, and when the camera moves the wall as well") {
    for (glm::vec2 const occluder : {glm::vec2(-3.4f, 0.7f), glm::vec2(-4.6f, -2.3f)})
        for (glm::vec2 const wall : {glm::vec2(0), glm::vec2(1.3f, 0.4f), glm::vec2(-1.25f, -0.6f)}) {
            float const left = 20;
            Strip const then{.left = left, .motion = occluder, .wall_motion = wall},
                now{.left = left - occluder.x, .motion = occluder, .wall_motion = wall};
            auto const places = said(then, now);
            int tested = 0;
            for (int x = 0; x < size.width; ++x)
                for (int y = 4; y < size.height - 4; ++y) {
                    // Uncovered: wall now, strip where the wall would have been.
                    int const before = static_cast<int>(std::floor(static_cast<float>(x) + 0.5f + wall.x));
                    if (now.covers(x) || before < 0 || before >= size.width || !then.covers(before)) continue;
                    CHECK(glm::length(at(places, x, y) - glm::vec2(tests::centre(x, y)) - occluder) < 0.05f);
                    ++tested;
                }
            CHECK(tested > 0);
        }
}

TEST_CASE("an occluder that speeds up or slows down is followed by what it does now") {
    auto const faster = said({.left = 20, .motion{-2, 0}}, {.left = 26, .motion{-6, 0}});
    // As long as the guess by its motion before lands on it.
    CHECK(glm::length(at(faster, 25, 9) - glm::vec2(19.5f, 9.5f)) < 0.05f);
    auto const slower = said({.left = 20, .motion{-7, 0}}, {.left = 23, .motion{-3, 0}});
    CHECK(glm::length(at(slower, 21, 9) - glm::vec2(18.5f, 9.5f)) < 0.05f);
}

TEST_CASE("a static occluder, or none, leaves every pixel where it is") {
    auto const still = said({.left = 20, .motion = glm::vec2(0)}, {.left = 20, .motion = glm::vec2(0)});
    CHECK(tests::farthest(still, size, tests::centre) < 1e-3);
    // All moving alike, where what is outside doesn't matter.
    auto const pan = said({.left = -100, .motion{1.5f, 0}, .wall_motion{1.5f, 0}}, {.left = -100, .motion{1.5f, 0}, .wall_motion{1.5f, 0}});
    for (int x = 0; x < size.width - 4; ++x) CHECK(glm::length(at(pan, x, 5) - glm::vec2(tests::centre(x, 5)) - glm::vec2(1.5f, 0)) < 1e-3);
}

TEST_CASE("history from outside the image comes from its border, also for motion that is not finite") {
    float const bad = std::bit_cast<float>(0x7fc00000u), infinite = std::bit_cast<float>(0x7f800000u);
    for (glm::vec2 const away :
         {glm::vec2(-1000, 2), glm::vec2(3, 700), glm::vec2(bad), glm::vec2(infinite, 0), glm::vec2(-infinite, bad)}) {
        auto const places = said({.left = 20, .motion = glm::vec2(0)}, {.left = 20, .motion = glm::vec2(0), .wall_motion = away});
        for (auto const& a : places) {
            REQUIRE((is_finite(a.x) && is_finite(a.y)));
            REQUIRE((a.x >= 0 && a.y >= 0 && a.x <= size.width && a.y <= size.height));
        }
    }
    // The frame before had motion that says nothing.
    auto const places = said({.left = 20, .motion = glm::vec2(bad)}, {.left = 25, .motion{-5, 0}});
    for (auto const& a : places) REQUIRE((is_finite(a.x) && is_finite(a.y)));
}

TEST_CASE("the border stands for what was a little outside the image, and for nothing that was far away, as after a cut") {
    auto const from = [](glm::vec2 wall) {
        return said({.left = -100, .motion = glm::vec2(0)}, {.left = -100, .motion = glm::vec2(0), .wall_motion = wall});
    };
    // An eighth of 61 pixels is 7.6.
    auto const panned = from({7, 0});
    CHECK(at(panned, size.width - 1, 5).x == doctest::Approx(size.width - 0.5));
    CHECK(tests::none_valid(from({400, 0})));
    CHECK(tests::none_valid(from({0, -90})));
    CHECK(tests::none_valid(from({std::bit_cast<float>(0x7fc00000u), 0})));
}

TEST_CASE("behind SurfaceMotion, only what it loses is taken from DualMotion, from the wall and not from the strip") {
    constexpr auto pipeline =
        Pipeline{visibility, Temporal{FirstValid{SurfaceMotion{SameDepth{}}, DualMotion{}}, Exponential{.alpha = 1e-6f}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_still(frame);
    Strip const then{.left = 20, .motion{-5, 0}}, now{.left = 25, .motion{-5, 0}};
    then.fill(frame);
    tests::fill(frame[visibility], [&](int x, int) { return then.covers(x) ? 100.f : static_cast<float>(x); });
    run(pipeline, frame, history);
    now.fill(frame);
    tests::fill(frame[visibility], [](int, int) { return 0.f; });
    auto const out = run(pipeline, frame, history);
    // Column 20 has the wall's own history beside it.
    for (int x = 0; x < size.width; ++x)
        CHECK(out.get(0, x, 7) == doctest::Approx(now.covers(x) ? 100 : x > 20 && x < 25 ? 0.5 * (x - 5) : x == 20 ? 19 : x).epsilon(1e-4));
}
