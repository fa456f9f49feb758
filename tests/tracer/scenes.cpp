#include "worlds.hpp"

#include <tracer/gltf/gltf.hpp>
#include <tracer/mask.hpp>
#include <tracer/scenes/scenes.hpp>

#include <algorithm>
#include <set>
#include <string>

using namespace quell;
using namespace quell::tracer;

TEST_CASE("an unknown scene is refused with the names of those that exist") {
    try {
        static_cast<void>(open_scene("rom"));
        FAIL("no error");
    } catch (Error const& error) {
        CHECK(error.subject.find("rom") != std::string::npos);
        for (auto const& name : scene_names()) CHECK(error.remedy.find(name) != std::string::npos);
    }
}

TEST_CASE("every scene of the table has a name of its own and was made for effects that there are") {
    std::set<std::string_view> const effects{"composite", "shadow", "glossy", "curved", "indirect", "blur"};
    std::set<std::string_view> names;
    for (auto const& scene : built_in_scenes()) {
        CAPTURE(scene.name);
        CHECK(names.insert(scene.name).second);
        CHECK(!scene.effects.empty());
        for (auto const& effect : scene.effects) CHECK(effects.contains(effect));
    }
}

TEST_CASE("every built-in scene renders finite light that moves") {
    using Wanted = Channels<Radiance, Depth, Motion, Normal, Direct>;
    constexpr Extent size{96, 54};
    for (auto const& name : scene_names()) {
        CAPTURE(name);
        PreparedScene scene{built_in_scene(name)};
        metrics::Picture first_direct;
        for (int frame : {0, 40}) {
            Pictures<Wanted> pictures{size};
            render<Wanted>(scene, {.size = size, .frame = frame, .samples_per_pixel = 4}, pictures);
            double light = 0;
            for (auto const& value : pictures[radiance].pixels) light += is_finite(value) ? value.y : -1e9;
            CHECK(light / static_cast<double>(size.pixels()) > 0.08);
            CHECK(light / static_cast<double>(size.pixels()) < 2);
            for (auto const& value : pictures[normal].pixels) CHECK(is_finite(value));
            if (frame == 0) first_direct = pictures[direct];
            bool const surfaces_move =
                std::ranges::any_of(pictures[motion].pixels, [](auto const& value) { return glm::length(value) > 0.1f; });
            bool const lights_move = frame > 0 && pictures[direct].pixels != first_direct.pixels;
            if (frame > 0) CHECK((surfaces_move || lights_move));
        }
    }
}

TEST_CASE("what a scene stands for is in full swing from frame 8 to 44") {
    struct Case {
        std::string scene;
        Effect effect;
        double least;
    };
    for (auto const& each :
         {Case{"fence", Effect::shadow, 0.3}, Case{"fence-lights", Effect::shadow, 0.3}, Case{"apples", Effect::shadow, 0.15},
          Case{"pinkroom", Effect::shadow, 0.08}, Case{"thinshadows", Effect::shadow, 0.1}, Case{"temple", Effect::glossy, 0.15},
          Case{"restaurant", Effect::glossy, 0.05}, Case{"restaurant", Effect::curved, 0.01}, Case{"boxes", Effect::indirect, 0.05},
          Case{"disk", Effect::indirect, 0.06}})
        for (int frame : {8, 44}) {
            CAPTURE(each.scene);
            CAPTURE(name_of(each.effect));
            CAPTURE(frame);
            PreparedScene prepared{built_in_scene(each.scene)};
            auto const share = share_of(effect_mask(prepared, {.size = {64, 36}, .frame = frame}, each.effect, {.use_cache = false}));
            CHECK(share > each.least);
            CHECK(share < 0.65);
        }
}

TEST_CASE("blur scenes sweep as far as they stand for, noisy in nothing but time") {
    struct Case {
        std::string scene;
        float least, most;      ///< of the longest sweeps, in pixels at 480x270
        double moving, resting; ///< least parts of the image
    };
    constexpr Extent size{96, 54};
    for (auto const& each :
         {Case{"spheres", 35, 50, 0.02, 0.8}, Case{"colonnade", 60, 90, 0.6, 0.05}, Case{"colonnade-slow", 5, 8, 0.6, 0.05},
          Case{"propeller", 110, 150, 0.04, 0.8}, Case{"roll", 30, 42, 0.99, 0}, Case{"mixed", 25, 60, 0.99, 0}}) {
        PreparedScene scene{built_in_scene(each.scene)};
        for (int frame : {0, 24, 40, 60}) {
            CAPTURE(each.scene);
            CAPTURE(frame);
            using Wanted = Channels<Radiance, Sweep>;
            Pictures<Wanted> pictures{size};
            auto const rays = render<Wanted>(scene, {.size = size, .frame = frame, .shutter = 0.5f}, pictures);
            CHECK(rays == RayCounts{.primary = size.pixels()});
            std::vector<float> lengths;
            for (auto const& value : pictures[sweep].pixels) lengths.push_back(glm::length(value) * 5);
            std::ranges::sort(lengths);
            auto const count = static_cast<double>(lengths.size());
            auto const moving = static_cast<double>(std::ranges::count_if(lengths, [](float length) { return length > 0.1f; })) / count;
            CHECK(moving > each.moving);
            CHECK(1 - moving >= each.resting);
            // But for the few pixels at the end, which may be a speck close to the camera.
            float const longest = lengths[static_cast<std::size_t>(0.998 * count)];
            CHECK(longest > each.least);
            CHECK(longest < each.most);
        }
    }
}

TEST_CASE("a scene named for an event has it at the event's frame, and not before") {
    constexpr Extent size{64, 36};
    constexpr int event = static_cast<int>(event_frame);
    using Wanted = Channels<Direct, Depth, Motion>;
    // How much of a channel's picture is another one after the next frame.
    auto const changed = [&](PreparedScene& scene, auto channel, int frame, float tolerance) {
        Pictures<Wanted> before{size}, after{size};
        render<Wanted>(scene, {.size = size, .frame = frame - 1}, before);
        render<Wanted>(scene, {.size = size, .frame = frame}, after);
        double count = 0;
        for (std::size_t i = 0; i < before[channel].pixels.size(); ++i)
            if (glm::distance(before[channel].pixels[i], after[channel].pixels[i]) > tolerance * glm::length(before[channel].pixels[i]))
                ++count;
        return count / static_cast<double>(size.pixels());
    };
    auto const check = [&](std::string const& name, auto channel, float tolerance, double max_before, double least) {
        CAPTURE(name);
        PreparedScene scene{built_in_scene(name)};
        CHECK(changed(scene, channel, event - 1, tolerance) <= max_before);
        CHECK(changed(scene, channel, event, tolerance) >= least);
    };
    check("cut", direct, 0.2f, 0.2, 0.8);
    check("lightswitch", direct, 0.2f, 0, 0.5);
    check("leaves", depth, 0.2f, 0.1, 0.12);
    check("pan", depth, 0.01f, 0, 0.3);
}

TEST_CASE("things turn back amid the event's shutter") {
    constexpr Extent size{64, 36};
    using Wanted = Channels<Sweep, Motion>;
    PreparedScene scene{built_in_scene("reverse")};
    auto const longest = [&](int frame, auto channel) {
        Pictures<Wanted> pictures{size};
        render<Wanted>(scene, {.size = size, .frame = frame, .shutter = 0.5f}, pictures);
        float most = 0;
        for (auto const& value : pictures[channel].pixels) most = std::max(most, glm::length(value));
        return most;
    };
    // Back to where they were when the shutter opened, though they move fast before and afterwards.
    CHECK(longest(static_cast<int>(event_frame), sweep) < 0.05f);
    CHECK(longest(static_cast<int>(event_frame) + 1, sweep) > 2);
    CHECK(longest(static_cast<int>(event_frame) - 1, sweep) > 2);
}

TEST_CASE("a brightness over time switches a light") {
    auto scene = world({0, 1, 0.01f}, {0, 0, 0});
    scene.place(scene.add(rectangle(4, 4)), scene.add(Material{.base = glm::vec3{0.5f}}));
    scene.place(scene.add_sphere(),
                scene.add(Material{.emission = glm::vec3{9.f}, .brightness = [](float frame) { return frame < 10 ? 0.f : 1.f; }}),
                {.translation = {0, 3, 0}});
    PreparedScene prepared{std::move(scene)};
    Pictures<Channels<Direct>> pictures{{3, 3}};
    render<Channels<Direct>>(prepared, {.size = {3, 3}, .frame = 9}, pictures);
    CHECK(pixel(pictures[direct], 1, 1).x == 0);
    render<Channels<Direct>>(prepared, {.size = {3, 3}, .frame = 10}, pictures);
    CHECK(pixel(pictures[direct], 1, 1).x > 0.1f);
}

TEST_CASE("what is scaled to nothing is not seen") {
    auto scene = world({0, 0, 3}, {0, 0, 0});
    scene.place(scene.add_sphere(), scene.add(Material{}), {.scale = glm::vec3{0.f}});
    scene.place(scene.add(box(glm::vec3{1})), scene.add(Material{}), {.scale = {1, 0, 1}});
    auto const pictures = pictures_of<Channels<Depth, Normal>>(std::move(scene), {.size = {8, 8}});
    for (auto const& value : pictures[depth].pixels) CHECK(std::isinf(value.x));
}

TEST_CASE("another camera can be chosen for any scene") {
    CameraChoice choice{.eye = glm::vec3{1, 1, 1}, .target = glm::vec3{0, 1, 0}, .field_of_view = 35.f, .orbit = 90, .dolly = {0, 0, 0.5f}};
    auto const scene = open_scene("room", choice);
    CHECK(glm::distance(glm::vec3(scene.camera(0).world_from_camera[3]), glm::vec3{1, 1, 1}) < 1e-5f);
    CHECK(glm::distance(glm::vec3(scene.camera(1).world_from_camera[3]), glm::vec3{1, 1, -0.5f}) < 1e-5f);
    CHECK(scene.camera(0).vertical_field_of_view == doctest::Approx(glm::radians(35.f)));
}
