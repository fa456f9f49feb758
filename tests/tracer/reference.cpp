#include "../temporary_folder.hpp"
#include "worlds.hpp"

#include <tracer/reference.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{32, 18};
using Wanted = Channels<Visibility, Indirect, Radiance>;

SceneDescription little_world(float height = 2) {
    auto scene = world({0, 1, 3}, {0, 0.3f, 0}, 45);
    scene.background = {glm::vec3{0.2f}, glm::vec3{0.3f}};
    scene.place(scene.add(rectangle(10, 10)), scene.add(Material{.base = {0.7f, 0.3f, 0.2f}}));
    scene.place(scene.add(box({0.5f, 0.5f, 0.5f})), scene.add(Material{}), {.translation = {0, 0.4f, 0}});
    scene.place(scene.add_sphere(), scene.add(Material{.emission = glm::vec3{12}}),
                {.translation = {0.5f, height, 0}, .scale = glm::vec3{0.3f}});
    return scene;
}

/// A cache of the test's own, which is not there yet.
struct Cache {
    quell::tests::Folder folder;
    std::filesystem::path path = folder / "cache";
    [[nodiscard]] std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> found;
        if (std::filesystem::exists(path))
            for (auto const& entry : std::filesystem::directory_iterator{path}) found.push_back(entry.path());
        return found;
    }
};

} // namespace

TEST_CASE("a reference converges, and its halves say so") {
    PreparedScene scene{little_world()};
    int calls = 0;
    auto const settings = ReferenceSettings{.tolerance = 0.02, .use_cache = false, .progress = [&](ReferenceProgress const&) { ++calls; }};
    auto const found = reference<Wanted>(scene, {.size = size}, settings);
    CHECK(found.half_difference < 0.02);
    CHECK(found.samples >= 32);
    CHECK(calls >= 1);
    // An independent rendering with many samples agrees.
    Pictures<Wanted> many{size};
    render<Wanted>(scene, {.size = size, .samples_per_pixel = 1024, .seed = 77}, many);
    double error = 0;
    for (std::size_t i = 0; i < many[radiance].pixels.size(); ++i)
        error += std::abs(many[radiance].pixels[i].x - found[radiance].pixels[i].x);
    CHECK(error / static_cast<double>(size.pixels()) < 0.01);
}

TEST_CASE("a reference ends at the most samples") {
    PreparedScene scene{little_world()};
    auto const found =
        reference<Wanted>(scene, {.size = size}, {.tolerance = 1e-9, .max_samples = 100, .samples_per_pass = 8, .use_cache = false});
    CHECK(found.samples <= 100);
    CHECK(found.samples >= 80);
    CHECK(found.half_difference > 1e-9);
}

TEST_CASE("references are cached by all that they depend on") {
    Cache const cache;
    ReferenceSettings const settings{.tolerance = 0.05, .cache = cache.path};
    PreparedScene scene{little_world()};
    auto const first = reference<Wanted>(scene, {.size = size, .frame = 4}, settings);
    CHECK(!first.from_cache);
    CHECK(cache.files().size() == 3);
    PreparedScene same{little_world()};
    auto const second = reference<Wanted>(same, {.size = size, .frame = 4}, settings);
    CHECK(second.from_cache);
    CHECK(second.samples == first.samples);
    CHECK(second[radiance].pixels == first[radiance].pixels);
    CHECK(second[visibility].pixels == first[visibility].pixels);

    PreparedScene other{little_world(2.1f)};
    CHECK(!reference<Wanted>(other, {.size = size, .frame = 4}, settings).from_cache);
    CHECK(!reference<Wanted>(scene, {.size = size, .frame = 5}, settings).from_cache);
    CHECK(reference<Channels<Indirect>>(scene, {.size = size, .frame = 4}, settings).from_cache);
    for (RenderSettings const& changed :
         {RenderSettings{.size = {30, 18}, .frame = 4}, RenderSettings{.size = size, .frame = 4, .seed = 1},
          RenderSettings{.size = size, .frame = 4, .shutter = 0.5f}, RenderSettings{.size = size, .frame = 4, .jitter = Jitter::frame},
          RenderSettings{.size = size, .frame = 4, .jitter = Jitter::pixel}})
        CHECK(!reference<Wanted>(scene, changed, settings).from_cache);
    for (auto const& changed : {ReferenceSettings{.tolerance = 0.04, .cache = cache.path},
                                ReferenceSettings{.tolerance = 0.05, .max_samples = 256, .cache = cache.path},
                                ReferenceSettings{.tolerance = 0.05, .samples_per_pass = 4, .cache = cache.path}})
        CHECK(!reference<Wanted>(scene, {.size = size, .frame = 4}, changed).from_cache);
    RenderSettings const no_matter{
        .size = size, .frame = 4, .samples_per_pixel = 3, .threads = 1, .first_sample = 8, .shutter_keys = 3, .stratified_times = false};
    CHECK(reference<Wanted>(scene, no_matter, settings).from_cache);
}

TEST_CASE("references of an open shutter depend on its moments and the least samples too") {
    Cache const cache;
    ReferenceSettings const settings{.tolerance = 0.5, .min_samples_of_blur = 16, .samples_per_pass = 4, .cache = cache.path};
    PreparedScene scene{little_world()};
    auto const cached = [&](RenderSettings const& render_settings, ReferenceSettings const& how) {
        return reference<Channels<Radiance>>(scene, render_settings, how).from_cache;
    };
    RenderSettings const usual{.size = size, .shutter = 0.5f};
    CHECK(!cached(usual, settings));
    CHECK(cached(usual, settings));
    auto other = usual;
    other.shutter_keys = 17;
    CHECK(!cached(other, settings));
    other = usual;
    other.shutter = 0.4f;
    CHECK(!cached(other, settings));
    auto longer = settings;
    longer.min_samples_of_blur = 32;
    CHECK(!cached(usual, longer));
}

TEST_CASE("a damaged cache file is computed again") {
    Cache const cache;
    ReferenceSettings const settings{.tolerance = 0.05, .cache = cache.path};
    PreparedScene scene{little_world()};
    auto const first = reference<Channels<Indirect>>(scene, {.size = size}, settings);
    REQUIRE(cache.files().size() == 1);
    auto const file = cache.files()[0];
    auto const whole = std::filesystem::file_size(file);
    for (auto const length : {whole / 2, std::uintmax_t{5}, std::uintmax_t{0}}) {
        std::filesystem::resize_file(file, length);
        CHECK(!reference<Channels<Indirect>>(scene, {.size = size}, settings).from_cache);
        CHECK(std::filesystem::file_size(file) == whole);
    }
    std::fstream{file, std::ios::binary | std::ios::in | std::ios::out}.seekp(200) << 'x';
    CHECK(!reference<Channels<Indirect>>(scene, {.size = size}, settings).from_cache);
    auto const again = reference<Channels<Indirect>>(scene, {.size = size}, settings);
    CHECK(again.from_cache);
    CHECK(again[indirect].pixels == first[indirect].pixels);
}

TEST_CASE("a cache that can't be written doesn't matter") {
    PreparedScene scene{little_world()};
    CHECK_NOTHROW(reference<Channels<Indirect>>(scene, {.size = size}, {.tolerance = 0.1, .cache = "/proc/nowhere"}));
}

TEST_CASE("references of blur are stratified in time") {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    auto const facing_viewer = glm::angleAxis(glm::radians(90.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(0.8f, 0.8f)), scene.add(Material{.emission = glm::vec3{1.f}}), [=](float frame) {
        return Transform{{frame - 3.3f, 0, 0}, facing_viewer}.matrix();
    });
    PreparedScene prepared{std::move(scene)};
    RenderSettings const settings{.size = {48, 32}, .frame = 3, .shutter = 0.6f};
    auto const found = reference<Channels<Radiance>>(prepared, settings, {.tolerance = 0, .max_samples = 64, .use_cache = false});
    CHECK(found.samples == 64);
    float const pixels_per_unit = 16 / std::tan(glm::radians(20.f)) / 4;
    int blurred = 0;
    for (int x = 0; x < 48; ++x) {
        // The plate's middle goes from -0.3 to 0.3; the pixel is covered while that is within 0.4 of it.
        float const place = (static_cast<float>(x) + 0.5f - 24) / pixels_per_unit;
        float const covered = std::max(0.f, std::min(place + 0.4f, 0.3f) - std::max(place - 0.4f, -0.3f)) / 0.6f;
        bool const has_both_edges = place - 0.4f > -0.3f && place + 0.4f < 0.3f;
        // Each half has 32 strata, and an edge is in one of them: random times would miss by three times as much in one pixel of three.
        CHECK(std::abs(pixel(found[radiance], x, 16).x - covered) < (has_both_edges ? 2 : 1) / 32.f + 1e-4f);
        blurred += covered > 0.05f && covered < 0.95f ? 1 : 0;
    }
    CHECK(blurred > 10);
}

TEST_CASE("a frozen frame has the reference of the open shutter, and its file") {
    Cache const cache;
    ReferenceSettings const how{.tolerance = 0.5, .min_samples_of_blur = 0, .samples_per_pass = 4, .cache = cache.path};
    auto description = little_world();
    description.secondary_rays = false;
    description.camera = [](float frame) { return look_at({frame, 1, 3}, {frame, 0.3f, 0}, 45); };
    PreparedScene scene{std::move(description)};
    RenderSettings settings{.size = size, .shutter = 0.5f, .frozen_at = 0.5f};
    auto const frozen = reference<Channels<Radiance>>(scene, settings, how);
    CHECK(!frozen.from_cache);
    settings.frozen_at.reset();
    auto const blurred = reference<Channels<Radiance>>(scene, settings, how);
    CHECK(blurred.from_cache);
    CHECK(blurred[radiance].pixels == frozen[radiance].pixels);
    auto uncached = how;
    uncached.use_cache = false;
    CHECK(reference<Channels<Radiance>>(scene, settings, uncached)[radiance].pixels == frozen[radiance].pixels);
}

TEST_CASE("a reference of blur ends when its halves agree, and its frames have noise of their own") {
    auto description = little_world();
    description.secondary_rays = false;
    // Every frame shows the same: a quick start from the same place.
    description.camera = [](float frame) {
        float const x = 0.8f * (frame - std::floor(frame));
        return look_at({x, 1, 3}, {x, 0.3f, 0}, 45);
    };
    PreparedScene scene{std::move(description)};
    auto const at = [&](int frame, double tolerance) {
        return reference<Channels<Radiance>>(scene, {.size = size, .frame = frame, .shutter = 0.9f},
                                             {.tolerance = tolerance, .min_samples_of_blur = 0, .samples_per_pass = 2, .use_cache = false});
    };
    auto const rough = at(0, 0.03), later = at(1, 0.03), fine = at(0, 0.005);
    CHECK(rough.half_difference < 0.03);
    CHECK(fine.half_difference < 0.005);
    CHECK(fine.samples > rough.samples);
    CHECK(fine.samples < 2000);
    CHECK(later[radiance].pixels != rough[radiance].pixels);
    CHECK(reference<Channels<Radiance>>(scene, {.size = size, .shutter = 0.9f}, {.tolerance = 0.5, .use_cache = false}).samples == 128);
}
