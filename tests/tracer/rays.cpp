#include "worlds.hpp"

#include <tracer/scenes/scenes.hpp>

#include <cstring>
#include <map>
#include <mutex>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{40, 24};
constexpr long long pixels = size.pixels();

template <class Wanted> RayCounts counts_for(PreparedScene& scene) {
    Pictures<Wanted> pictures{size};
    return render<Wanted>(scene, {.size = size, .frame = 32}, pictures);
}

/// Counts how often each channel is made.
struct Puts {
    std::map<std::string_view, int> of_channel{};
    std::mutex mutex{};
    template <class C> void put(C, int, int, Value<C::components, float> const&) {
        std::scoped_lock const lock(mutex);
        ++of_channel[C::name];
    }
};

static_assert(!Rays<Channels<Depth, Normal, Motion, Direct>>::shadow);
static_assert(!Rays<Channels<Depth, Light>>::shadow);
static_assert(Rays<Channels<Visibility>>::shadow && !Rays<Channels<Visibility>>::glossy && !Rays<Channels<Visibility>>::indirect);
static_assert(Rays<Channels<GlossyHit>>::glossy && !Rays<Channels<GlossyHit>>::reflected_radiance);
static_assert(Rays<Channels<Radiance>>::shadow && Rays<Channels<Radiance>>::glossy && Rays<Channels<Radiance>>::indirect);

} // namespace

TEST_CASE("exactly the rays that the wanted channels need are traced") {
    PreparedScene scene{built_in_scene("room")};
    CHECK(counts_for<Channels<Depth>>(scene) == RayCounts{.primary = pixels});
    CHECK(counts_for<Channels<Depth, Normal, Albedo, Motion, Direct, Light, LightPrevious, IndirectDirection>>(scene) ==
          RayCounts{.primary = pixels});

    auto const shadows = counts_for<Channels<Visibility, Blocker>>(scene);
    CHECK(shadows.primary == pixels);
    CHECK(shadows.shadow > pixels / 2);
    CHECK(shadows.shadow <= pixels);
    CHECK(shadows.glossy + shadows.indirect == 0);

    auto const hits = counts_for<Channels<GlossyHit>>(scene);
    CHECK(hits.glossy > 0);
    CHECK(hits.glossy < pixels);
    CHECK(hits.shadow + hits.indirect == 0);

    auto const bounced = counts_for<Channels<Indirect>>(scene);
    CHECK(bounced.indirect > pixels / 2);
    CHECK(bounced.indirect <= pixels);
    CHECK(bounced.shadow <= pixels);
    CHECK(bounced.glossy == 0);
}

TEST_CASE("without secondary rays a picture is unshadowed direct light and ambient light, exactly") {
    auto description = built_in_scene("room");
    description.background = {{0.1f, 0.2f, 0.3f}, {0.5f, 0.4f, 0.9f}};
    auto const background = description.background;
    PreparedScene scene{description};
    description.secondary_rays = false;
    PreparedScene plain{std::move(description)};
    using Wanted = Channels<Radiance, Direct, Visibility, Glossy, Indirect, Albedo, Normal, Instance, Blocker, GlossyHit>;
    Pictures<Wanted> pictures{size}, traced{size};
    render<Wanted>(scene, {.size = size, .frame = 32}, traced);
    CHECK(render<Wanted>(plain, {.size = size, .frame = 32, .samples_per_pixel = 3}, pictures) == RayCounts{.primary = pixels});
    int unlike = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            CHECK(glm::distance(pixel(pictures[direct], x, y), pixel(traced[direct], x, y)) < 1e-5f);
            auto const ambient = pixel(pictures[albedo], x, y) * background.ambient(pixel(pictures[normal], x, y));
            bool const emits = pixel(pictures[indirect], x, y) == glm::vec3{0.f};
            auto const expected = pixel(pictures[direct], x, y) + (emits ? glm::vec3{0.f} : ambient);
            CHECK(glm::distance(pixel(pictures[radiance], x, y), expected) < 1e-5f * (1 + glm::length(expected)));
            unlike += glm::distance(pixel(pictures[radiance], x, y), pixel(traced[radiance], x, y)) > 0.01f ? 1 : 0;
        }
    CHECK(unlike > pixels / 4);
}

TEST_CASE("without indirect rays only those are missing") {
    auto description = built_in_scene("room");
    description.indirect_rays = false;
    PreparedScene scene{std::move(description)};
    auto const counts = counts_for<Channels<Radiance>>(scene);
    CHECK(counts.indirect == 0);
    CHECK(counts.shadow > pixels / 2);
    CHECK(counts.glossy > 0);
}

TEST_CASE("ambient light is the mean of the background over the hemisphere, weighted by the cosine") {
    Background const background{{0.2f, 0.5f, 0.1f}, {0.8f, 0.1f, 0.4f}};
    for (auto normal : {glm::vec3{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0.48f, 0.6f, -0.64f}}) {
        glm::vec3 sum{0.f};
        constexpr std::uint32_t count = 4096;
        for (std::uint32_t i = 0; i < count; ++i)
            sum += background.radiance(cosine_direction(normal, sample_pair({{3, 4}, i, 0}, SampleUse::indirect)));
        CHECK(glm::distance(sum / static_cast<float>(count), background.ambient(normal)) < 1e-3f);
    }
}

TEST_CASE("a channel's values do not depend on which others are traced") {
    PreparedScene scene{built_in_scene("room")};
    Pictures<TracedChannels> all{size};
    Pictures<Channels<Visibility>> shadow{size};
    Pictures<Channels<Glossy, Indirect>> light{size};
    RenderSettings const settings{.size = size, .frame = 5, .seed = 3};
    render<TracedChannels>(scene, settings, all);
    render<Channels<Visibility>>(scene, settings, shadow);
    render<Channels<Glossy, Indirect>>(scene, settings, light);
    CHECK(all[visibility].pixels == shadow[visibility].pixels);
    CHECK(all[glossy].pixels == light[glossy].pixels);
    CHECK(all[indirect].pixels == light[indirect].pixels);
}

TEST_CASE("each channel is made once at each pixel") {
    Puts puts;
    PreparedScene scene{built_in_scene("room")};
    render<TracedChannels>(scene, {.size = size, .frame = 3, .samples_per_pixel = 2, .shutter = 0.5f}, puts);
    for_each_channel(TracedChannels{}, [&](auto channel) {
        INFO(channel.name); // put it in render.hpp, or leave it out of TracedChannels
        CHECK(puts.of_channel[channel.name] == size.width * size.height);
    });
}

TEST_CASE("pictures are the same for any number of threads") {
    PreparedScene scene{built_in_scene("room")};
    Pictures<TracedChannels> one{size}, two{size};
    auto const first = render<TracedChannels>(scene, {.size = size, .frame = 3, .samples_per_pixel = 2, .threads = 1}, one);
    auto const second = render<TracedChannels>(scene, {.size = size, .frame = 3, .samples_per_pixel = 2, .threads = 2}, two);
    CHECK(first == second);
    for_each_channel(TracedChannels{}, [&](auto channel) {
        auto const &a = one[channel].pixels, &b = two[channel].pixels;
        CHECK_MESSAGE(std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0, decltype(channel)::name);
    });
}

TEST_CASE("frames and seeds give different noise") {
    PreparedScene scene{built_in_scene("room")};
    using Wanted = Channels<Indirect>;
    Pictures<Wanted> a{size}, b{size}, c{size};
    render<Wanted>(scene, {.size = size, .frame = 3}, a);
    render<Wanted>(scene, {.size = size, .frame = 3, .seed = 1}, b);
    render<Wanted>(scene, {.size = size, .frame = 4}, c);
    CHECK(a[indirect].pixels != b[indirect].pixels);
    CHECK(a[indirect].pixels != c[indirect].pixels);
}

TEST_CASE("the composite is made of its parts") {
    PreparedScene scene{built_in_scene("room")};
    Pictures<TracedChannels> all{size};
    render<TracedChannels>(scene, {.size = size, .frame = 9, .samples_per_pixel = 3}, all);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const sum = pixel(all[direct], x, y) * pixel(all[visibility], x, y) + pixel(all[glossy], x, y) +
                             pixel(all[albedo], x, y) * pixel(all[indirect], x, y);
            CHECK(glm::distance(sum, pixel(all[radiance], x, y)) < 1e-4f * (1 + glm::length(sum)));
        }
}

TEST_CASE("settings that make no picture are refused") {
    PreparedScene scene{world({0, 0, 1}, {0, 0, 0})};
    Pictures<Channels<Depth>> pictures{{1, 1}};
    CHECK_THROWS_AS(render<Channels<Depth>>(scene, {.size = {0, 4}}, pictures), Error);
    CHECK_THROWS_AS(render<Channels<Depth>>(scene, {.size = {4, 4}, .samples_per_pixel = 0}, pictures), Error);
    CHECK_THROWS_AS(render<Channels<Depth>>(scene, {.size = {4, 4}, .shutter = 2}, pictures), Error);
}
