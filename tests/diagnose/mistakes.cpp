#include "sequences.hpp"

#include <limits>

using namespace quell;
using namespace quell::tests;

namespace {

/// Five frames of the good sequence, each with the same mistake.
template <class F> void check_named(std::set<Mistake> const& wanted, F&& change, Shot const& shot = {}) {
    check_found(findings(shot.size, 5,
                         [&](GoodFrame& frame, int i) {
                             fill_well(frame, shot, i);
                             change(frame, i);
                         }),
                wanted);
}
constexpr auto nothing = [](GoodFrame&, int) {};

} // namespace

TEST_CASE("nothing is said of a good sequence") {
    for (bool moves : {false, true})
        for (bool jitters : {false, true}) check_named({}, nothing, {moves, jitters});
    check_named({}, nothing, {.size = {33, 21}});
}

TEST_CASE("motion of another convention is named, in all that it differs in, with the factor") {
    for (bool known : {true, false})
        for (auto const convention : detail::motion_conventions({})) {
            auto const factor = detail::to_pixels(convention, Shot{}.size);
            auto const wrong = detail::mistakes_of(convention, {});
            Shot const shot{.jitters = known};
            // Without cameras it takes edges that move by some pixels.
            auto const found = findings(shot.size, 4, [&](GoodFrame& frame, int i) {
                fill_well(frame, shot, 12 + i);
                each(frame, motion, [&](glm::vec2 m) { return m / factor; });
                if (!known) frame.camera = {};
            });
            check_found(found, {wrong.begin(), wrong.end()});
            check_factor(found, factor);
        }
}

TEST_CASE("motion that no convention explains is named where the cameras find the past and it does not") {
    check_named({Mistake::motion_disagrees},
                [](GoodFrame& frame, int) { each(frame, motion, [](glm::vec2 m) { return glm::vec2(m.y, m.x); }); });
    check_named({Mistake::motion_scale}, [](GoodFrame& frame, int) { each(frame, motion, [](glm::vec2 m) { return 2.f * m; }); });
    check_named({Mistake::motion_disagrees}, [](GoodFrame& frame, int i) {
        std::mt19937 random(static_cast<unsigned>(i));
        std::uniform_real_distribution<float> anywhere(-50.f, 50.f);
        each(frame, motion, [&](glm::vec2) { return glm::vec2(anywhere(random), anywhere(random)); });
    });
}

TEST_CASE("motion of zero under a moving camera is named") {
    check_named({Mistake::motion_zero}, [](GoodFrame& frame, int) { each(frame, motion, [](glm::vec2) { return glm::vec2(0.f); }); });
}

TEST_CASE("motion of less than a thousandth of a pixel is none where the picture zooms, and nobody knows the camera") {
    for (float const left : {0.f, 2.7e-5f}) {
        auto const found_with_zoom = [&](bool zooms) {
            Shot const shot{.moves = false, .jitters = false};
            return findings(shot.size, 6, [&](GoodFrame& frame, int i) {
                GoodFrame still(frame.size);
                fill_well(still, shot, 0);
                fill_well(frame, shot, i);
                // The middle of the picture is enlarged, as a longer lens does.
                float const zoom = zooms ? std::pow(0.97f, static_cast<float>(i)) : 1.f;
                auto const from = [&](int x, int size) {
                    return static_cast<int>(std::lround(zoom * static_cast<float>(x - size / 2))) + size / 2;
                };
                auto const enlarge = [&](auto channel) {
                    fill(frame[channel],
                         [&](int x, int y) { return still[channel].get(from(x, frame.size.width), from(y, frame.size.height)); });
                };
                enlarge(depth), enlarge(normal), enlarge(albedo);
                std::mt19937 random(static_cast<unsigned>(i));
                std::exponential_distribution<float> light(1.f);
                fill(frame[radiance], [&](int x, int y) { return light(random) * frame[albedo].get(x, y); });
                fill(frame[motion], [&](int x, int y) { return left * glm::vec2((x + y) % 3 - 1, x % 2); });
                frame.camera = {};
            });
        };
        check_found(found_with_zoom(true), {Mistake::motion_zero});
        check_found(found_with_zoom(false), {});
    }
}

TEST_CASE("jitter in the motion is named, whether the camera moves, stands still, is known or not") {
    auto const change = [](Shot const& shot, bool known) {
        return [=](GoodFrame& frame, int i) {
            auto const left_in = shot.camera_at(i).jitter - shot.camera_at(i + 3).jitter;
            each(frame, motion, [&](glm::vec2 m) { return m + left_in; });
            if (!known) frame.camera = {};
        };
    };
    for (bool moves : {false, true}) check_named({Mistake::motion_jitter}, change({.moves = moves}, true), {.moves = moves});
    check_named({Mistake::motion_jitter}, change({.moves = false}, false), {.moves = false});
}

TEST_CASE("something large that slides by parts of a pixel is no jitter") {
    for (bool jitters : {false, true})
        for (float const speed : {0.8f, 0.4f})
            check_named({},
                        [&](GoodFrame& frame, int i) {
                            // It starts, goes on and gets faster.
                            float const step = i < 2 ? 0.f : i < 4 ? speed : 1.4f * speed;
                            for (int y = 30; y < frame.size.height; ++y)
                                for (int x = 0; x < frame.size.width; ++x) frame[motion].set(x, y, {-step, 0.f});
                        },
                        {.moves = false, .jitters = jitters});
}

TEST_CASE("jitter in the projection is named") {
    check_named({Mistake::projection_jitter}, [](GoodFrame& frame, int) {
        frame.camera.projection[2][0] += 2.f * frame.camera.jitter.x / static_cast<float>(frame.size.width);
        frame.camera.projection[2][1] -= 2.f * frame.camera.jitter.y / static_cast<float>(frame.size.height);
        frame.camera.jitter = {};
    });
}

TEST_CASE("matrices that are transposed, swapped, inverted or face backwards are named") {
    check_named({Mistake::view_transposed}, [](GoodFrame& frame, int) { frame.camera.view = glm::transpose(frame.camera.view); });
    check_named({Mistake::projection_transposed},
                [](GoodFrame& frame, int) { frame.camera.projection = glm::transpose(frame.camera.projection); });
    check_named({Mistake::matrices_swapped}, [](GoodFrame& frame, int) { std::swap(frame.camera.view, frame.camera.projection); });
    check_named({Mistake::view_inverted}, [](GoodFrame& frame, int) { frame.camera.view = glm::inverse(frame.camera.view); });
    auto const as_in_d3d = [](GoodFrame& frame, int) {
        auto const mirror = glm::scale(glm::mat4(1.f), {1, 1, -1});
        frame.camera.view = mirror * frame.camera.view, frame.camera.projection = frame.camera.projection * mirror;
    };
    check_named({Mistake::camera_faces_backwards}, as_in_d3d);
    check_named({Mistake::camera_faces_backwards, Mistake::projection_transposed}, [&](GoodFrame& frame, int i) {
        as_in_d3d(frame, i);
        frame.camera.projection = glm::transpose(frame.camera.projection);
    });
    check_named({Mistake::camera_faces_backwards, Mistake::projection_transposed, Mistake::view_transposed}, [&](GoodFrame& frame, int i) {
        as_in_d3d(frame, i);
        frame.camera.view = glm::transpose(frame.camera.view), frame.camera.projection = glm::transpose(frame.camera.projection);
    });
}

TEST_CASE("a projection with y down is named, and so are pictures whose first row is at the bottom") {
    check_named({Mistake::camera_upside_down}, [](GoodFrame& frame, int) {
        frame.camera.projection = glm::scale(glm::mat4(1.f), {1, -1, 1}) * frame.camera.projection;
    });
    auto const turned = [](GoodFrame& frame, int) {
        auto const turn = [&](auto channel) {
            auto const last = frame.size.height - 1;
            for (int y = 0; 2 * y < last; ++y)
                for (int x = 0; x < frame.size.width; ++x) {
                    auto const above = frame[channel].get(x, y);
                    frame[channel].set(x, y, frame[channel].get(x, last - y)), frame[channel].set(x, last - y, above);
                }
        };
        for_each_channel(GoodFrame::channels{}, turn);
        each(frame, motion, [](glm::vec2 m) { return glm::vec2(m.x, -m.y); });
    };
    check_named({Mistake::camera_upside_down}, turned, {.jitters = false});
}

TEST_CASE("a camera that is never set anew is named") {
    check_named({Mistake::camera_never_moves}, [](GoodFrame& frame, int) { frame.camera = Shot{.jitters = false}.camera_at(0); },
                {.jitters = false});
}

TEST_CASE("depth that is not positive or not linear is named") {
    check_named({Mistake::depth_not_positive}, [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return -z; }); });
    check_named({Mistake::depth_not_positive},
                [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return z > 6.f ? 0.f : z; }); });
    for (bool moves : {false, true}) {
        constexpr float close = 0.1f, far = 30.f;
        check_named({Mistake::depth_not_linear},
                    [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return far * (1.f - close / z) / (far - close); }); },
                    {.moves = moves});
        check_named({Mistake::depth_not_linear}, [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return close / z; }); },
                    {.moves = moves});
    }
}

TEST_CASE("depth that is NaN or -infinity is counted, and other mistakes are named all the same") {
    auto const in_part = [](GoodFrame& frame, float value) {
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x)
                if ((7 * x + y) % 10 < 3) frame[depth].set(x, y, value);
    };
    constexpr float infinity = std::numeric_limits<float>::infinity();
    check_named({}, [&](GoodFrame& frame, int) { in_part(frame, infinity); });
    check_named({Mistake::bad_guides}, [&](GoodFrame& frame, int) { in_part(frame, std::nanf("")); });
    check_named({Mistake::bad_guides}, [](GoodFrame& frame, int) { each(frame, depth, [](float) { return std::nanf(""); }); });
    check_named({Mistake::bad_guides}, [](GoodFrame& frame, int) { each(frame, depth, [](float) { return -infinity; }); });
    check_named({Mistake::bad_guides, Mistake::motion_sign}, [&](GoodFrame& frame, int) {
        in_part(frame, -infinity);
        each(frame, motion, [](glm::vec2 m) { return -m; });
    });
}

TEST_CASE("depth that never has a surface is named, but not some frames of the sky") {
    auto const found_with_sky_from = [](int first) {
        return findings({64, 36}, 12, [=](GoodFrame& frame, int i) {
            fill_well(frame, {.size = frame.size}, i);
            if (i >= first) each(frame, depth, [](float) { return std::numeric_limits<float>::infinity(); });
        });
    };
    check_found(found_with_sky_from(0), {Mistake::depth_says_nothing});
    check_found(found_with_sky_from(1), {});
}

TEST_CASE("depth that is one everywhere is named where the camera turns, but not where it slides along a wall") {
    auto const one = [](GoodFrame& frame, int) { each(frame, depth, [](float) { return 1.f; }); };
    check_named({Mistake::depth_says_nothing}, one);
    check_named({}, [&](GoodFrame& frame, int i) {
        one(frame, i);
        each(frame, normal, [](glm::vec3) { return glm::vec3(0, 0, 1); });
        frame.camera = {glm::translate(glm::mat4(1.f), {0.01f * static_cast<float>(i), 0, 0}), frame.camera.projection};
        // 0.01 at a distance of 1.
        auto const step = 0.005f * frame.camera.projection[0][0] * static_cast<float>(frame.size.width);
        each(frame, motion, [=](glm::vec2) { return glm::vec2(-step, 0.f); });
    });
}

TEST_CASE("normals that are packed, not unit or in view space are named") {
    check_named({Mistake::normal_packed}, [](GoodFrame& frame, int) { each(frame, normal, [](glm::vec3 n) { return n * 0.5f + 0.5f; }); });
    check_named({Mistake::normal_not_unit}, [](GoodFrame& frame, int) { each(frame, normal, [](glm::vec3 n) { return n * 0.9f; }); });
    check_named({Mistake::normal_in_view_space},
                [](GoodFrame& frame, int) { each(frame, normal, [&](glm::vec3 n) { return glm::mat3(frame.camera.view) * n; }); });
}

TEST_CASE("a sky at the far plane is named, and not its normals of 0") {
    auto const with_sky = [](GoodFrame& frame, int) {
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < frame.size.width; ++x)
                frame[depth].set(x, y, 1000.f), frame[normal].set(x, y, glm::vec3(0.f)), frame[motion].set(x, y, glm::vec2(0.f));
    };
    check_named({Mistake::depth_of_misses}, with_sky, {.moves = false, .jitters = false});
    check_named({Mistake::normal_not_unit}, [](GoodFrame& frame, int) { each(frame, normal, [](glm::vec3) { return glm::vec3(0.f); }); });
}

TEST_CASE("where depth is named, the sky's normals of 0 are no second mistake") {
    auto const without_sky = [](auto&& depth_of) {
        return [=](GoodFrame& frame, int) {
            fill(frame[normal], [&](int x, int y) { return is_finite(frame[depth].get(x, y)) ? frame[normal].get(x, y) : glm::vec3(0.f); });
            each(frame, depth, depth_of);
        };
    };
    Shot const yard{.place = Place::yard};
    check_named({Mistake::depth_not_positive}, without_sky([](float z) { return is_finite(z) ? z : 0.f; }), yard);
    check_named({Mistake::depth_not_linear}, without_sky([](float z) { return 0.1f / z; }), yard);
}

TEST_CASE("albedo above 1 and black albedo are named") {
    check_named({Mistake::albedo_above_one}, [](GoodFrame& frame, int) { each(frame, albedo, [](glm::vec3 a) { return a * 255.f; }); });
    check_named({Mistake::albedo_black}, [](GoodFrame& frame, int) { each(frame, albedo, [](glm::vec3) { return glm::vec3(0.f); }); });
}

TEST_CASE("samples and guides that are not finite are counted") {
    auto const found = findings({64, 48}, 2, [](GoodFrame& frame, int i) {
        fill_well(frame, {.size = frame.size}, i);
        frame[radiance].set(5, 7, {1.f, std::nanf(""), -2.f});
        frame[radiance].set(6, 7, {1.f, -2.f, 1.f});
        frame[radiance].set(7, 7, {1.f, 2.f, -1.f}); // of a wider gamut
    });
    check_found(found, {Mistake::bad_samples});
    CHECK(found[0].evidence.find("1 components that are NaN or infinite and 1 pixels of negative luminance, the first at pixel (5, 7)") !=
          std::string::npos);
    check_named({Mistake::bad_guides}, [](GoodFrame& frame, int) {
        frame[normal].set(80, 45, glm::vec3(std::nanf(""))), frame[albedo].set(1, 1, glm::vec3(1e30f * 1e30f));
        for (int x = 0; x < 40; ++x) frame[normal].set(x, 3, glm::vec3(std::nanf("")));
    });
}

TEST_CASE("a signal that is the same in every frame is named, but not one without noise") {
    check_named({Mistake::identical_frames}, [](GoodFrame& frame, int) {
        GoodFrame first(frame.size);
        fill_well(first, {}, 0);
        fill(frame[radiance], [&](int x, int y) { return first[radiance].get(x, y); });
    });
    check_named({}, [](GoodFrame& frame, int) { fill(frame[radiance], [&](int x, int y) { return frame[albedo].get(x, y); }); });
    // A host that pauses: shaded and textured.
    auto const shaded = [](GoodFrame& frame, int i) {
        fill_well(frame, {.moves = false, .jitters = false}, 0);
        frame.number = i;
        each(frame, motion, [](glm::vec2) { return glm::vec2(0.f); });
        fill(frame[radiance], [&](int x, int y) { return frame[albedo].get(x, y) / (1.f + frame[depth].get(x, y)); });
    };
    check_named({}, shaded, {.moves = false, .jitters = false});
}

TEST_CASE("edges of albedo that samples blur, since they lie anywhere in the pixel, are no albedo that is squared") {
    auto const checks = [](float x, float y) {
        return glm::vec3((static_cast<int>(x / 3.3f) + static_cast<int>(y / 3.3f)) % 2 == 0 ? 0.2f : 0.8f);
    };
    check_named({},
                [&](GoodFrame& frame, int i) {
                    std::mt19937 random(static_cast<unsigned>(i));
                    std::uniform_real_distribution<float> any(0.f, 1.f);
                    fill(frame[albedo], [&](int x, int y) { return checks(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f); });
                    fill(frame[radiance], [&](int x, int y) {
                        float const u = any(random), v = any(random), light = 2.f * any(random);
                        return light * checks(static_cast<float>(x) + u, static_cast<float>(y) + v);
                    });
                },
                {.moves = false, .jitters = false});
}

TEST_CASE("a texture that is divided by another row's albedo is not taken for noise of one seed") {
    // Dots without noise. What stays on the screen is what the wrong division makes of them.
    check_named({Mistake::signal_upside_down}, [](GoodFrame& frame, int) {
        auto const last = frame.size.height - 1;
        auto const dots = [&](int x, int y) { return glm::vec3((x / 2 + 3 * (y / 2)) % 4 == 0 && (y < 60 || x % 2) ? 0.3f : 0.8f); };
        fill(frame[albedo], dots);
        fill(frame[radiance], [&](int x, int y) { return 0.7f * dots(x, last - y); });
    });
}

TEST_CASE("a texture that looks alike where it has moved on is no noise of one seed, and noise of one seed on it is") {
    for (bool const one_seed : {false, true})
        check_named(one_seed ? std::set{Mistake::seed_repeats} : std::set<Mistake>{},
                    [&](GoodFrame& frame, int i) {
                        std::mt19937 random(one_seed ? 1u : static_cast<unsigned>(i));
                        std::gamma_distribution<float> light(16.f, 1.f / 16.f);
                        frame.camera = {};
                        // Bricks in the picture as one signal, which the camera goes along.
                        auto const is_joint = [&](int x, int y) { return y % 4 == 0 || (x + 3 * i + 5 * (y / 4)) % 16 == 0; };
                        fill(frame[depth], [](int, int y) { return 5.f + 0.02f * static_cast<float>(y); });
                        fill(frame[normal], [](int, int) { return glm::vec3(0, 0, 1); });
                        fill(frame[albedo], [](int, int) { return glm::vec3(1.f); });
                        fill(frame[motion], [](int, int) { return glm::vec2(3.f, 0.f); });
                        fill(frame[radiance], [&](int x, int y) { return glm::vec3((is_joint(x, y) ? 0.8f : 0.3f) * light(random)); });
                    },
                    {.moves = false, .jitters = false});
}

TEST_CASE("a history that never lasts is named, with the reason") {
    auto const found = findings({64, 48}, 6, [](GoodFrame& frame, int i) {
        fill_well(frame, {.size = frame.size}, i);
        frame.number = 7;
    });
    check_found(found, {Mistake::resets_every_frame});
    CHECK(found[0].evidence.find("from 7 to 7") != std::string::npos);
}

TEST_CASE("a few cuts are no mistake, and nothing is compared across them") {
    auto const cut = [](GoodFrame& frame, int i) {
        fill_well(frame, {.size = frame.size}, i < 2 ? i : i < 4 ? 60 + i : 30 + i);
        // The renderer knows of the cut as well: its first frame has no motion.
        if (i % 2 == 0) each(frame, motion, [](glm::vec2) { return glm::vec2(0.f); });
    };
    check_found(findings({64, 48}, 6, cut), {});
    CHECK_FALSE(findings({64, 48}, 6, [&](GoodFrame& frame, int i) {
                    cut(frame, i);
                    frame.number.reset();
                }).empty());
}

TEST_CASE("output that is the input is named") {
    // What was outside of the last frame has no past.
    auto const leads_nowhere = [](GoodFrame& frame, int) {
        frame.camera = {};
        each(frame, motion, [](glm::vec2) { return glm::vec2(1e6f, 3e4f); });
    };
    check_named({Mistake::output_is_input}, leads_nowhere);
    // A cut that only the motion tells of.
    check_named({}, [&](GoodFrame& frame, int i) {
        frame.camera = {};
        if (i == 2) leads_nowhere(frame, i);
    });
}
