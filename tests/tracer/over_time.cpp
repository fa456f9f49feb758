#include "worlds.hpp"

#include <glm/geometric.hpp>

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
