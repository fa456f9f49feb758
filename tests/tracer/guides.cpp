#include "worlds.hpp"

using namespace quell;
using namespace quell::tracer;

TEST_CASE("depth, position and normal of a slanted plane are those of the plane") {
    glm::vec3 const eye{0, 5, 3};
    auto scene = world(eye, {0, 0, 0}, 50);
    auto const slant = glm::angleAxis(0.3f, glm::vec3{0, 0, 1});
    scene.place(scene.add(rectangle(40, 40)), scene.add(Material{.base = {0.2f, 0.4f, 0.6f}, .metallic = 0.5f, .roughness = 0.3f}),
                {.rotation = slant});
    auto const normal_of_plane = slant * glm::vec3{0, 1, 0};
    auto const forward = glm::normalize(-eye);
    auto const pictures = pictures_of<Channels<Depth, Normal, Position, Albedo, Roughness, Instance>>(std::move(scene), {.size = {33, 21}});
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 33; ++x) {
            auto const place = pixel(pictures[position], x, y);
            CHECK(glm::dot(place, normal_of_plane) == doctest::Approx(0).epsilon(1e-4));
            CHECK(pixel(pictures[depth], x, y).x == doctest::Approx(glm::dot(place - eye, forward)).epsilon(1e-5));
            CHECK(glm::distance(pixel(pictures[normal], x, y), normal_of_plane) < 1e-5f);
            CHECK(glm::distance(pixel(pictures[albedo], x, y), glm::vec3{0.1f, 0.2f, 0.3f}) < 1e-6f);
            CHECK(pixel(pictures[roughness], x, y).x == doctest::Approx(0.3f));
            CHECK(pixel(pictures[instance], x, y).x == 1);
        }
}

TEST_CASE("normals face the viewer from either side and are of unit length on scaled and mirrored objects") {
    for (float side : {-1.f, 1.f}) {
        auto scene = world({0, side * 3, 0.1f}, {0, 0, 0});
        int const grey = scene.add(Material{});
        scene.place(scene.add_sphere(), grey, {.translation = {-1, 0, 0}, .scale = {-0.5f, 1, 2}});
        scene.place(scene.add(rectangle(1, 1)), grey, {.translation = {1, 0, 0}, .scale = {3, 1, -0.5f}});
        scene.place(scene.add(torus(0.5f, 0.2f)), grey, {.translation = {1, 0, 1}, .scale = {1, 2, 1}});
        auto const pictures = pictures_of<Channels<Normal, Position, Depth>>(std::move(scene), {.size = {48, 32}});
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x) {
                auto const found = pixel(pictures[normal], x, y);
                CHECK(glm::length(found) == doctest::Approx(1).epsilon(1e-5));
                if (!std::isfinite(pixel(pictures[depth], x, y).x)) continue;
                CHECK(glm::dot(found, glm::vec3{0, side * 3, 0.1f} - pixel(pictures[position], x, y)) > 0);
            }
    }
}

TEST_CASE("a miss has infinite depth, no instance, no position, and shows the background as direct light") {
    auto scene = world({0, 0, 0}, {0, 0, -1});
    scene.background = {{0.1f, 0.2f, 0.3f}, {0.5f, 0.6f, 0.7f}};
    auto const pictures = pictures_of<TracedChannels>(std::move(scene), {.size = {9, 9}});
    CHECK(std::isinf(pixel(pictures[depth], 4, 4).x));
    CHECK(pixel(pictures[instance], 4, 4).x == 0);
    CHECK(!std::isfinite(pixel(pictures[position], 4, 4).x));
    CHECK(!std::isfinite(pixel(pictures[receiver_previous], 4, 4).x));
    CHECK(!std::isfinite(pixel(pictures[glossy_hit], 4, 4).x));
    CHECK(pixel(pictures[albedo], 4, 4) == glm::vec3{1.f});
    CHECK(glm::distance(pixel(pictures[direct], 4, 4), glm::vec3{0.3f, 0.4f, 0.5f}) < 1e-6f);
    CHECK(pixel(pictures[radiance], 4, 4) == pixel(pictures[direct], 4, 4));
    CHECK(pixel(pictures[motion], 4, 4) == glm::vec3{0.f});
}

TEST_CASE("an emitter shows its radiance as direct light that is visible, on its emitting side only") {
    for (float side : {-1.f, 1.f}) {
        auto scene = world({0, side * 2, 0.01f}, {0, 0, 0});
        scene.place(scene.add(rectangle(9, 9)), scene.add(Material{.emission = {3, 2, 1}}));
        auto const pictures = pictures_of<Channels<Direct, Visibility, Albedo, Indirect, Radiance>>(std::move(scene), {.size = {5, 5}});
        auto const expected = side > 0 ? glm::vec3{3, 2, 1} : glm::vec3{0.f};
        CHECK(pixel(pictures[direct], 2, 2) == expected);
        CHECK(pixel(pictures[radiance], 2, 2) == expected);
        CHECK(pixel(pictures[visibility], 2, 2).x == 1);
        CHECK(pixel(pictures[albedo], 2, 2) == glm::vec3{1.f});
        CHECK(pixel(pictures[indirect], 2, 2) == glm::vec3{0.f});
    }
}

TEST_CASE("textures colour surfaces, and holes in them let rays through") {
    auto scene = world({0, 2, 0.001f}, {0, 0, 0}, 40);
    // Left half red, right half transparent, over a blue floor.
    std::vector<glm::u8vec4> texels(16);
    for (std::size_t i = 0; i < 16; ++i) texels[i] = i % 4 < 2 ? glm::u8vec4{255, 0, 0, 255} : glm::u8vec4{0, 255, 0, 0};
    int const masked = scene.add(Material{.base = glm::vec3{1.f}, .alpha_cutoff = 0.5f, .base_texture = scene.add(Texture{4, 4, texels})});
    scene.place(scene.add(rectangle(4, 4)), masked);
    scene.place(scene.add(rectangle(4, 4)), scene.add(Material{.base = {0, 0, 1}}), {.translation = {0, -0.5f, 0}});
    auto const pictures = pictures_of<Channels<Albedo, Instance>>(std::move(scene), {.size = {16, 8}});
    CHECK(glm::distance(pixel(pictures[albedo], 4, 4), glm::vec3{1, 0, 0}) < 1e-3f);
    CHECK(glm::distance(pixel(pictures[albedo], 12, 4), glm::vec3{0, 0, 1}) < 1e-3f);
    CHECK(pixel(pictures[instance], 12, 4).x == 2);
}
