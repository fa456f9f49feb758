#include "worlds.hpp"

#include <tracer/mask.hpp>
#include <tracer/scenes/turn.hpp>

#include <filesystem>
#include <random>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{48, 32};
MaskSettings const fresh{.use_cache = false};

metrics::Mask mask_of(SceneDescription scene, Effect effect) {
    PreparedScene prepared{std::move(scene)};
    return effect_mask(prepared, {.size = size, .frame = 20, .shutter = effect == Effect::blur ? 0.5f : 0.f}, effect, fresh);
}

bool is_set(metrics::Mask const& mask, int x, int y) { return mask[static_cast<std::size_t>(y * size.width + x)] != 0; }

void add_floor(SceneDescription& scene, Material material = {}) { scene.place(scene.add(rectangle(8, 8)), scene.add(std::move(material))); }

/// A small light high above, so that shadows are about as large as what casts them.
void add_light(SceneDescription& scene, Pose pose) {
    scene.place(scene.add(rectangle(0.2f, 0.2f)), scene.add(Material{.emission = glm::vec3{900.f}}), std::move(pose));
}
Pose still_light() { return fixed({{0, 20, 0}, turn(180, {1, 0, 0})}); }

/// Seen from straight above: x to the right, z down.
SceneDescription from_above() {
    auto scene = world({0, 6, 0.001f}, {0, 0, 0}, 40);
    return scene;
}

SceneDescription with_plate(Pose plate, Pose light) {
    auto scene = from_above();
    add_floor(scene);
    scene.place(scene.add(box({0.6f, 0.02f, 0.6f})), scene.add(Material{}), std::move(plate));
    add_light(scene, std::move(light));
    return scene;
}

Pose sliding(glm::vec3 at_frame_20, glm::vec3 step) {
    return [=](float frame) { return Transform{at_frame_20 + step * (frame - 20)}.matrix(); };
}

/// A box as tall as a wall, before a wall, seen level from the front.
SceneDescription before_wall(Pose pose) {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    scene.place(scene.add(rectangle(12, 12)), scene.add(Material{}), {.translation = {0, 0, -1}, .rotation = turn(90, {1, 0, 0})});
    scene.place(scene.add(box({0.5f, 6, 0.1f})), scene.add(Material{}), std::move(pose));
    return scene;
}

/// The pixel that shows a point.
glm::ivec2 pixel_of(SceneDescription const& scene, glm::vec3 point) { return projected(scene.camera_at(20, size), point, size); }

} // namespace

TEST_CASE("where nothing moves no pixel is touched") {
    for (auto effect : {Effect::shadow, Effect::glossy, Effect::indirect, Effect::curved, Effect::blur}) {
        CAPTURE(name_of(effect));
        auto scene = with_plate(fixed({{0, 1, 0}}), still_light());
        scene.place(scene.add_sphere(), scene.add(Material{.metallic = 1, .roughness = 0.2f}), {.translation = {1, 0.5f, 0.5f}});
        CHECK(share_of(mask_of(std::move(scene), effect)) == 0);
    }
}

TEST_CASE("a moving blocker's shadow and its trail are touched, and nothing else") {
    glm::vec3 const step{0.2f, 0, 0};
    auto const scene = with_plate(sliding({0.5f, 1, 0}, step), still_light());
    auto const mask = mask_of(scene, Effect::shadow);
    // The plate hides the middle of its own shadow from above; the shadow is larger by a twentieth and shows on the way it came.
    for (float ago : {2.f, 3.f, 4.f}) {
        auto const trail = pixel_of(scene, glm::vec3{0.525f, 0, 0} - step * ago);
        CHECK(is_set(mask, trail.x, trail.y));
    }
    for (auto point : {glm::vec3{-1.2f, 0, 0}, glm::vec3{1.4f, 0, 0}, glm::vec3{0.3f, 0, 0.8f}}) {
        auto const outside = pixel_of(scene, point);
        CHECK_FALSE(is_set(mask, outside.x, outside.y));
    }
    CHECK(share_of(mask) > 0.01);
    CHECK(share_of(mask) < 0.2);
}

TEST_CASE("a moving light moves the shadows of what stands still") {
    auto const light = [](float frame) { return Transform{{0.6f * (frame - 20) - 4, 20, 0}, turn(180, {1, 0, 0})}.matrix(); };
    CHECK(share_of(mask_of(with_plate(fixed({{0, 1, 0}}), light), Effect::shadow)) > 0.002);
}

TEST_CASE("light, blocker and receiver that move as one keep their shadow") {
    auto scene = from_above();
    int const carriage = scene.add_node([](float frame) {
        return Transform{{0.1f * (frame - 20), 0, 0}, turn(3 * frame, {0, 1, 0})}.matrix();
    });
    scene.place(scene.add(rectangle(8, 8)), scene.add(Material{}), {}, carriage);
    scene.place(scene.add(box({0.6f, 0.02f, 0.6f})), scene.add(Material{}), {.translation = {0.4f, 1, 0}}, carriage);
    scene.place(scene.add(rectangle(0.2f, 0.2f)), scene.add(Material{.emission = glm::vec3{900.f}}),
                {.translation = {3, 20, 0}, .rotation = turn(180, {1, 0, 0})}, carriage);
    CHECK(share_of(mask_of(std::move(scene), Effect::shadow)) == 0);
}

TEST_CASE("a box that slides to the right uncovers the strip that it leaves") {
    // 0.05 units per frame for 8 frames; what it uncovers on the wall, a quarter farther away, is a quarter wider.
    auto const scene = before_wall(sliding({0.2f, 0, 0}, {0.05f, 0, 0}));
    auto const mask = mask_of(scene, Effect::indirect);
    int const y = size.height / 2;
    int uncovered = 0;
    for (int x = 0; x < size.width; ++x) uncovered += is_set(mask, x, y) ? 1 : 0;
    float const expected = 0.4f / 4 * static_cast<float>(size.height) / 2 / std::tan(glm::radians(20.f));
    CHECK(std::abs(static_cast<float>(uncovered) - expected) <= 1.f);
    auto const strip = pixel_of(scene, {-0.05f - 0.2f, 0, 0}), other_side = pixel_of(scene, {0.55f, 0, 0}),
               on_box = pixel_of(scene, {0.2f, 0, 0.05f});
    CHECK(is_set(mask, strip.x, y));
    CHECK_FALSE(is_set(mask, other_side.x, y));
    CHECK_FALSE(is_set(mask, on_box.x, y));
}

TEST_CASE("what comes into the image was hidden before") {
    auto scene = before_wall(fixed({{100, 0, 0}}));
    scene.camera = [](float frame) { return look_at({0.05f * frame, 0, 4}, {0.05f * frame, 0, 0}, 40); };
    auto const mask = mask_of(std::move(scene), Effect::indirect);
    CHECK(is_set(mask, size.width - 1, size.height / 2));
    CHECK_FALSE(is_set(mask, 0, size.height / 2));
    CHECK_FALSE(is_set(mask, size.width / 2, size.height / 2));
}

TEST_CASE("reflections of what moves are touched, and on curved metal they are marked apart") {
    for (bool curved : {false, true}) {
        CAPTURE(curved);
        auto scene = world({0, 2, 4}, {0, 0, 0}, 40);
        int const metal = scene.add(Material{.metallic = 1, .roughness = 0.1f});
        if (curved)
            scene.place(scene.add_sphere(), metal, {.translation = {0, 0, 0}});
        else
            add_floor(scene, Material{.metallic = 1, .roughness = 0.1f});
        scene.place(scene.add(box({0.7f, 0.7f, 0.7f})), scene.add(Material{}), sliding({1.5f, 0.6f, 0.9f}, {0.1f, 0, 0}));
        auto const glossy = mask_of(scene, Effect::glossy), apart = mask_of(scene, Effect::curved);
        CHECK(share_of(glossy) > 0.003);
        CHECK(share_of(glossy) < 0.5);
        CHECK((share_of(apart) > 0) == curved);
        for (std::size_t i = 0; i < apart.size(); ++i) CHECK(apart[i] <= glossy[i]);
    }
}

TEST_CASE("a camera that moves touches all reflections that are not of things at the mirror") {
    auto scene = world({0, 1, 4}, {0, 0, 0}, 40);
    add_floor(scene, Material{.metallic = 1, .roughness = 0});
    scene.place(scene.add(rectangle(40, 40)), scene.add(Material{}), {.translation = {0, 0, -8}, .rotation = turn(90, {1, 0, 0})});
    scene.camera = [](float frame) { return look_at({0.05f * frame, 1, 4}, {0.05f * frame, 0, 0}, 40); };
    CHECK(share_of(mask_of(std::move(scene), Effect::glossy)) > 0.2);
}

TEST_CASE("a box is blurred from where it is when the shutter opens to where it is when the shutter closes") {
    auto scene = before_wall(sliding({-0.4f, 0, 0}, {1.6f, 0, 0}));
    auto const mask = mask_of(scene, Effect::blur);
    float const first = projected(scene.camera_at(20, size), {-0.65f, 0, 0.05f}, size).x;
    float const last = projected(scene.camera_at(20, size), {0.65f, 0, 0.05f}, size).x; // 0.8 to the right
    for (int x = 0; x < size.width; ++x) {
        float const centre = static_cast<float>(x) + 0.5f;
        if (std::min(std::abs(centre - first), std::abs(centre - last)) < 0.6f) continue;
        CAPTURE(x);
        CHECK(is_set(mask, x, size.height / 2) == (centre > first && centre < last));
    }
    PreparedScene prepared{std::move(scene)};
    CHECK(share_of(effect_mask(prepared, {.size = size, .frame = 20}, Effect::blur, fresh)) == 0); // the shutter is closed
}

TEST_CASE("a camera that moves while the shutter is open blurs everything, the sky too") {
    auto scene = before_wall(fixed({}));
    scene.instances.erase(scene.instances.begin());
    scene.camera = [](float frame) { return look_at({0.1f * frame, 0, 4}, {0.2f * frame, 0, 0}, 40); };
    CHECK(share_of(mask_of(std::move(scene), Effect::blur)) == 1);
}

TEST_CASE("shadows and reflections of what moves are blurred with it, where they are traced") {
    glm::vec3 const step{1.2f, 0, 0};
    // The light stands aside, so that the plate doesn't hide its shadow.
    auto scene = with_plate(sliding({-0.9f, 1, 0}, step), fixed({{0, 20, -10}, turn(180, {1, 0, 0})}));
    auto const shadow = pixel_of(scene, {-0.6f, 0, 0.6f});
    auto const everything = mask_of(scene, Effect::blur);
    scene.secondary_rays = false;
    auto const plate_alone = mask_of(scene, Effect::blur);
    CHECK(share_of(plate_alone) > 0);
    CHECK(share_of(everything) > share_of(plate_alone));
    for (std::size_t i = 0; i < everything.size(); ++i) CHECK(plate_alone[i] <= everything[i]);
    CHECK(is_set(everything, shadow.x, shadow.y));
    CHECK_FALSE(is_set(plate_alone, shadow.x, shadow.y));

    auto mirror = world({0, 2, 4}, {0, 0, 0}, 40);
    add_floor(mirror, Material{.metallic = 1, .roughness = 0});
    mirror.place(mirror.add(box(glm::vec3{0.5f})), mirror.add(Material{}), sliding({-0.3f, 0.9f, 0}, step));
    auto const image = pixel_of(mirror, {0, -0.9f, 0});
    CHECK(is_set(mask_of(mirror, Effect::blur), image.x, image.y));
    mirror.secondary_rays = false;
    CHECK_FALSE(is_set(mask_of(mirror, Effect::blur), image.x, image.y));
}

TEST_CASE("the scene stands at its frame again, and a mask is the same from the cache") {
    auto const folder = std::filesystem::temp_directory_path() / ("quell-masks-" + std::to_string(std::random_device{}()));
    PreparedScene scene{with_plate(sliding({0.5f, 1, 0}, {0.2f, 0, 0}), still_light())};
    RenderSettings const settings{.size = size, .frame = 20, .shutter = 0.5f};
    auto const first = effect_mask(scene, settings, Effect::shadow, {.cache = folder});
    CHECK(scene.frame() == 20);
    CHECK(scene.shutter() == 0.5f);
    CHECK(std::distance(std::filesystem::directory_iterator{folder}, {}) == 1);
    CHECK(effect_mask(scene, settings, Effect::shadow, {.cache = folder}) == first);
    CHECK(effect_mask(scene, settings, Effect::shadow, fresh) == first);
    std::filesystem::remove_all(folder);
}
