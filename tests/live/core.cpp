#include <doctest/doctest.h>
#include <live/core/scenes.hpp>
#include <live/core/trace.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace quell::live;

namespace {

constexpr int width = 48, height = 27;

/// Mean of a function of many samples.
template <class F> Vector mean(int count, F&& sample) {
    Vector sum;
    for (int i = 0; i < count; ++i) sum += sample(i);
    return sum * (1 / static_cast<float>(count));
}

/// Light along a ray, of many paths.
Vector light_along(Scene const& scene, Ray const& ray, int surfaces, int count) {
    return mean(count, [&](int i) {
        Random random(i, 0, 1, 0);
        return Path(scene, random, ray).follow(nearest(scene, ray), surfaces);
    });
}

Camera first_camera(int scene) { return camera_of(within_reach(scene, first_orbit(scene)), width, height); }

bool is_equal(Vector a, Vector b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

} // namespace

TEST_CASE("parts of a turn are those of sine and cosine") {
    for (int i = 0; i <= 4096; ++i) {
        double const part = i / 4096., angle = 6.283185307179586 * part;
        auto const turn = turn_by(static_cast<float>(part));
        CHECK(std::abs(static_cast<double>(turn.sine) - std::sin(angle)) < 5e-7);
        CHECK(std::abs(static_cast<double>(turn.cosine) - std::cos(angle)) < 5e-7);
    }
}

TEST_CASE("live: in an even light a sphere is as bright as its reflectance") {
    Scene scene;
    scene.sky = {.zenith = {1, 1, 1}, .horizon = {1, 1, 1}};
    bool is_metal = false;
    SUBCASE("scattering") {}
    SUBCASE("metal") { is_metal = true; }
    scene.add_sphere(1, {}, scene.add(Material{.colour = {0.7f, 0.5f, 0.2f}, .is_metal = is_metal}));
    scene.close_group();
    auto const seen = light_along(scene, {{0.3f, 0.2f, 3}, {0, 0, -1}}, 4, 64);
    CHECK(seen.x == doctest::Approx(0.7));
    CHECK(seen.y == doctest::Approx(0.5));
    CHECK(seen.z == doctest::Approx(0.2));
}

TEST_CASE("live: a coat takes no light away") {
    Scene scene;
    scene.sky = {.zenith = {1, 1, 1}, .horizon = {1, 1, 1}};
    scene.add_sphere(1, {}, scene.add(Material{.colour = {1, 1, 1}, .coat = 0.2f}));
    scene.close_group();
    CHECK(light_along(scene, {{0.5f, 0.2f, 3}, {0, 0, -1}}, 4, 64).x == doctest::Approx(1));
}

TEST_CASE("live: light that is aimed at is as much as light that is met") {
    for (bool const is_ball : {false, true}) {
        Scene scene;
        int const grey = scene.add(Material{.colour = {0.5f, 0.5f, 0.5f}}), glow = scene.add(Material{.emission = {2, 2, 2}});
        scene.most_indirect = nothing_hit;
        scene.add_box({20, 0.2f, 20}, {0, -0.1f, 0}, grey);
        int const lamp = is_ball ? scene.add_sphere(1, {0.5f, 2, 0}, glow) : scene.add_box({2, 0.1f, 1.5f}, {0.5f, 1.5f, 0}, glow);
        scene.close_group();
        Ray const down{{1.5f, 0.5f, 0.5f}, {0, -1, 0}};
        auto const met = light_along(scene, down, 2, 40000);
        scene.add(Light{is_ball ? LightKind::sphere : LightKind::rectangle, lamp, 1});
        auto const aimed = light_along(scene, down, 2, 4000);
        CHECK(aimed.x > 0.05f);
        CHECK(met.x == doctest::Approx(aimed.x).epsilon(0.03));
    }
}

TEST_CASE("live: the picture is the same in any order of its pixels") {
    for (int number = 0; number < scene_count; ++number) {
        auto const scene = moving_scene(number, {1, 0.4f}, {0.9f, 0.4f});
        Cameras const cameras{first_camera(number), first_camera(number)};
        std::vector<Vector> once(width * height), again(width * height);
        for (int i = 0; i < width * height; ++i)
            once[static_cast<std::size_t>(i)] = trace_pixel(scene, cameras, {}, i % width, i / width).radiance;
        for (int i = width * height - 1; i >= 0; --i)
            again[static_cast<std::size_t>(i)] = trace_pixel(scene, cameras, {}, i % width, i / width).radiance;
        CHECK(std::ranges::equal(once, again, is_equal));
    }
}

TEST_CASE("live: motion leads to where the surface was") {
    // What a pixel shows is traced where its motion leads to, in the scene as it was: there is the same point of the same shape.
    for (int number = 0; number < scene_count; ++number) {
        Moment const now{1, 0.5f}, before{0.9f, 0.5f};
        auto const scene = moving_scene(number, now, before), then = scene_by_number(number, before);
        auto orbit = within_reach(number, first_orbit(number));
        Cameras cameras{camera_of(orbit, width, height), {}};
        orbit.yaw += 0.02f, orbit.pitch -= 0.01f, orbit.distance *= 0.99f;
        cameras.before = camera_of(orbit, width, height);
        int moved = 0, followed = 0, hidden = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                auto const value = trace_pixel(scene, cameras, {}, x, y);
                if (std::isinf(value.depth)) continue;
                ScreenPoint const at{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
                auto const hit = nearest(scene, {cameras.now.eye, cameras.now.direction(at)});
                ScreenPoint const was{at.x + value.motion.x, at.y + value.motion.y};
                auto const hit_then = nearest(then, {cameras.before.eye, cameras.before.direction(was)});
                if (hit_then.shape == hit.shape && length(hit_then.local - hit.local) < 2e-3f)
                    ++followed;
                else
                    ++hidden;
                moved += std::abs(value.motion.x) > 0.01f;
            }
        CHECK(moved > 1000);
        CHECK(followed > 20 * hidden);
    }
}

TEST_CASE("live: a still scene before a still camera has no motion, and a sky that turns with the camera has") {
    auto const scene = moving_scene(1, {1, 0.5f}, {1, 0.5f});
    auto const camera = first_camera(1);
    auto turned = camera;
    turned.forward = normalized(camera.forward + camera.right * 0.01f);
    turned.right = normalized(cross(turned.forward, {0, 1, 0}));
    turned.up = cross(turned.right, turned.forward);
    auto const still = trace_pixel(scene, {camera, camera}, {}, 20, 20), sky = trace_pixel(scene, {camera, turned}, {}, 2, 0);
    CHECK(std::abs(still.motion.x) < 1e-4f);
    CHECK(std::abs(still.motion.y) < 1e-4f);
    CHECK(std::isinf(sky.depth));
    CHECK(sky.motion.x < -0.1f);
}

TEST_CASE("live: groups of shapes hide nothing") {
    for (int number = 0; number < scene_count; ++number) {
        auto const scene = scene_by_number(number, {3, 0.3f});
        CHECK(scene.groups[scene.group_count - 1].first + scene.groups[scene.group_count - 1].count == scene.shape_count);
        Random random(1, 2, 3, 4);
        for (int i = 0; i < 2000; ++i) {
            Ray const ray{first_camera(number).eye, random.direction()};
            float closest = nothing_hit;
            for (int s = 0; s < scene.shape_count; ++s)
                closest = std::min(closest, distance_to(scene.shapes[s], ray, inverse(ray.direction)));
            CHECK(nearest(scene, ray).distance == closest);
        }
    }
}

TEST_CASE("live: scenes fit into their arrays, and guides are possible") {
    for (int number = 0; number < scene_count; ++number)
        for (float const light : {0.f, 1.f}) {
            auto const scene = scene_by_number(number, {7, light});
            CHECK(scene.shape_count <= Scene::most_shapes);
            CHECK(scene.material_count <= Scene::most_materials);
            CHECK(scene.group_count <= Scene::most_groups);
            auto const camera = first_camera(number);
            int bad = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    auto const value = trace_pixel(scene, {camera, camera}, {.samples = 2}, x, y);
                    auto const possible = [](float a) { return a >= 0 && a <= 1; };
                    bool const is_sky = std::isinf(value.depth);
                    bad += !(possible(value.albedo.x) && possible(value.albedo.y) && possible(value.albedo.z));
                    bad += !(is_sky ? length(value.normal) == 0 : std::abs(length(value.normal) - 1) < 1e-3f && value.depth > 0);
                    bad += !(std::isfinite(luminance(value.radiance)) && luminance(value.radiance) >= 0);
                }
            CHECK(bad == 0);
        }
}
