#include "passes.hpp"

#include <denoise/empty_guides.hpp>

#include <quell/core/random.hpp>
#include <quell/io/frame_image.hpp>

#include <glm/geometric.hpp>

using namespace quell;
using namespace quell::tests;
using examples::EmptyPasses;
using examples::fill_noisy_normals;

// Normals that are noise, beside those of bumps.
namespace {

constexpr Extent size{64, 48};
constexpr int horizon = 16; ///< rows above which there is sky

/// Uniform in [-1, 1), of a pixel and a number.
float noise(int x, int y, int number) { return 2.f * uniform_pair(static_cast<float>(x), static_cast<float>(y), number).first - 1.f; }
glm::vec3 rough_normal(int x, int y, float by) {
    return glm::normalize(glm::vec3(0.f, 1.f, 0.f) + by * glm::vec3(noise(x, y, 0), noise(x, y, 1), noise(x, y, 2)));
}
glm::vec3 const to_light = glm::normalize(glm::vec3(1.f, 1.5f, .5f));

/// A floor before a sky.
/// @param normals of a pixel of the floor
/// @param light   of a pixel and its normal, before noise
/// @param depth   of the floor, times that of a plane
io::ExrImage floor_with(auto const& normals, auto const& light, auto const& depth) {
    auto image = noisy_image(size, 1);
    for (auto& plane : image.planes)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto& value = plane.values[static_cast<std::size_t>(y * size.width + x)];
                bool const is_sky = y < horizon;
                auto const n = is_sky ? glm::vec3(0.f) : normals(x, y);
                if (plane.name == "depth.Z")
                    value = is_sky ? std::numeric_limits<float>::infinity() : depth(x, y) * 100.f / static_cast<float>(y - 7);
                if (plane.name == "normal.X") value = n.x;
                if (plane.name == "normal.Y") value = n.y;
                if (plane.name == "normal.Z") value = n.z;
                if (plane.name == "R" || plane.name == "G" || plane.name == "B") value = light(n) * (1.f + .8f * noise(x, y, 3));
            }
    return image;
}
float even(int, int) { return 1.f; }
float evenly_lit(glm::vec3 const&) { return 1.f; }
float lit(glm::vec3 const& n) { return std::max(glm::dot(n, to_light), 0.f); }
bool are_filled(io::ExrImage image) {
    auto const before = image["normal.Y"].values;
    bool const filled = fill_noisy_normals(image, io::own_sequence());
    CHECK((image["normal.Y"].values != before) == filled);
    return filled;
}

} // namespace

TEST_CASE("normals that are noise become a constant on surfaces") {
    auto image = floor_with([](int x, int y) { return rough_normal(x, y, .9f); }, evenly_lit, even);
    CHECK(fill_noisy_normals(image, io::own_sequence()));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (std::string const plane : {"normal.X", "normal.Y", "normal.Z"})
                CHECK(image[plane].values[static_cast<std::size_t>(y * size.width + x)] ==
                      (plane == "normal.Z" && y >= horizon ? 1.f : 0.f));
}

TEST_CASE("normals that light goes with stay, however rough they are, and so do smooth ones") {
    auto const rough = [](int x, int y) { return rough_normal(x, y, .9f); };
    CHECK_FALSE(are_filled(floor_with(rough, lit, even)));
    CHECK_FALSE(are_filled(floor_with([](int x, int y) { return rough_normal(x, y, .05f); }, evenly_lit, even)));
    CHECK_FALSE(are_filled(floor_with([](int, int) { return glm::vec3(0.f, 1.f, 0.f); }, evenly_lit, even)));
    // Some of the floor is not enough.
    CHECK_FALSE(are_filled(floor_with([&](int x, int y) { return x < 40 ? rough(x, y) : glm::vec3(0.f, 1.f, 0.f); }, evenly_lit, even)));
}

TEST_CASE("normals stay where no depth says that a surface is plane") {
    auto const rough = [](int x, int y) { return rough_normal(x, y, .9f); };
    CHECK_FALSE(are_filled(floor_with(rough, evenly_lit, [](int x, int y) { return 1.f + .9f * noise(x, y, 4); })));
    CHECK_FALSE(are_filled(floor_with(rough, evenly_lit, [](int, int) { return std::numeric_limits<float>::infinity(); })));
    auto image = floor_with(rough, evenly_lit, even);
    std::erase_if(image.planes, [](auto const& plane) { return plane.name == "depth.Z"; });
    CHECK_FALSE(are_filled(image));
}

TEST_CASE("a signal without normals of its own stays as it is where another's are noise") {
    auto image = floor_with([](int x, int y) { return rough_normal(x, y, .9f); }, evenly_lit, even);
    auto names = io::own_sequence();
    auto other = names.of_signals[0];
    other.channels.sources["normal"] = {{{"absent.X"}}, {{"absent.Y"}}, {{"absent.Z"}}};
    names.of_signals.push_back(other);
    CHECK(fill_noisy_normals(image, names));
    CHECK(image["normal.Z"].values.back() == 1.f);
}

TEST_CASE("light of any unit tells noise from bumps, and what is not finite does not count") {
    auto const rough = [](int x, int y) { return rough_normal(x, y, .9f); };
    for (float const unit : {0x1p-40f, 0x1p40f}) {
        CHECK(are_filled(floor_with(
            rough, [&](auto const&) { return unit; }, even)));
        CHECK_FALSE(are_filled(floor_with(
            rough, [&](auto const& n) { return unit * lit(n); }, even)));
    }
    auto image = floor_with(rough, evenly_lit, even);
    for (auto& plane : image.planes) plane.values[static_cast<std::size_t>(size.width * 30 + 9)] = std::numeric_limits<float>::quiet_NaN();
    CHECK(are_filled(image));
}

TEST_CASE("one sentence says that normals are noise") {
    EmptyPasses passes;
    passes.add({.noise = true});
    passes.add({});
    REQUIRE(passes.remarks().size() == 1);
    CHECK(contains(passes.remarks()[0], "normals is noise"));
}
