#include "worlds.hpp"

#include <tracer/scenes/scenes.hpp>
#include <tracer/trace_frame.hpp>
#include <tracer/view.hpp>

using namespace quell;
using namespace quell::tracer;

TEST_CASE("all rays of a lens through one place in the image meet where it is sharp, and its centre sees as a pinhole does") {
    constexpr Extent size{64, 36};
    auto pose = look_at({1, 2, 3}, {0, 0.5f, -2}, 50);
    View const pinhole{pose, size};
    pose.lens = {.radius = 0.2f, .focus = 3};
    View const view{pose, size};
    for (glm::vec2 const place : {glm::vec2(5, 7), glm::vec2(32, 18), glm::vec2(60.5f, 30)}) {
        auto const centre = view.ray(place, {0, 0}, 0);
        CHECK(glm::distance(centre.direction, pinhole.direction(place)) < 1e-6f);
        CHECK(centre.origin == pinhole.eye());
        auto const sharp = centre.origin + centre.direction * (3 / glm::dot(centre.direction, pinhole.direction({32, 18})));
        CHECK(view.depth(sharp) == doctest::Approx(3).epsilon(1e-5));
        for (glm::vec2 const on_lens : {glm::vec2(1, 0), glm::vec2(-0.6f, 0.8f), glm::vec2(0.1f, -0.4f)}) {
            auto const ray = view.ray(place, on_lens, 0);
            CHECK(glm::distance(ray.origin, centre.origin) == doctest::Approx(0.2f * glm::length(on_lens)).epsilon(1e-4));
            auto const off = sharp - ray.origin;
            CHECK(glm::length(off - ray.direction * glm::dot(off, ray.direction)) < 1e-4f);
        }
    }
}

TEST_CASE("of rays that meet a pane a part is met, in all orders, and no other ray meets it") {
    auto description = world({0, 0, 4}, {0, 0, 0});
    int const pane = description.add(Material{.coverage = {0.25f}}), wall = description.add(Material{});
    int const sheet = description.add(rectangle(20, 20));
    auto const upright = glm::angleAxis(glm::radians(90.f), glm::vec3(1, 0, 0));
    int const front = description.place(sheet, pane, {.translation = {0, 0, 1}, .rotation = upright});
    int const middle = description.place(sheet, pane, {.translation = {0, 0, 0.5f}, .rotation = upright});
    int const back = description.place(sheet, wall, {.translation = {0, 0, -2}, .rotation = upright});
    PreparedScene scene{std::move(description)};
    scene.move_to(0, 0, default_shutter_keys);
    CHECK(scene.spreads_primary_rays());
    CHECK_FALSE(scene.has_lens());
    Ray const ray{{0.1f, 0.2f, 4}, {0, 0, -1}, infinity, 0};
    int met[3] = {};
    constexpr int rays = 1600;
    for (int i = 0; i < rays; ++i) {
        auto const hit = scene.first_hit(ray, (static_cast<float>(i) + 0.5f) / rays);
        met[0] += hit.instance == front, met[1] += hit.instance == middle, met[2] += hit.instance == back;
        float const distance = hit.instance == front ? 3 : hit.instance == middle ? 3.5f : 6;
        REQUIRE(hit.distance == doctest::Approx(distance).epsilon(1e-4));
    }
    CHECK(met[0] == rays / 4);
    CHECK(met[1] == rays * 3 / 16);
    CHECK(met[2] == rays * 9 / 16);
    CHECK(scene.intersect(ray).instance == back);
    CHECK_FALSE(scene.occluded({ray.origin, ray.direction, 5.5f, 0}));
    CHECK(scene.occluded({ray.origin, ray.direction, 6.5f, 0}));
}

TEST_CASE("guides of more samples than the signal has are means, and leave the signal as it is") {
    constexpr Extent size{48, 27};
    for (std::string const name : {"lens", "pane"}) {
        CAPTURE(name);
        PreparedScene scene{built_in_scene(name)};
        using Wanted = Channels<Radiance, Albedo, Depth>;
        auto const traced = [&](int samples, int guide_samples) {
            Frame<Wanted> frame(size);
            trace_frame(scene, {.size = size, .frame = 3, .samples_per_pixel = samples, .guide_samples = guide_samples}, frame);
            return frame;
        };
        auto const one = traced(1, 0), more = traced(1, 32), truth = traced(512, 0);
        double off_one = 0, off_more = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                CHECK(one[radiance].get(x, y) == more[radiance].get(x, y));
                CHECK(one[depth].get(x, y) == more[depth].get(x, y));
                auto const wanted = truth[albedo].get(x, y);
                auto const square = [](glm::vec3 v) { return static_cast<double>(glm::dot(v, v)); };
                off_one += square(one[albedo].get(x, y) - wanted), off_more += square(more[albedo].get(x, y) - wanted);
            }
        CHECK(off_more < off_one / 8); // 1/32, but for what samples have in common
    }
}

TEST_CASE("samples of guides alone are not those of the light in the next frames") {
    constexpr Extent size{48, 27};
    auto description = world({0, 0, 4}, {0, 0, 0});
    auto const upright = glm::angleAxis(glm::radians(90.f), glm::vec3(1, 0, 0));
    int const veil = description.add(Material{.base = glm::vec3(1.f), .coverage = {0.5f}}),
              wall = description.add(Material{.base = glm::vec3(0.f)});
    int const sheet = description.add(rectangle(60, 60));
    description.place(sheet, veil, {.translation = {0, 0, 1}, .rotation = upright});
    description.place(sheet, wall, {.translation = {0, 0, -2}, .rotation = upright});
    PreparedScene scene{std::move(description)};
    auto const traced = [&](int number, int guide_samples) {
        Frame<Channels<Albedo>> frame(size);
        trace_frame(scene, {.size = size, .frame = number, .guide_samples = guide_samples}, frame);
        return frame;
    };
    // Albedo is white where the sample meets the veil, and black else. A frame's second guide sample is told by the mean of two.
    int same = 0, compared = 0;
    for (int number = 0; number < 4; ++number) {
        auto const own = traced(number, 0), both = traced(number, 2), next = traced(number + 1, 0);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto const second = 2 * both[albedo].get(x, y).x - own[albedo].get(x, y).x;
                same += std::abs(second - next[albedo].get(x, y).x) < 0.25f, ++compared;
            }
    }
    CHECK(std::abs(same - compared / 2) < compared / 20); // by chance half of them
}
