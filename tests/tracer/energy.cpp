#include "worlds.hpp"

using namespace quell;
using namespace quell::tracer;

TEST_CASE("white furnace: under a constant sky a diffuse surface returns its albedo") {
    auto scene = world({0, 1, 3}, {0, 0, 0});
    scene.background = {glm::vec3{1.f}, glm::vec3{1.f}};
    scene.place(scene.add_sphere(), scene.add(Material{.base = {0.9f, 0.5f, 0.1f}}));
    auto const pictures =
        pictures_of<Channels<Indirect, Albedo, Radiance, Instance>>(std::move(scene), {.size = {24, 24}, .samples_per_pixel = 4});
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            bool const hit = pixel(pictures[instance], x, y).x == 1;
            auto const expected = hit ? glm::vec3{0.9f, 0.5f, 0.1f} : glm::vec3{1.f};
            CHECK(glm::distance(pixel(pictures[radiance], x, y), expected) < 1e-5f);
            if (hit) CHECK(glm::distance(pixel(pictures[indirect], x, y), glm::vec3{1.f}) < 1e-6f);
        }
}

TEST_CASE("inside a glowing sphere direct light is albedo times its radiance, and indirect light does not count it again") {
    auto scene = world({0, 0.5f, 2}, {0, 0, 0});
    int const glow = scene.add(Material{.emission = glm::vec3{2.f}, .emits_both_sides = true});
    // Coarse enough to be a set of lights.
    auto const sphere = surface(16, 8, [](float u, float v) {
        float const around = 6.2831853f * u, down = 3.14159265f * (0.001f + 0.998f * v);
        return 5.f * glm::vec3{std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
    });
    scene.place(scene.add(sphere), glow);
    scene.place(scene.add_sphere(), scene.add(Material{.base = glm::vec3{0.6f}}), {.scale = glm::vec3{0.5f}});
    auto const pictures =
        pictures_of<Channels<Direct, Visibility, Indirect, Radiance>>(std::move(scene), {.size = {9, 9}, .samples_per_pixel = 4});
    CHECK(pixel(pictures[direct], 4, 4).x == doctest::Approx(1.2).epsilon(0.002));
    CHECK(pixel(pictures[visibility], 4, 4).x == 1);
    CHECK(pixel(pictures[indirect], 4, 4).x == 0);
    CHECK(pixel(pictures[radiance], 4, 4).x == doctest::Approx(1.2).epsilon(0.002));
}

TEST_CASE("finely tessellated emitters are no lights but glow all the same") {
    auto scene = world({0, 2, 0.01f}, {0, 0, 0}, 20);
    scene.place(scene.add(rectangle(10, 10)), scene.add(Material{.base = glm::vec3{0.5f}}));
    auto const fine = surface(24, 24, [](float u, float v) { return glm::vec3{40 * u - 20, 3, 40 * v - 20}; });
    scene.place(scene.add(fine), scene.add(Material{.emission = glm::vec3{1.f}, .emits_both_sides = true}));
    auto const pictures = pictures_of<Channels<Direct, Indirect>>(std::move(scene), {.size = {5, 5}, .samples_per_pixel = 256});
    CHECK(pixel(pictures[direct], 2, 2).x == 0);
    CHECK(pixel(pictures[indirect], 2, 2).x == doctest::Approx(0.98).epsilon(0.03));
}

TEST_CASE("one bounce of indirect light between two walls is what integration gives") {
    // A floor under a large ceiling that a light behind the floor makes bright: incident light is the ceiling's radiosity over pi.
    auto scene = world({0, 1.5f, 0.01f}, {0, 0, 0}, 10);
    auto const downwards = glm::angleAxis(glm::radians(180.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(0.5f, 0.5f)), scene.add(Material{.base = glm::vec3{0.5f}}));
    scene.place(scene.add(rectangle(400, 400)), scene.add(Material{.base = glm::vec3{0.8f}}),
                {.translation = {0, 2, 0}, .rotation = downwards});
    scene.place(scene.add(rectangle(4000, 4000)), scene.add(Material{.emission = glm::vec3{1.f}}), {.translation = {0, -5, 0}});
    auto const pictures = pictures_of<Channels<Direct, Indirect>>(std::move(scene), {.size = {3, 3}, .samples_per_pixel = 1024});
    CHECK(pixel(pictures[direct], 1, 1).x == 0);
    CHECK(pixel(pictures[indirect], 1, 1).x == doctest::Approx(0.8).epsilon(0.03));
}

TEST_CASE("a textured light of four corners shines with the mean of all that it covers") {
    auto scene = world({0, 1, 2}, {0, 0, 0});
    // It covers the quarter that is white, and none of the black around it.
    int const quarter = scene.add(painted(4, 4, [](glm::vec2 uv) { return glm::vec3(uv.x < 0.5f && uv.y < 0.5f ? 1.f : 0.f); }));
    scene.place(scene.add(rectangle(1, 1, {0.5f, 0.5f})), scene.add(Material{.emission = {3, 2, 1}, .emission_texture = quarter}));
    PreparedScene prepared{std::move(scene)};
    prepared.move_to(0);
    REQUIRE(prepared.emitter_count() == 1);
    CHECK(prepared.emitter(0, 0).corner_count == 4);
    CHECK(glm::distance(prepared.emitter(0, 0).radiance, glm::vec3{3, 2, 1}) < 0.01f);
}
