#include "worlds.hpp"

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{48, 32};
using Wanted = Channels<Radiance, Direct, Sweep, Time, Depth, Instance, Position, Motion, ReceiverPrevious>;

/// A glowing plate that moves to the right before a dark room.
SceneDescription moving_plate() {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    auto const facing_viewer = glm::angleAxis(glm::radians(90.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(0.8f, 0.8f)), scene.add(Material{.emission = glm::vec3{1.f}}), [=](float frame) {
        return Transform{{0.5f * frame, 0, 0}, facing_viewer}.matrix();
    });
    return scene;
}

/// A disc that faces the camera and turns around the view axis by 1 radian per frame.
SceneDescription turning_disc() {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    auto const facing_viewer = glm::angleAxis(glm::radians(90.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(2, 2)), scene.add(Material{}), [=](float frame) {
        return glm::rotate(glm::mat4{1.f}, frame, {0, 0, 1}) * glm::mat4_cast(facing_viewer);
    });
    return scene;
}

using Path = Channels<Sweep, SweepBend, Time, Position, Instance>;

/// Where a point on the disc is that stands in a pixel at time t, at another time of a shutter that is open for the whole frame.
glm::vec2 turned_to(float other, float t, int x, int y) {
    glm::vec2 const arm = glm::vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f} - glm::vec2{24, 16};
    float const angle = other - t; // counter-clockwise, while y grows down
    return {std::cos(angle) * arm.x + std::sin(angle) * arm.y, -std::sin(angle) * arm.x + std::cos(angle) * arm.y};
}

} // namespace

TEST_CASE("with an open shutter every sample has its own time and stands where it is then") {
    auto description = moving_plate();
    auto const camera = description.camera_at(0, size);
    auto const pictures = pictures_of<Wanted>(std::move(description), {.size = size, .frame = 2, .shutter = 0.5f});
    int hits = 0, distinct = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const t = pixel(pictures[quell::time], x, y).x;
            CHECK(t >= 0);
            CHECK(t < 1);
            distinct += x > 0 && t != pixel(pictures[quell::time], x - 1, y).x ? 1 : 0;
            if (pixel(pictures[instance], x, y).x == 0) continue;
            ++hits;
            auto const place = pixel(pictures[position], x, y);
            CHECK(std::abs(place.x - (1 + 0.25f * t)) < 0.4f + 1e-4f);
            CHECK(glm::distance(place - glm::vec3{0.5f, 0, 0}, pixel(pictures[receiver_previous], x, y)) < 1e-5f);
            auto const expected = projected(camera, place + glm::vec3{0.25f * (1 - t), 0, 0}, size) -
                                  projected(camera, place - glm::vec3{0.25f * t, 0, 0}, size);
            CHECK(glm::distance(expected, glm::vec2(pixel(pictures[sweep], x, y))) < 1e-2f);
        }
    CHECK(hits > 50);
    CHECK(distinct > 1000);
}

TEST_CASE("many samples over the shutter blur in proportion to coverage") {
    auto const pictures = pictures_of<Wanted>(moving_plate(), {.size = size, .frame = 0, .samples_per_pixel = 256, .shutter = 1});
    float const pixels_per_unit = 16 / std::tan(glm::radians(20.f)) / 4;
    // The plate's left edge goes from -0.4 to 0.1, so what is in between is covered for a part of the time.
    for (float edge : {-0.3f, -0.15f, 0.f}) {
        int const x = static_cast<int>(24 + edge * pixels_per_unit);
        float const place = (static_cast<float>(x) + 0.5f - 24) / pixels_per_unit;
        CHECK(pixel(pictures[radiance], x, 16).x == doctest::Approx((place + 0.4f) / 0.5f).epsilon(0.03));
    }
}

TEST_CASE("a turning object is bent, not stretched") {
    auto scene = world({0, 2, 0.001f}, {0, 0, 0}, 60);
    scene.place(scene.add(box({2, 0.1f, 0.2f})), scene.add(Material{}), [](float frame) {
        return glm::rotate(glm::mat4{1.f}, 1.2f * frame, {0, 1, 0});
    });
    auto const pictures = pictures_of<Channels<Position, Instance>>(std::move(scene), {.size = {120, 120}, .frame = 1, .shutter = 1});
    float farthest = 0;
    for (std::size_t i = 0; i < pictures[instance].pixels.size(); ++i)
        if (pictures[instance].pixels[i].x != 0) farthest = std::max(farthest, glm::length(pictures[position].pixels[i]));
    CHECK(farthest > 0.98f);
    CHECK(farthest < 1.01f);
}

TEST_CASE("a closed shutter has no sweep and time zero") {
    auto const pictures = pictures_of<Wanted>(moving_plate(), {.size = size, .frame = 2});
    for (auto const& value : pictures[sweep].pixels) CHECK(glm::length(value) < 1e-4f);
    for (auto const& value : pictures[quell::time].pixels) CHECK(value.x == 0);
}

TEST_CASE("a turning point's sweep is its chord, and its bend goes from there to the arc") {
    auto const pictures = pictures_of<Path>(turning_disc(), {.size = size, .frame = 3, .shutter = 1});
    int hits = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (pixel(pictures[instance], x, y).x == 0) continue;
            ++hits;
            float const t = pixel(pictures[quell::time], x, y).x;
            auto const opening = turned_to(0, t, x, y), middle = turned_to(0.5f, t, x, y), closing = turned_to(1, t, x, y);
            CHECK(glm::distance(glm::vec2(pixel(pictures[sweep], x, y)), closing - opening) < 0.05f);
            CHECK(glm::distance(glm::vec2(pixel(pictures[sweep_bend], x, y)), middle - (opening + closing) * 0.5f) < 0.05f);
        }
    CHECK(hits > 300);
}

TEST_CASE("a camera that rolls bends the paths of all that stands still, the sky's too") {
    auto scene = world({0, 0, 0}, {0, 0, -1});
    scene.camera = [](float frame) { return look_at({0, 0, 4}, {0, 0, 0}, 40, {std::sin(frame), std::cos(frame), 0}); };
    scene.place(scene.add(rectangle(2, 2)), scene.add(Material{}), {.rotation = glm::angleAxis(glm::radians(90.f), glm::vec3{1, 0, 0})});
    for (int keys : {9, 33}) {
        auto const pictures = pictures_of<Path>(scene, {.size = size, .frame = 3, .shutter = 1, .shutter_keys = keys});
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                // The camera rolls clockwise, so that the image turns counter-clockwise.
                float const t = pixel(pictures[quell::time], x, y).x;
                auto const opening = turned_to(0, t, x, y), middle = turned_to(0.5f, t, x, y), closing = turned_to(1, t, x, y);
                CHECK(glm::distance(glm::vec2(pixel(pictures[sweep], x, y)), closing - opening) < 0.05f);
                CHECK(glm::distance(glm::vec2(pixel(pictures[sweep_bend], x, y)), middle - (opening + closing) * 0.5f) < 0.05f);
            }
    }
}

TEST_CASE("with two keys everything moves straight, and cameras stay rigid") {
    auto scene = turning_disc();
    auto const pictures = pictures_of<Path>(scene, {.size = size, .frame = 3, .shutter = 1, .shutter_keys = 2});
    float longest = 0;
    for (auto const& value : pictures[sweep_bend].pixels) CHECK(glm::length(value) < 1e-4f);
    for (auto const& value : pictures[sweep].pixels) longest = std::max(longest, glm::length(value));
    CHECK(longest > 10);

    scene.camera = [](float frame) { return look_at({frame, 0, 4}, {0, frame, 0}, 40, {std::sin(frame), std::cos(frame), 0.2f}); };
    PreparedScene prepared{scene};
    prepared.move_to(3, 1, 2);
    for (float time : {0.f, 0.3f, 0.5f, 1.f}) {
        auto const axes = glm::mat3(prepared.camera(time, When::now).world_from_camera);
        auto const product = glm::transpose(axes) * axes;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) CHECK(product[i][j] == doctest::Approx(i == j ? 1 : 0).epsilon(1e-5));
        CHECK(prepared.camera(time, When::now).world_from_camera[3].x == doctest::Approx(3 + time));
    }
    CHECK(prepared.camera(1, When::now).world_from_camera[3].x == doctest::Approx(4));
}

TEST_CASE("with an open shutter what stands still has neither sweep nor bend, exactly") {
    auto scene = world({1, 2, 5}, {0, 0, 0});
    scene.place(scene.add_sphere(), scene.add(Material{}), {.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3{1, 2, 3}))});
    scene.place(scene.add(rectangle(20, 20)), scene.add(Material{}), {.translation = {0, -1, 0}});
    auto const pictures = pictures_of<Channels<Sweep, SweepBend, Motion>>(std::move(scene), {.size = size, .frame = 7, .shutter = 0.5f});
    for (auto const& value : pictures[sweep].pixels) CHECK(value == glm::vec3{0.f});
    for (auto const& value : pictures[sweep_bend].pixels) CHECK(value == glm::vec3{0.f});
    for (auto const& value : pictures[motion].pixels) CHECK(value == glm::vec3{0.f});
}

TEST_CASE("a frozen frame shows one moment, with sweeps over the whole shutter") {
    float const t = 0.25f;
    RenderSettings const settings{.size = size, .frame = 2, .samples_per_pixel = 16, .shutter = 0.5f, .frozen_at = t};
    auto description = moving_plate();
    auto const camera = description.camera_at(0, size);
    auto const pictures = pictures_of<Wanted>(std::move(description), settings);
    auto const x_of = [&](float x) { return projected(camera, {x, 0, 0}, size).x; };
    // The plate stands still amid its way; at the edges' pixels either is right.
    float const centre = 1 + 0.25f * t, left = x_of(centre - 0.4f), right = x_of(centre + 0.4f);
    auto const way = x_of(1.25f) - x_of(1);
    int hits = 0;
    for (int x = 0; x < size.width; ++x) {
        float const place = static_cast<float>(x) + 0.5f;
        CHECK(pixel(pictures[quell::time], x, 16).x == t);
        if (std::abs(place - left) < 0.01f || std::abs(place - right) < 0.01f) continue;
        bool const on_plate = place > left && place < right;
        hits += on_plate ? 1 : 0;
        CHECK(pixel(pictures[radiance], x, 16).x == (on_plate ? 1 : 0));
        CHECK(pixel(pictures[sweep], x, 16).x == doctest::Approx(on_plate ? way : 0).epsilon(1e-3));
    }
    CHECK(hits > 5);
    CHECK(way > 2);
}

TEST_CASE("a frozen frame lies within the open shutter, or is refused") {
    PreparedScene scene{moving_plate()};
    Pictures<Channels<Sweep>> pictures{size};
    for (float const time : {-0.01f, 1.01f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        CAPTURE(time);
        RenderSettings const settings{.size = size, .shutter = 0.5f, .frozen_at = time};
        CHECK_THROWS_AS(render<Channels<Sweep>>(scene, settings, pictures), Error);
    }
    for (float const time : {0.f, 1.f})
        CHECK_NOTHROW(render<Channels<Sweep>>(scene, {.size = size, .shutter = 0.5f, .frozen_at = time}, pictures));
}

TEST_CASE("a shutter without two keys, or with more than there can be, is refused") {
    PreparedScene scene{moving_plate()};
    Pictures<Channels<Sweep>> pictures{size};
    for (int keys : {-1, 0, 1, 130}) {
        CAPTURE(keys);
        RenderSettings const settings{.size = size, .shutter = 0.5f, .shutter_keys = keys};
        CHECK_THROWS_AS(render<Channels<Sweep>>(scene, settings, pictures), Error);
    }
    CHECK_NOTHROW(render<Channels<Sweep>>(scene, {.size = size, .shutter = 0.5f, .shutter_keys = 129}, pictures));
}
