#include <doctest/doctest.h>
#include <live/channels.hpp>
#include <live/core/scenes.hpp>
#include <quell/frame/frame.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

// The parts of a pixel's light, and what their motion follows from.
using namespace quell::live;

namespace {

constexpr int width = 64, height = 36;

float distance(Vector a, Vector b) { return length(a - b); }

/// A scene in which everything moves, seen by a camera that turns.
struct Shot {
    Scene scene, then;
    Cameras cameras;

    explicit Shot(int number) {
        Moment const now{1, 0.5f}, before{0.9f, 0.47f};
        scene = moving_scene(number, now, before), then = scene_by_number(number, before);
        auto orbit = within_reach(number, first_orbit(number));
        cameras.now = camera_of(orbit, width, height);
        orbit.yaw += 0.02f;
        cameras.before = camera_of(orbit, width, height);
    }
};

/// Calls visit(seen, reflectance, random numbers) for each pixel.
void for_each_seen(Shot const& shot, auto const& visit) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            auto const seen = seen_at(shot.scene, shot.cameras, {}, x, y);
            visit(seen, reflectance_of(shot.scene, seen), Random(x, y, 1, 0));
        }
}

/// What a surface gets of a light, of many directions.
Vector irradiance_by_chance(Scene const& scene, Light const& light, Vector from, Vector normal) {
    constexpr int count = 200000;
    Random random(1, 2, 3, 4);
    Vector sum;
    for (int i = 0; i < count; ++i) {
        auto const& shape = scene.shapes[std::max(0, light.shape)];
        auto const emission = light.shape < 0 ? Vector{} : scene.materials[shape.material].emission;
        auto const sample = light.kind == LightKind::rectangle ? towards_rectangle(shape, emission, from, random)
                            : light.kind == LightKind::sphere
                                ? towards_sphere(shape, emission, from, random)
                                : LightSample{.direction = in_cone(scene.sky.towards_sun, scene.sky.sun_cosine, random),
                                              .weighted = scene.sky.sun * (2 * pi * (1 - scene.sky.sun_cosine))};
        sum += sample.weighted * larger(0, dot(sample.direction, normal));
    }
    return sum * (1.f / count);
}

} // namespace

TEST_CASE("live: light without shadows is the mean of samples, above the horizon and across it") {
    Scene scene;
    int const glow = scene.add(Material{.emission = {2, 3, 4}});
    int const lamp = scene.add_box({1.4f, 0.1f, 0.9f}, {0.3f, 1.2f, 0.1f}, glow, 0.4f), globe = scene.add_sphere(0.5f, {-1, 0.4f, 0}, glow);
    scene.sky.sun = {5, 6, 7}, scene.sky.sun_cosine = cosf(0.3f), scene.sky.towards_sun = normalized({0.3f, 0.8f, -0.2f});
    Light const lights[] = {{LightKind::rectangle, lamp, 1}, {LightKind::sphere, globe, 1}, {LightKind::sun, -1, 1}};
    Vector const normals[] = {{0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, normalized({0.2f, -0.1f, 1}), {0, -1, 0}};
    Vector const from{0.2f, 0.3f, 0.2f};
    int cut = 0;
    for (auto const& light : lights)
        for (auto const normal : normals) {
            auto const exact = irradiance_of(scene, light, from, normal), mean = irradiance_by_chance(scene, light, from, normal);
            CHECK(exact.x == doctest::Approx(mean.x).epsilon(0.01).scale(1));
            CHECK(exact.z == doctest::Approx(mean.z).epsilon(0.01).scale(1));
            cut += exact.x > 0 && exact.x < 0.4f;
        }
    CHECK(cut > 2);
}

TEST_CASE("live: points of a light are as likely as what they add") {
    Scene scene;
    int const glow = scene.add(Material{.emission = {1, 1, 1}});
    int const lamp = scene.add_box({2, 0.1f, 2}, {1, 1, 0}, glow);
    Light const light{LightKind::rectangle, lamp, 1};
    // Of the half that is nearer, as much light comes as it is chosen often.
    Scene half = scene;
    half.shapes[lamp].half.x = 0.5f, half.shapes[lamp].now.centre.x = 0.5f;
    Vector const from{0, 0, 0}, normal{0, 1, 0};
    float const expected = irradiance_of(half, light, from, normal).x / irradiance_of(scene, light, from, normal).x;
    float near = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        Random random(i, 0, 0, 0);
        if (light_point(scene, light, from, normal, random).now.x < 1) near += 1;
    }
    CHECK(expected > 0.6f);
    CHECK(near / count == doctest::Approx(expected).epsilon(0.02));
}

TEST_CASE("live: the parts of light add up to what paths bring") {
    for (int number = 0; number < scene_count; ++number) {
        CAPTURE(number);
        Shot const shot(number);
        constexpr int count = 48, columns = 4;
        Vector by_parts[columns], by_paths[columns];
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                auto const seen = seen_at(shot.scene, shot.cameras, {}, x, y);
                auto const reflectance = reflectance_of(shot.scene, seen);
                int const column = x * columns / width;
                by_paths[column] += radiance_of(shot.scene, seen, {.samples = count}, x, y);
                for (int i = 0; i < count; ++i) {
                    auto const random = [&](int part) { return Random(x, y, 7, 3 * i + part); };
                    auto const direct = direct_light(shot.scene, seen, reflectance, random(0));
                    auto const all = direct.direct * direct.visibility +
                                     mirrored_light(shot.scene, seen, reflectance, 3, random(1)).radiance +
                                     reflectance.diffuse * indirect_light(shot.scene, seen, reflectance, 3, random(2)).radiance;
                    by_parts[column] += all * (1.f / count);
                }
            }
        // One visibility stands for lights of several colours: it is right in luminance.
        for (int i = 0; i < columns; ++i) CHECK(luminance(by_parts[i]) == doctest::Approx(luminance(by_paths[i])).epsilon(0.02));
    }
}

TEST_CASE("live: a blocker lies between the surface and the light, and there is one where light is hidden alone") {
    for (int number = 0; number < scene_count; ++number) {
        CAPTURE(number);
        Shot const shot(number);
        int blocked = 0, wrong = 0;
        for_each_seen(shot, [&](Seen const& seen, Reflectance const& reflectance, Random const& random) {
            auto const value = direct_light(shot.scene, seen, reflectance, random);
            bool const is_blocked = value.visibility < 1;
            wrong += is_blocked != !std::isnan(value.blocker.now.x) || is_blocked != !std::isnan(value.blocker.before.x);
            if (!is_blocked) return;
            ++blocked;
            auto const from = above(seen.hit);
            float const way = distance(from, value.light.now);
            // The way by the blocker is no detour.
            wrong += std::abs(distance(from, value.blocker.now) + distance(value.blocker.now, value.light.now) - way) > 1e-4f * way;
            wrong += !is_hidden(shot.scene, {from, normalized(value.light.now - from)}, way, -1);
        });
        CHECK(blocked > 100);
        CHECK(wrong == 0);
    }
}

TEST_CASE("live: the shadow of a moving thing from a moving light is where lights and blockers of the frame before put it") {
    for (int number = 0; number < scene_count; ++number) {
        CAPTURE(number);
        Shot const shot(number);
        int moved = 0, followed_there = 0, elsewhere = 0;
        for_each_seen(shot, [&](Seen const& seen, Reflectance const& reflectance, Random const& random) {
            auto const value = direct_light(shot.scene, seen, reflectance, random);
            if (value.visibility > 0) return;
            // The line from the light through the blocker meets the surface's plane where the shadow was.
            auto const receiver = followed(shot.scene, seen.hit);
            auto const& pose = shot.scene.shapes[seen.hit.shape].before;
            auto const normal = pose.direction_to_world(seen.hit.local_outwards);
            auto const line = value.blocker.before - value.light.before;
            auto const was = value.light.before + line * (dot(receiver.before - value.light.before, normal) / dot(line, normal));
            moved += distance(was, receiver.before) > 0.02f;
            // There, in the scene as it was, the same point of the same thing is in the way.
            auto const to_light = normalized(value.light.before - was);
            auto const hit = nearest(shot.then, {was + to_light * 2e-3f, to_light});
            bool const is_same = hit.shape >= 0 && distance(hit.point, value.blocker.before) < 0.02f;
            (is_same ? followed_there : elsewhere) += 1;
        });
        CHECK(moved > 30);
        CHECK(followed_there > 20 * elsewhere);
    }
}

TEST_CASE("live: what a mirror shows has been at the place that it is said to have been") {
    Shot const shot(1);
    int seen_in_mirrors = 0, moved = 0, wrong = 0;
    for_each_seen(shot, [&](Seen const& seen, Reflectance const& reflectance, Random const& random) {
        if (!reflectance.mirrors() || reflectance.spread > 0) return;
        auto const value = mirrored_light(shot.scene, seen, reflectance, 3, random);
        if (std::isnan(value.hit.now.x)) return;
        ++seen_in_mirrors;
        auto const from = above(seen.hit);
        auto const hit = nearest(shot.scene, {from, normalized(value.hit.now - from)});
        wrong += distance(hit.point, value.hit.now) > 1e-3f;
        auto const mirrored_direction = normalized(reflected(seen.ray.direction, seen.hit.normal));
        wrong += distance(normalized(value.hit.now - from), mirrored_direction) > 1e-3f;
        if (hit.shape < 0) return;
        wrong += distance(shot.then.shapes[hit.shape].now.to_world(hit.local), value.hit.before) > 1e-3f;
        moved += distance(value.hit.now, value.hit.before) > 0.01f;
    });
    CHECK(seen_in_mirrors > 10);
    CHECK(moved > 0);
    CHECK(wrong == 0);
}

TEST_CASE("live: a frame's channels are the same whichever others it has, and cameras see positions where their pixels are") {
    Shot const shot(0);
    quell::Extent const size{width, height};
    quell::Frame<TracedChannels> all{size};
    quell::Frame<quell::Channels<quell::Visibility, quell::IndirectDirection>> few{size};
    quell::Frame<quell::Channels<quell::Radiance, quell::Albedo>> plain{size};
    Tracing const tracing{.samples = 2, .frame = 5};
    auto const trace = [&](auto const& frame) {
        auto const views = frame.views(typename std::remove_cvref_t<decltype(frame)>::channels{});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) TracedPixel(views, x, y).trace(shot.scene, shot.cameras, tracing);
    };
    trace(all), trace(few), trace(plain);
    auto const clip_now = matrices_of(shot.cameras.now).clip_from_world(), clip_before = matrices_of(shot.cameras.before).clip_from_world();
    auto const pixel_of = [](glm::mat4 const& clip, glm::vec3 at) {
        auto const seen = clip * glm::vec4(at, 1.f);
        return glm::vec2((seen.x / seen.w + 1) * 0.5f * width, (1 - seen.y / seen.w) * 0.5f * height);
    };
    int wrong = 0, differing = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            auto const same = [&](auto channel, auto const& frame) { return all[channel].get(x, y) == frame[channel].get(x, y); };
            auto const traced = trace_pixel(shot.scene, shot.cameras, tracing, x, y);
            differing += !same(quell::visibility, few) || !same(quell::indirect_direction, few) || !same(quell::radiance, plain);
            differing += plain[quell::radiance].get(0, x, y) != traced.radiance.x || plain[quell::albedo].get(0, x, y) != traced.albedo.x;
            auto const here = pixel_of(clip_now, all[quell::position].get(x, y));
            auto const there = pixel_of(clip_before, all[quell::receiver_previous].get(x, y)) - all[quell::motion].get(x, y);
            glm::vec2 const middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            wrong += !(glm::distance(here, middle) < 1e-3f) || !(glm::distance(there, middle) < 1e-3f);
        }
    CHECK(differing == 0);
    CHECK(wrong == 0);
}
