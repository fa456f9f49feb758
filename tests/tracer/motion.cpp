#include "worlds.hpp"

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{64, 36};
using Wanted = Channels<Motion, Position, ReceiverPrevious, Depth, Instance>;

RenderSettings at_frame(int frame) { return {.size = size, .frame = frame}; }

} // namespace

TEST_CASE("motion is exactly zero where nothing moves") {
    auto scene = world({1, 2, 5}, {0, 0, 0});
    int const grey = scene.add(Material{});
    scene.place(scene.add_sphere(), grey, {.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3{1, 2, 3})), .scale = {1.2f, 0.7f, 1}});
    scene.place(scene.add(rectangle(20, 20)), grey, {.translation = {0, -1, 0}});
    auto const pictures = pictures_of<Wanted>(std::move(scene), at_frame(7));
    for (auto const& value : pictures[motion].pixels) CHECK(value == glm::vec3{0.f});
}

TEST_CASE("motion of static surfaces and of the sky under a moving camera is that of their projections") {
    auto scene = world({0, 0, 0}, {0, 0, -1});
    scene.camera = [](float frame) {
        return look_at({0.11f * frame, 0.5f + 0.02f * frame * frame, 4 - 0.2f * frame}, {0.1f * frame, 0, -1}, 70);
    };
    scene.place(scene.add(rectangle(6, 6)), scene.add(Material{}), {.translation = {0, -0.5f, 0}});
    auto const camera = scene.camera_at(3, size), before = scene.camera_at(2, size);
    auto const pictures = pictures_of<Wanted>(std::move(scene), at_frame(3));
    int surfaces = 0, sky = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            glm::vec2 const centre{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            auto const found = glm::vec2(pixel(pictures[motion], x, y));
            bool const hit = std::isfinite(pixel(pictures[depth], x, y).x);
            ++(hit ? surfaces : sky);
            auto const place = hit ? pixel(pictures[position], x, y) : glm::vec3{0.f};
            if (hit) CHECK(glm::distance(projected(camera, place, size), centre) < 1e-3f);
            if (hit)
                CHECK(glm::distance(projected(before, place, size), centre + found) < 1e-3f);
            else
                CHECK(is_finite({found, 0}));
        }
    CHECK(surfaces > 300);
    CHECK(sky > 300);
}

TEST_CASE("sky moves as the camera turns") {
    auto scene = world({0, 0, 0}, {0, 0, -1});
    // One degree a frame to the left: what is in the middle now was to the left of it before, by the tangent of a degree.
    scene.camera = [](float frame) {
        float const angle = glm::radians(frame);
        return look_at({0, 0, 0}, {-std::sin(angle), 0, -std::cos(angle)}, 60);
    };
    auto const pictures = pictures_of<Wanted>(std::move(scene), {.size = {65, 37}, .frame = 4});
    float const pixels_per_slope = 18.5f / std::tan(glm::radians(30.f));
    CHECK(pixel(pictures[motion], 32, 18).x == doctest::Approx(-pixels_per_slope * std::tan(glm::radians(1.f))).epsilon(1e-3));
    CHECK(pixel(pictures[motion], 32, 18).y == doctest::Approx(0).epsilon(1e-3));
}

TEST_CASE("motion of an object that moves and turns is where its own points were") {
    auto scene = world({0, 1, 6}, {0, 0, 0});
    auto const pose = [](float frame) {
        return Transform{{0.15f * frame, 0, 0}, glm::angleAxis(0.05f * frame, glm::vec3{0, 1, 0}), glm::vec3{1.5f}}.matrix();
    };
    scene.place(scene.add(box(glm::vec3{1.4f})), scene.add(Material{}), pose);
    auto const before = scene.camera_at(4, size);
    auto const back = pose(4) * glm::inverse(pose(5));
    auto const pictures = pictures_of<Wanted>(std::move(scene), at_frame(5));
    int hits = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (pixel(pictures[instance], x, y).x == 0) continue;
            ++hits;
            glm::vec3 const was = back * glm::vec4(pixel(pictures[position], x, y), 1.f);
            CHECK(glm::distance(was, pixel(pictures[receiver_previous], x, y)) < 1e-4f);
            glm::vec2 const centre{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            CHECK(glm::distance(projected(before, was, size) - centre, glm::vec2(pixel(pictures[motion], x, y))) < 2e-3f);
        }
    CHECK(hits > 100);
}
