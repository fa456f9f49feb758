#include "../temporary_folder.hpp"
#include "worlds.hpp"

#include <tracer/reference.hpp>

#include <algorithm>
#include <set>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{48, 32};
auto const facing_viewer = glm::angleAxis(glm::radians(90.f), glm::vec3{1, 0, 0});
constexpr glm::vec3 eye{0.3f, 0.2f, 4};
/// In pixels per unit, at the distance of the plane z = 0 seen from the eye at 40 degrees.
float const pixels_per_unit = 16 / std::tan(glm::radians(20.f)) / 4;

/// Glowing bars and plates of different colours in the plane z = 0, before the sky; the camera looks straight at them.
SceneDescription flat_world(glm::vec2 shift = {0, 0}) {
    glm::vec3 const from = eye + glm::vec3(shift, 0.f);
    auto scene = world(from, from - glm::vec3{0, 0, 1}, 40);
    scene.background = {{0.1f, 0.2f, 0.3f}, {0.5f, 0.4f, 0.6f}};
    for (int i = 0; i < 5; ++i) {
        auto const step = static_cast<float>(i);
        scene.place(scene.add(rectangle(0.23f, 0.31f + 0.1f * step)), scene.add(Material{.emission = {1, 0.2f * step, 0.5f}}),
                    {.translation = {-1.3f + 0.61f * step, 0.17f * step - 0.4f, 0}, .rotation = facing_viewer});
    }
    return scene;
}

/// Everything to the right of this place in the image glows, the rest is dark.
SceneDescription lit_from(float column) {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    float const edge = (column - 24) / pixels_per_unit;
    scene.place(scene.add(rectangle(20, 20)), scene.add(Material{.emission = glm::vec3{1.f}}),
                {.translation = {edge + 10, 0, 0}, .rotation = facing_viewer});
    return scene;
}

/// A still room with a mirror, whose edges are many.
SceneDescription room_of_boxes() {
    auto scene = world({1, 2, 5}, {0, 0, 0});
    scene.background = {glm::vec3{0.2f}, glm::vec3{0.5f}};
    scene.place(scene.add(rectangle(20, 20)), scene.add(Material{.base = {0.7f, 0.5f, 0.3f}}), {.translation = {0, -1, 0}});
    scene.place(scene.add(box({1, 1, 1})), scene.add(Material{.base = {0.2f, 0.4f, 0.8f}, .metallic = 0.5f, .roughness = 0.3f}),
                {.rotation = glm::angleAxis(0.6f, glm::vec3{0, 1, 0})});
    scene.place(scene.add_sphere(), scene.add(Material{.emission = glm::vec3{9.f}}), {.translation = {2, 3, 1}, .scale = glm::vec3{0.4f}});
    return scene;
}

/// What of a Blackman-Harris window as wide as the filter lies left of this offset.
double filtered(double offset) {
    double const x = std::clamp(offset / (2 * filter_radius), -0.5, 0.5);
    constexpr double pi = std::numbers::pi;
    double const waves = 0.48829 * std::sin(2 * pi * x) + 0.14128 * std::sin(4 * pi * x) / 2 + 0.01168 * std::sin(6 * pi * x) / 3;
    return 0.5 + x + waves / (2 * pi) / 0.35875;
}

using Wanted = Channels<Radiance, Albedo, Normal, Roughness, Motion, Depth, Position, Instance, ReceiverPrevious, Direct, Visibility,
                        Glossy, Indirect, Light, GlossyHit>;

template <class Set> void check_equal(Pictures<Set> const& a, Pictures<Set> const& b) {
    for_each_channel(Set{}, [&]<class C>(C channel) {
        CAPTURE(C::name);
        // NaN is where there is nothing, in both.
        bool const equal = std::ranges::equal(a[channel].pixels, b[channel].pixels, [](glm::vec3 p, glm::vec3 q) {
            bool same = true;
            for (int i = 0; i < 3; ++i) same = same && (p[i] == q[i] || (std::isnan(p[i]) && std::isnan(q[i])));
            return same;
        });
        CHECK(equal);
    });
}

} // namespace

TEST_CASE("offsets of frames are sixteen different Halton points around the pixel's centre, over and over") {
    std::set<std::pair<float, float>> seen;
    for (int frame = -16; frame < 16; ++frame) {
        auto const offset = camera_jitter(Jitter::frame, frame);
        CHECK(std::min(offset.x, offset.y) >= -0.5f);
        CHECK(std::max(offset.x, offset.y) < 0.5f);
        CHECK(offset == camera_jitter(Jitter::frame, frame + 16));
        seen.emplace(offset.x, offset.y);
    }
    CHECK(seen.size() == 16);
    CHECK(glm::distance(camera_jitter(Jitter::frame, 0), {0, -1 / 6.f}) < 1e-6f);
    CHECK(glm::distance(camera_jitter(Jitter::frame, 1), {-0.25f, 1 / 6.f}) < 1e-6f);
    CHECK(glm::distance(camera_jitter(Jitter::frame, 2), {0.25f, -7 / 18.f}) < 1e-6f);
    for (auto const jitter : {Jitter::none, Jitter::pixel}) CHECK(camera_jitter(jitter, 3) == glm::vec2{0.f});
}

TEST_CASE("offsets of samples have the filter's mean and variance, in x and y apart") {
    constexpr int count = 1 << 14;
    glm::dvec2 mean{0.}, square{0.};
    double product = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::dvec2 const offset = filter_offset(sample_pair({{3, 5}, i, 1}, SampleUse::pixel_filter));
        mean += offset / double{count}, square += offset * offset / double{count}, product += offset.x * offset.y / count;
    }
    constexpr double squared_pi = std::numbers::pi * std::numbers::pi;
    double const of_unit = 1. / 12 + (-0.48829 / 2 + 0.14128 / 8 - 0.01168 / 18) / squared_pi / 0.35875;
    for (int axis : {0, 1}) {
        CHECK(std::abs(mean[axis]) < 1e-3);
        CHECK(square[axis] == doctest::Approx(of_unit * 9).epsilon(2e-3));
    }
    CHECK(std::abs(product) < 2e-3);
    CHECK(filter_offset(glm::vec2{0.f}) == glm::vec2{-filter_radius});
    CHECK(filter_offset(glm::vec2{0x1.fffffep-1f}).x <= filter_radius);
    for (float const u : {0.001f, 0.1f, 0.37f, 0.5f, 0.9f, 0.9999f}) {
        CHECK(filtered(filter_offset({u, 0.5f}).x) == doctest::Approx(u).epsilon(1e-4));
        CHECK(filter_offset({0.5f, u}).y == filter_offset({u, 0.5f}).x);
    }
}

TEST_CASE("without jitter, which is the default, one primary ray through the pixel's centre serves all samples") {
    PreparedScene scene{room_of_boxes()};
    Pictures<Wanted> plain{size}, many{size};
    CHECK(render<Wanted>(scene, {.size = size, .frame = 3}, plain).primary == size.pixels());
    CHECK(render<Wanted>(scene, {.size = size, .frame = 3, .samples_per_pixel = 4}, many).primary == size.pixels());
    check_equal<Wanted>(plain, pictures_of<Wanted>(room_of_boxes(), {.size = size, .frame = 3, .jitter = Jitter::none}));
    auto const camera = scene.description().camera_at(3, size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (pixel(many[instance], x, y).x != 0)
                CHECK(glm::distance(projected(camera, pixel(many[position], x, y), size), glm::vec2(x, y) + 0.5f) < 1e-3f);
}

TEST_CASE("a frame's jitter is a shift of the projection, the camera's own") {
    for (int frame : {0, 1, 5, 17}) {
        auto description = room_of_boxes();
        auto camera = description.camera_at(static_cast<float>(frame), size);
        auto const offset = camera_jitter(Jitter::frame, frame);
        camera.projection[2][0] += 2 * offset.x / static_cast<float>(size.width);
        camera.projection[2][1] -= 2 * offset.y / static_cast<float>(size.height);
        auto const pictures =
            pictures_of<Wanted>(std::move(description), {.size = size, .frame = frame, .samples_per_pixel = 2, .jitter = Jitter::frame});
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (pixel(pictures[instance], x, y).x != 0)
                    CHECK(glm::distance(projected(camera, pixel(pictures[position], x, y), size), glm::vec2(x, y) + 0.5f) < 1e-3f);
        for (auto const& value : pictures[motion].pixels) CHECK(value == glm::vec3{0.f});
    }
}

TEST_CASE("a frame's jitter shows what a camera shows that is moved along with it") {
    for (int frame : {0, 1, 2, 9}) {
        auto const offset = camera_jitter(Jitter::frame, frame);
        auto const jittered =
            pictures_of<Channels<Radiance, Instance>>(flat_world(), {.size = size, .frame = frame, .jitter = Jitter::frame});
        auto const moved = pictures_of<Channels<Radiance, Instance>>(flat_world(glm::vec2{offset.x, -offset.y} / pixels_per_unit),
                                                                     {.size = size, .frame = frame});
        auto const centred = pictures_of<Channels<Radiance, Instance>>(flat_world(), {.size = size, .frame = frame});
        CHECK(jittered[instance].pixels == moved[instance].pixels);
        CHECK(jittered[instance].pixels != centred[instance].pixels);
        for (std::size_t i = 0; i < jittered[radiance].pixels.size(); ++i)
            if (jittered[instance].pixels[i].x != 0) CHECK(jittered[radiance].pixels[i] == moved[radiance].pixels[i]);
    }
}

TEST_CASE("motion has no jitter in it: of a camera that moves it is that of the projections at the jittered place") {
    auto scene = room_of_boxes();
    scene.camera = [](float frame) { return look_at({0.2f * frame, 2, 5}, {0, 0.1f * frame, 0}, 60); };
    auto const before = scene.camera_at(4, size);
    auto const pictures = pictures_of<Wanted>(std::move(scene), {.size = size, .frame = 5, .jitter = Jitter::frame});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (pixel(pictures[instance], x, y).x == 0) continue;
            auto const place = glm::vec2(x, y) + 0.5f + camera_jitter(Jitter::frame, 5);
            auto const was = projected(before, pixel(pictures[receiver_previous], x, y), size);
            CHECK(glm::distance(was - place, glm::vec2(pixel(pictures[motion], x, y))) < 2e-3f);
        }
}

TEST_CASE("with jitter of the samples an edge is as soft as the filter") {
    for (float const edge : {24.f, 24.3f, 24.75f}) {
        auto const pictures =
            pictures_of<Channels<Radiance>>(lit_from(edge), {.size = size, .frame = 2, .samples_per_pixel = 1024, .jitter = Jitter::pixel});
        for (int x = 20; x < 30; ++x) {
            double const covered = 1 - filtered(edge - (x + 0.5));
            CHECK(std::abs(pixel(pictures[radiance], x, 16).x - covered) < 4e-3);
        }
    }
}

TEST_CASE("a reference with jitter of the samples has the filter's edges, whatever the effect") {
    PreparedScene scene{lit_from(24.3f)};
    ReferenceSettings const until{.tolerance = 0.001, .max_samples = 2048, .use_cache = false};
    RenderSettings const how{.size = size, .frame = 2, .jitter = Jitter::pixel};
    auto const whole = reference<Channels<Radiance>>(scene, how, until);
    auto const parts = reference<Channels<Visibility, Glossy, Indirect>>(scene, how, until);
    for (int x = 20; x < 30; ++x) {
        auto const covered = static_cast<float>(1 - filtered(24.3 - (x + 0.5)));
        CHECK(std::abs(pixel(whole[radiance], x, 16).x - covered) < 0.02f);
        CHECK(std::abs(pixel(parts[direct], x, 16).x - covered) < 0.02f);
        CHECK(pixel(parts[albedo], x, 16) == glm::vec3{1.f});
    }
    // A frame's own offset is the same in all samples, and the reference has it too.
    auto const sharp = reference<Channels<Radiance>>(scene, {.size = size, .frame = 2, .jitter = Jitter::frame}, until);
    auto const column = 23.5f + camera_jitter(Jitter::frame, 2).x;
    CHECK(pixel(sharp[radiance], 23, 16).x == (column > 24.3f ? 1 : 0));
    CHECK(pixel(sharp[radiance], 24, 16).x == (column + 1 > 24.3f ? 1 : 0));
}

TEST_CASE("guides of many samples are means, and places are the first sample's") {
    RenderSettings how{.size = size, .frame = 4, .samples_per_pixel = 8, .jitter = Jitter::pixel};
    auto const all = pictures_of<Wanted>(room_of_boxes(), how);
    // The same samples, one at a time.
    Pictures<Wanted> mean{size};
    std::vector<Pictures<Wanted>> each;
    for (int i = 0; i < 8; ++i) {
        auto one = how;
        one.samples_per_pixel = 1, one.first_sample = 8 * how.frame - how.frame + i;
        each.push_back(pictures_of<Wanted>(room_of_boxes(), one));
        for_each_channel(Wanted{}, [&](auto channel) {
            for (std::size_t p = 0; p < mean[channel].pixels.size(); ++p) mean[channel].pixels[p] += each.back()[channel].pixels[p] / 8.f;
        });
    }
    int edges = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const near = [&](auto channel) { return glm::distance(pixel(all[channel], x, y), pixel(mean[channel], x, y)) < 1e-4f; };
            for (bool const equal : {near(albedo), near(roughness), near(motion), near(direct), near(visibility), near(glossy),
                                     near(indirect), near(radiance)})
                CHECK(equal);
            auto const expected = pixel(mean[normal], x, y);
            edges += glm::length(expected) < 0.99f ? 1 : 0;
            CHECK(glm::distance(pixel(all[normal], x, y), glm::normalize(expected)) < 1e-4f);
        }
    CHECK(edges > 20);
    for_each_channel(Channels<Depth, Position, Instance, ReceiverPrevious, Light, GlossyHit>{}, [&](auto channel) {
        for (std::size_t p = 0; p < all[channel].pixels.size(); ++p) {
            auto const a = all[channel].pixels[p], b = each[0][channel].pixels[p];
            CHECK((a == b || (std::isnan(a.x) && std::isnan(b.x))));
        }
    });
    for (auto const& value : all[motion].pixels) CHECK(value == glm::vec3{0.f});
}

TEST_CASE("normals that cancel leave the first sample's") {
    // Floor and ceiling meet at the horizon.
    auto scene = world({0, 0, 0}, {0, 0, -1});
    scene.place(scene.add(rectangle(1e4f, 1e4f)), scene.add(Material{}), {.translation = {0, -0.1f, 0}});
    scene.place(scene.add(rectangle(1e4f, 1e4f)), scene.add(Material{}), {.translation = {0, 0.1f, 0}});
    auto const pictures =
        pictures_of<Channels<Normal>>(std::move(scene), {.size = {64, 33}, .samples_per_pixel = 2, .jitter = Jitter::pixel});
    for (auto const& value : pictures[normal].pixels) CHECK(glm::length(value) == doctest::Approx(1).epsilon(1e-5));
}

TEST_CASE("each sample has a primary ray of its own, also over an open shutter") {
    for (float const shutter : {0.f, 0.5f}) {
        PreparedScene scene{room_of_boxes()};
        RenderSettings how{.size = size, .frame = 2, .samples_per_pixel = 3, .shutter = shutter, .jitter = Jitter::pixel};
        Pictures<Wanted> pictures{size}, again{size};
        how.threads = 1;
        CHECK(render<Wanted>(scene, how, pictures).primary == 3 * size.pixels());
        how.threads = 3;
        render<Wanted>(scene, how, again);
        check_equal<Wanted>(pictures, again);
        how.jitter = Jitter::none;
        render<Wanted>(scene, how, again);
        CHECK(again[position].pixels != pictures[position].pixels);
        how.jitter = Jitter::frame;
        render<Wanted>(scene, how, pictures);
        CHECK(again[position].pixels != pictures[position].pixels);
    }
}

TEST_CASE("what moves over an open shutter is soft by the filter as well") {
    auto const still = lit_from(24.3f);
    RenderSettings how{.size = size, .samples_per_pixel = 1024, .shutter = 1, .jitter = Jitter::pixel};
    auto const pictures = pictures_of<Channels<Radiance>>(still, how);
    for (int x = 20; x < 30; ++x) CHECK(std::abs(pixel(pictures[radiance], x, 16).x - (1 - filtered(24.3 - (x + 0.5)))) < 0.02);
    how.jitter = Jitter::frame;
    auto const sharp = pictures_of<Channels<Radiance>>(still, how);
    for (auto const& value : sharp[radiance].pixels) CHECK((value.x == 0 || value.x == 1));
}

TEST_CASE("gradients are those of the first sample's point: none where nothing changes, all of a light that goes on") {
    using Gradient = Channels<Radiance, GradientOf<Radiance>>;
    for (auto const jitter : {Jitter::frame, Jitter::pixel}) {
        RenderSettings const how{.size = size, .frame = 10, .samples_per_pixel = 2, .jitter = jitter};
        auto const still = pictures_of<Gradient>(room_of_boxes(), how);
        auto description = room_of_boxes();
        description.background = {};
        description.materials.back().brightness = [](float frame) { return frame < 10 ? 0.5f : 1.f; };
        auto const brighter = pictures_of<Gradient>(std::move(description), how);
        int compared = 0;
        for (auto const& value : still[GradientOf<Radiance>{}].pixels) {
            compared += value.y > 0 ? 1 : 0;
            CHECK(value.x == 0);
        }
        CHECK(compared > size.pixels() / 30);
        for (auto const& value : brighter[GradientOf<Radiance>{}].pixels) CHECK(value.x == doctest::Approx(value.y / 2).epsilon(1e-4));
    }
}

TEST_CASE("references of one jitter are never taken for those of another") {
    quell::tests::Folder const folder;
    ReferenceSettings const settings{
        .tolerance = 0.5, .max_samples = 8, .min_samples_of_blur = 0, .samples_per_pass = 4, .cache = folder / "cache"};
    PreparedScene scene{room_of_boxes()};
    auto const found = [&](Jitter jitter, int frame, float shutter = 0) {
        return reference<Channels<Glossy>>(scene, {.size = size, .frame = frame, .shutter = shutter, .jitter = jitter}, settings);
    };
    std::vector<Reference> fresh;
    for (float const shutter : {0.f, 0.5f})
        for (int frame : {3, 4})
            for (auto const jitter : jitters) {
                fresh.push_back(found(jitter, frame, shutter));
                CHECK(!fresh.back().from_cache);
            }
    std::size_t i = 0;
    for (float const shutter : {0.f, 0.5f})
        for (int frame : {3, 4})
            for (auto const jitter : jitters) {
                auto const again = found(jitter, frame, shutter);
                CHECK(again.from_cache);
                CHECK(again[quell::glossy].pixels == fresh[i][quell::glossy].pixels);
                if (i > 0) CHECK(again[quell::glossy].pixels != fresh[i - 1][quell::glossy].pixels);
                ++i;
            }
}
