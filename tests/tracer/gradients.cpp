#include "worlds.hpp"

#include <tracer/scenes/scenes.hpp>
#include <tracer/scenes/turn.hpp>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{48, 30};
using Wanted = Channels<GradientOf<Visibility>, GradientOf<Glossy>, GradientOf<Indirect>, GradientOf<Radiance>>;

static_assert(GradientOf<Visibility>::name == "visibility_gradient");
static_assert(GradientOf<Radiance>::name == "radiance_gradient");
static_assert(std::is_same_v<gradient_signals<Channels<Depth, GradientOf<Glossy>>>, Channels<Glossy>>);
static_assert(!wants_gradients<Channels<Radiance, Glossy>> && wants_gradients<Wanted>);

/// A floor and a wall of metal under a light whose brightness may change; the camera stands still.
SceneDescription lit_corner(std::function<float(float)> brightness) {
    auto scene = world({0, 1.5f, 4}, {0, 0.8f, 0}, 50);
    scene.place(scene.add(rectangle(8, 8)), scene.add(Material{.base = {0.6f, 0.5f, 0.4f}}));
    scene.place(scene.add(box({1, 1, 1})), scene.add(Material{.base = {0.9f, 0.8f, 0.7f}, .metallic = 0.5f, .roughness = 0.3f}),
                {.translation = {0, 0.5f, 0}});
    scene.place(scene.add(rectangle(8, 4)), scene.add(Material{}), {.translation = {0, 2, -2}, .rotation = turn(90, {1, 0, 0})});
    scene.place(scene.add(rectangle(1, 1)), scene.add(Material{.emission = glm::vec3{20}, .brightness = std::move(brightness)}),
                {.translation = {0.5f, 4, 1}, .rotation = turn(180, {1, 0, 0})});
    return scene;
}

template <class F> void for_each_signal(F&& f) { for_each_channel(Channels<Visibility, Glossy, Indirect, Radiance>{}, f); }

} // namespace

TEST_CASE("one pixel of each 3x3 has a gradient, another one from frame to frame") {
    for (Extent const image : {Extent{30, 21}, Extent{31, 22}, Extent{2, 1}}) {
        int const strata = (image.width + 2) / 3 * ((image.height + 2) / 3);
        int moved = 0, chosen = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                GradientSamples const now{image, 7}, next{image, 8};
                chosen += now.has(x, y) ? 1 : 0;
                moved += now.has(x, y) && !next.has(x, y) ? 1 : 0;
            }
        CHECK(chosen == strata);
        if (strata > 9) CHECK(moved > strata / 2);
    }
}

TEST_CASE("in a still scene all gradients are exactly 0, and a ninth of the pixels has one") {
    auto const pictures = pictures_of<Wanted>(lit_corner({}), {.size = size, .frame = 5});
    for_each_signal([&]<class Signal>(Signal) {
        CAPTURE(Signal::name);
        for (auto const& value : pictures[GradientOf<Signal>{}].pixels) CHECK(value.x == 0);
    });
    auto const traced = std::ranges::count_if(pictures[GradientOf<Radiance>{}].pixels, [](auto const& value) { return value.y > 0; });
    CHECK(traced > size.pixels() / 9 * 0.9);
    CHECK(traced <= size.pixels() / 9);
}

TEST_CASE("a light that is switched on changes everything by all that there is now") {
    auto const switched = [](float frame) { return frame < 10 ? 0.f : 1.f; };
    auto const on = pictures_of<Wanted>(lit_corner(switched), {.size = size, .frame = 10});
    auto const later = pictures_of<Wanted>(lit_corner(switched), {.size = size, .frame = 11});
    for_each_signal([&]<class Signal>(Signal) {
        CAPTURE(Signal::name);
        int changed = 0;
        for (auto const& value : on[GradientOf<Signal>{}].pixels) {
            changed += value.x > 0 ? 1 : 0;
            if (!std::is_same_v<Signal, Visibility>) CHECK(value.x == value.y);
        }
        // Where no light is there is no shadow either: visibility stays 1 or falls to 0.
        if (!std::is_same_v<Signal, Visibility>) CHECK(changed > 2);
        for (auto const& value : later[GradientOf<Signal>{}].pixels) CHECK(value.x == 0);
    });
}

TEST_CASE("a light that doubles changes radiance by half of what it is then") {
    auto const doubled = [](float frame) { return frame < 10 ? 0.5f : 1.f; };
    auto const pictures = pictures_of<Wanted>(lit_corner(doubled), {.size = size, .frame = 10});
    for (auto const& value : pictures[GradientOf<Radiance>{}].pixels) CHECK(value.x == doctest::Approx(value.y / 2).epsilon(1e-4));
    for (auto const& value : pictures[GradientOf<Visibility>{}].pixels) CHECK(value.x == 0);
}

TEST_CASE("a shadow that moves on changes visibility by 1 where it comes and goes") {
    PreparedScene scene{built_in_scene("fence")};
    Pictures<Channels<GradientOf<Visibility>>> pictures{{96, 54}};
    render<Channels<GradientOf<Visibility>>>(scene, {.size = {96, 54}, .frame = 30}, pictures);
    int darker = 0, lighter = 0;
    for (auto const& value : pictures[GradientOf<Visibility>{}].pixels) {
        darker += value.x == -1 && value.y == 1 ? 1 : 0, lighter += value.x == 1 && value.y == 1 ? 1 : 0;
        CHECK((value.x == 0 || std::abs(value.x) == 1));
    }
    CHECK(darker > 5);
    CHECK(lighter > 5);
}

TEST_CASE("points that move together with their light are compared with themselves") {
    auto const sliding = [](float frame) { return Transform{{0.3f * (frame - 5), 0, 0}}.matrix(); };
    SceneDescription together = world({0, 1, 4}, {0, 0, 0}, 50);
    int const carriage = together.add_node(sliding);
    together.place(together.add(box({1, 1, 1})), together.add(Material{}), {}, carriage);
    together.place(together.add(rectangle(1, 1)), together.add(Material{.emission = glm::vec3{20}}),
                   {.translation = {0, 3, 2}, .rotation = facing({0, -3, -2})}, carriage);
    auto const pictures = pictures_of<Channels<GradientOf<Radiance>, Motion>>(std::move(together), {.size = size, .frame = 5});
    int compared = 0;
    for (auto const& value : pictures[GradientOf<Radiance>{}].pixels) {
        CHECK(std::abs(value.x) <= 1e-3f * value.y);
        compared += value.y > 0 ? 1 : 0;
    }
    CHECK(compared > 4);
}

TEST_CASE("gradients take rays only where they are wanted, and none in the first frame") {
    PreparedScene scene{built_in_scene("room")};
    auto const counts = [&]<class Set>(Set, int frame) {
        Pictures<Set> pictures{size};
        return render<Set>(scene, {.size = size, .frame = frame}, pictures);
    };
    auto const plain = counts(Channels<Visibility>{}, 5), with = counts(Channels<Visibility, GradientOf<Visibility>>{}, 5);
    auto const strata = size.pixels() / 9;
    CHECK(with.primary - plain.primary <= strata);
    CHECK(with.primary - plain.primary > strata / 2);
    CHECK(with.shadow - plain.shadow <= 2 * strata);
    CHECK(with.shadow - plain.shadow > strata);
    CHECK(with.glossy + with.indirect == 0);
    CHECK(counts(Channels<Visibility, GradientOf<Visibility>>{}, 0) == counts(Channels<Visibility>{}, 0));
}
