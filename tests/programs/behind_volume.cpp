#include "passes.hpp"

#include <denoise/behind_volume.hpp>

#include <quell/io/frame_image.hpp>

using namespace quell;
using namespace quell::tests;
using examples::names_behind_volume;

namespace {

constexpr Extent size{24, 16};
constexpr int sky_from = 16;  ///< columns behind which there is no surface
constexpr float miss = 1e10f; ///< depth
constexpr glm::vec3 paint{.8f, .4f, .2f};

bool in_fog(int y) { return y >= 6; }
/// Of the rays in fog, those that hit what lies behind it.
bool hits(int x, int y) { return !in_fog(y) || (x * 7 + y * 5) % 3 != 0; }

io::SequenceNames names() {
    io::SequenceNames result{"a test", {{"diffuse"}, {"volume"}}, three({"sky"}), three({"beauty"})};
    for (auto& signal : result.of_signals) {
        signal.channels.sources["radiance"] = three({signal.name});
        signal.channels.sources["albedo"] = std::vector<io::Source>(3, io::Source{{}, 1.f});
        signal.channels.miss_from = 1e9f;
    }
    result.of_signals[0].factor = three({"paint"});
    return result;
}
/// A painted wall at depth 3, and sky, whose lower part is seen through fog. Of the samples of a pixel that hits, a part does.
io::ExrImage wall_in_fog(float part_of_hits) {
    io::ExrImage image{"a test", size};
    auto const is_wall = [](int x, int y) { return x < sky_from && hits(x, y); };
    auto const part = [=](int y) { return in_fog(y) ? part_of_hits : 1.f; };
    auto const type = io::SampleType::float32;
    add_pass(image, "diffuse",
             colours(size, [&](int x, int y) { return glm::vec3(is_wall(x, y) ? 1.f + .1f * static_cast<float>(x) : 0.f); }), type);
    add_pass(image, "paint", colours(size, [&](int x, int y) { return is_wall(x, y) ? paint * part(y) : glm::vec3(0.f); }), type);
    add_pass(image, "volume", colours(size, [&](int x, int y) { return glm::vec3(hits(x, y) && part(y) == 1.f ? 0.f : .5f); }), type);
    add_pass(image, "sky", colours(size, [&](int x, int y) { return glm::vec3(x >= sky_from && hits(x, y) ? .25f : 0.f); }), type);
    add_guides(image, [&](int x, int y) { return is_wall(x, y) ? 3.f : miss; }, {2.f, 0.f});
    for (auto& plane : image.planes)
        if (plane.name == "normal.Z")
            for (std::size_t i = 0; i < plane.values.size(); ++i) {
                int const x = static_cast<int>(i) % size.width, y = static_cast<int>(i) / size.width;
                plane.values[i] = is_wall(x, y) ? part(y) : 0.f;
            }
    auto const light = pass(image, "diffuse"), colour = pass(image, "paint"), fog = pass(image, "volume"), sky = pass(image, "sky");
    Colours sum;
    for (std::size_t i = 0; i < light.size(); ++i) sum.push_back(light[i] * colour[i] + fog[i] + sky[i]);
    add_pass(image, "beauty", sum, type);
    return image;
}
std::size_t at(int x, int y) { return static_cast<std::size_t>(y * size.width + x); }

} // namespace

TEST_CASE("seen through fog, guides have no holes, and colours are those of what was hit") {
    for (float const part : {1.f, .25f}) {
        CAPTURE(part);
        auto image = wall_in_fog(part);
        auto const seen = names_behind_volume(image, names());
        REQUIRE(seen);
        for (auto const& signal : seen->of_signals) {
            auto const z = io::component_of(image, io::sources_of(signal.channels, depth)[0]);
            for (int y = 8; y < size.height; ++y) {
                for (int x = 0; x < sky_from; ++x) CHECK(z[at(x, y)] == 3.f);
                for (int x = sky_from + 3; x < size.width; ++x) {
                    CHECK(z[at(x, y)] > 3.f); // far behind, and no miss: fog before the sky is smoothed too
                    CHECK(z[at(x, y)] < 1e9f);
                }
            }
        }
        auto const colour = pixels_of(examples::picture_of(image, seen->of_signals[0].factor, 1.f));
        for (int y = 8; y < size.height; ++y)
            for (int x = 0; x < sky_from; ++x)
                for (int c = 0; c < 3; ++c) CHECK(colour[at(x, y)][c] == doctest::Approx(paint[c]));
    }
}

TEST_CASE("seen through fog, signals and what is added sum up to the picture as before, and the sky is light in the fog") {
    for (float const part : {1.f, .25f}) {
        auto image = wall_in_fog(part);
        auto const seen = names_behind_volume(image, names());
        REQUIRE(seen);
        auto const light = pixels_of(examples::picture_of(image, io::sources_of(seen->of_signals[0].channels, radiance), 0.f));
        auto const colour = pixels_of(examples::picture_of(image, seen->of_signals[0].factor, 1.f));
        auto const fog = pixels_of(examples::picture_of(image, io::sources_of(seen->of_signals[1].channels, radiance), 0.f));
        auto const added = pixels_of(examples::picture_of(image, seen->added, 0.f));
        auto const picture = pass(image, "beauty");
        for (std::size_t i = 0; i < picture.size(); ++i)
            for (int c = 0; c < 3; ++c) CHECK(light[i][c] * colour[i][c] + fog[i][c] + added[i][c] == doctest::Approx(picture[i][c]));
        CHECK(added[at(20, 12)] == glm::vec3(0.f));
        auto const split = examples::split_light(image, *seen, {}, false);
        CHECK(split.active == std::vector{true, true, false});
    }
}

TEST_CASE("what no fog lies before, or around, stays as it is") {
    auto image = wall_in_fog(1.f);
    auto const seen = names_behind_volume(image, names());
    REQUIRE(seen);
    auto const z = io::component_of(image, io::sources_of(seen->of_signals[0].channels, depth)[0]);
    auto const added = pixels_of(examples::picture_of(image, seen->added, 0.f)),
               light = pixels_of(examples::picture_of(image, io::sources_of(seen->of_signals[0].channels, radiance), 0.f));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < size.width; ++x) {
            CHECK(z[at(x, y)] == image["depth.Z"].values[at(x, y)]);
            CHECK(added[at(x, y)] == pass(image, "sky")[at(x, y)]);
            CHECK(light[at(x, y)] == pass(image, "diffuse")[at(x, y)]);
        }
    auto clear = wall_in_fog(1.f);
    for (auto& plane : clear.planes)
        if (plane.name.starts_with("volume.")) std::ranges::fill(plane.values, 0.f);
    auto const planes = clear.planes.size();
    CHECK_FALSE(names_behind_volume(clear, names()));
    CHECK(clear.planes.size() == planes);
    auto without = names();
    without.of_signals.pop_back();
    CHECK_FALSE(names_behind_volume(image, without));
}
