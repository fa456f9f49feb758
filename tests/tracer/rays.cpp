#include "worlds.hpp"

#include <tracer/scenes/scenes.hpp>

#include <cstring>

using namespace quell;
using namespace quell::tracer;

namespace {

constexpr Extent size{40, 24};
constexpr long long pixels = size.pixels();

template <class Wanted> RayCounts counts_for(PreparedScene& scene) {
    Pictures<Wanted> pictures{size};
    return render<Wanted>(scene, {.size = size, .frame = 32}, pictures);
}

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

TEST_CASE("a channel's values do not depend on which others are traced") {
    PreparedScene scene{built_in_scene("room")};
    Pictures<AllChannels> all{size};
    Pictures<Channels<Visibility>> shadow{size};
    Pictures<Channels<Glossy, Indirect>> light{size};
    RenderSettings const settings{.size = size, .frame = 5, .seed = 3};
    render<AllChannels>(scene, settings, all);
    render<Channels<Visibility>>(scene, settings, shadow);
    render<Channels<Glossy, Indirect>>(scene, settings, light);
    CHECK(all[visibility].pixels == shadow[visibility].pixels);
    CHECK(all[glossy].pixels == light[glossy].pixels);
    CHECK(all[indirect].pixels == light[indirect].pixels);
}

TEST_CASE("pictures are the same for any number of threads") {
    PreparedScene scene{built_in_scene("room")};
    Pictures<AllChannels> one{size}, two{size};
    auto const first = render<AllChannels>(scene, {.size = size, .frame = 3, .samples_per_pixel = 2, .threads = 1}, one);
    auto const second = render<AllChannels>(scene, {.size = size, .frame = 3, .samples_per_pixel = 2, .threads = 2}, two);
    CHECK(first == second);
    for_each_channel(AllChannels{}, [&](auto channel) {
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
    Pictures<AllChannels> all{size};
    render<AllChannels>(scene, {.size = size, .frame = 9, .samples_per_pixel = 3}, all);
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
