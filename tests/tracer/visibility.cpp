#include "worlds.hpp"

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{24, 16};

/// A plate hovers over a floor under a light; the camera sees the floor with its soft shadow.
SceneDescription soft_shadow(bool with_sphere_light) {
    auto scene = world({0, 1.2f, 2.5f}, {0, 0, 0}, 40);
    int const light = scene.add(Material{.emission = {10, 9, 8}});
    scene.place(scene.add(rectangle(10, 10)), scene.add(Material{.base = glm::vec3{0.5f}}));
    scene.place(scene.add(box({0.6f, 0.02f, 0.6f})), scene.add(Material{}), {.translation = {0.2f, 0.8f, 0}});
    auto const downwards = glm::angleAxis(glm::radians(180.f), glm::vec3{1, 0, 0});
    if (with_sphere_light)
        scene.place(scene.add_sphere(), light, {.translation = {0.3f, 2, 0}, .scale = glm::vec3{0.4f}});
    else
        scene.place(scene.add(rectangle(0.9f, 0.7f)), light, {.translation = {0.3f, 2, 0}, .rotation = downwards});
    return scene;
}

/// Shadowed direct light by cosine-weighted rays that look for the light: nothing in common with how the tracer does it.
double brute_force(PreparedScene const& scene, glm::vec3 position, int light_instance, glm::vec3 reflectance_times_radiance, int count) {
    int met = 0;
    for (int i = 0; i < count; ++i) {
        auto const direction = cosine_direction({0, 1, 0}, sample_pair({{5, 6}, static_cast<std::uint32_t>(i), 7}, SampleUse::indirect));
        met += scene.intersect({position + glm::vec3{0, 1e-4f, 0}, direction, infinity, 0}).instance == light_instance ? 1 : 0;
    }
    return static_cast<double>(reflectance_times_radiance.x) * met / count;
}

} // namespace

TEST_CASE("direct light times mean visibility is the shadowed direct light") {
    for (bool with_sphere_light : {false, true}) {
        PreparedScene scene{soft_shadow(with_sphere_light)};
        Pictures<Channels<Direct, Visibility, Position, Instance>> pictures{size};
        render<Channels<Direct, Visibility, Position, Instance>>(scene, {.size = size, .samples_per_pixel = 1024}, pictures);
        double traced = 0, expected = 0, worst = 0;
        int compared = 0, partly_lit = 0;
        for (int y = 0; y < size.height; y += 3)
            for (int x = 0; x < size.width; x += 3) {
                if (pixel(pictures[instance], x, y).x != 1) continue;
                double const found = pixel(pictures[direct], x, y).x * pixel(pictures[visibility], x, y).x;
                double const truth = brute_force(scene, pixel(pictures[position], x, y), 2, {5, 0, 0}, 1 << 16);
                traced += found, expected += truth, worst = std::max(worst, std::abs(found - truth));
                ++compared;
                float const seen = pixel(pictures[visibility], x, y).x;
                partly_lit += seen > 0.05f && seen < 0.95f ? 1 : 0;
            }
        CHECK(compared > 20);
        CHECK(partly_lit > 4);
        CHECK(traced == doctest::Approx(expected).epsilon(0.01));
        CHECK(worst < 0.02 * expected / compared + 0.01);
    }
}

TEST_CASE("blockers lie between receiver and light, and move as they do") {
    auto description = soft_shadow(false);
    description.nodes[1].pose = [](float frame) { return Transform{{0.2f + 0.1f * frame, 0.8f, 0}}.matrix(); };
    description.nodes[2].pose = [](float frame) {
        return Transform{{0.3f, 2 + 0.05f * frame, 0}, glm::angleAxis(glm::radians(180.f), glm::vec3{1, 0, 0})}.matrix();
    };
    using Wanted = Channels<Visibility, Light, LightPrevious, Blocker, BlockerPrevious, ReceiverPrevious, Position, Instance>;
    auto const pictures = pictures_of<Wanted>(std::move(description), {.size = size});
    int shadowed = 0, lit = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (pixel(pictures[instance], x, y).x != 1) continue;
            auto const from = pixel(pictures[position], x, y), to = pixel(pictures[light], x, y), between = pixel(pictures[blocker], x, y);
            CHECK(glm::distance(pixel(pictures[light_previous], x, y), to - glm::vec3{0, 0.05f, 0}) < 1e-5f);
            bool const blocked = pixel(pictures[visibility], x, y).x == 0;
            ++(blocked ? shadowed : lit);
            CHECK(is_finite(between) == blocked);
            if (!blocked) continue;
            CHECK(glm::distance(from, between) + glm::distance(between, to) == doctest::Approx(glm::distance(from, to)).epsilon(1e-4));
            CHECK(glm::distance(pixel(pictures[blocker_previous], x, y), between - glm::vec3{0.1f, 0, 0}) < 1e-5f);
        }
    CHECK(shadowed > 10);
    CHECK(lit > 10);
}

TEST_CASE("with two lights of different strength visibility is the contribution-weighted mean") {
    auto scene = world({0, 2, 2}, {0, 0, 0}, 20);
    auto const downwards = glm::angleAxis(glm::radians(180.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(10, 10)), scene.add(Material{.base = glm::vec3{0.5f}}));
    int const panel = scene.add(rectangle(0.5f, 0.5f));
    scene.place(panel, scene.add(Material{.emission = glm::vec3{6}}), {.translation = {-1, 2, 0}, .rotation = downwards});
    scene.place(panel, scene.add(Material{.emission = glm::vec3{2}}), {.translation = {1, 2, 0}, .rotation = downwards});
    // A screen that hides the weaker light from the middle of the floor.
    scene.place(scene.add(box({0.8f, 0.02f, 0.8f})), scene.add(Material{}), {.translation = {0.5f, 1, 0}});
    auto const pictures = pictures_of<Channels<Visibility>>(std::move(scene), {.size = {5, 5}, .samples_per_pixel = 4096});
    CHECK(pixel(pictures[visibility], 2, 2).x == doctest::Approx(0.75).epsilon(0.01));
}
