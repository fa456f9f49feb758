#include "passes.hpp"

#include <denoise/empty_guides.hpp>

#include <nlohmann/json.hpp>

#include <quell/io/frame_image.hpp>

using namespace quell;
using namespace quell::tests;
using examples::EmptyPasses;
using examples::fill_empty_guides;

// Passes that renderers write and that say nothing.
namespace {

constexpr Extent size{24, 16};
constexpr int horizon = 5; ///< rows above which there is sky

/// A floor before a sky, as quell's own files have it.
io::ExrImage floor_and_sky() {
    auto image = noisy_image(size, 1);
    for (auto& plane : image.planes)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto& value = plane.values[static_cast<std::size_t>(y * size.width + x)];
                bool const is_sky = y < horizon;
                if (plane.name == "depth.Z") value = is_sky ? std::numeric_limits<float>::infinity() : 100.f / static_cast<float>(y + 1);
                if (plane.name == "normal.Y") value = is_sky ? 0.f : 1.f;
                if (plane.name == "normal.Z") value = 0.f;
            }
    return image;
}
void change(io::ExrImage& image, std::string const& layer, auto const& f) {
    for (auto& plane : image.planes)
        if (plane.name.starts_with(layer + "."))
            for (std::size_t i = 0; i < plane.values.size(); ++i)
                plane.values[i] = f(static_cast<int>(i) % size.width, static_cast<int>(i) / size.width, plane.values[i]);
}
float value(io::ExrImage const& image, std::string const& plane, int x, int y) {
    return image[plane].values[static_cast<std::size_t>(y * size.width + x)];
}
std::vector<std::vector<float>> values_of(io::ExrImage const& image) {
    std::vector<std::vector<float>> all;
    for (auto const& plane : image.planes) all.push_back(plane.values);
    return all;
}

} // namespace

TEST_CASE("guides that say something stay as they are, and so does the sky") {
    auto image = floor_and_sky();
    auto const before = values_of(image);
    auto const empty = fill_empty_guides(image, io::own_sequence());
    CHECK_FALSE((empty.normal || empty.depth || empty.albedo));
    CHECK(values_of(image) == before);
    change(image, "depth", [](int, int, float) { return std::numeric_limits<float>::infinity(); });
    change(image, "normal", [](int, int, float) { return 0.f; });
    auto const sky = values_of(image);
    CHECK_FALSE(fill_empty_guides(image, io::own_sequence()).normal);
    CHECK(values_of(image) == sky);
}

TEST_CASE("normals of 0 become a constant where there is depth") {
    for (int const until : {12, size.width}) { // of all surfaces, and of a part
        auto image = floor_and_sky();
        change(image, "normal", [&](int x, int, float n) { return x < until ? 0.f : n; });
        CHECK(fill_empty_guides(image, io::own_sequence()).normal == (until == size.width));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                CHECK(value(image, "normal.X", x, y) == 0.f);
                CHECK(value(image, "normal.Y", x, y) == (y >= horizon && x >= until ? 1.f : 0.f));
                CHECK(value(image, "normal.Z", x, y) == (y >= horizon && x < until ? 1.f : 0.f));
            }
    }
}

TEST_CASE("normals that a file holds as n * .5 + .5 say nothing at .5") {
    auto names = io::own_sequence();
    for (std::string const plane : {"normal.X", "normal.Y", "normal.Z"})
        names.of_signals[0].channels.sources["normal"].push_back({{plane}, 2.f, -1.f});
    auto image = floor_and_sky();
    change(image, "normal", [](int, int, float) { return .5f; });
    CHECK(fill_empty_guides(image, names).normal);
    CHECK(value(image, "normal.X", 3, 9) == .5f);
    CHECK(value(image, "normal.Z", 3, 9) == 1.f);
    CHECK(value(image, "normal.Z", 3, 2) == .5f);
}

TEST_CASE("a depth of 0 becomes a constant where there is a normal") {
    for (int const until : {12, size.width}) {
        auto image = floor_and_sky();
        change(image, "depth", [&](int x, int, float z) { return x < until ? 0.f : z; });
        auto const before = image;
        CHECK(fill_empty_guides(image, io::own_sequence()).depth == (until == size.width));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                CHECK(value(image, "depth.Z", x, y) == (y >= horizon && x < until ? 1.f : value(before, "depth.Z", x, y)));
    }
}

TEST_CASE("one sentence says what a pass lacks; black albedo is said where no frame has another") {
    auto image = floor_and_sky();
    change(image, "albedo", [](int, int, float) { return 0.f; });
    auto const black = fill_empty_guides(image, io::own_sequence());
    CHECK(black.albedo);
    EmptyPasses passes;
    CHECK(passes.remarks().empty());
    passes.add(black);
    REQUIRE(passes.remarks().size() == 1);
    CHECK(contains(passes.remarks()[0], "albedo is black"));
    passes.add({});
    CHECK(passes.remarks().empty());
    passes.add({.normal = true, .depth = true});
    CHECK(passes.remarks().size() == 2);
}

TEST_CASE("a sequence whose normals are all 0 is denoised as one without them, and a remark says so") {
    Folder const folder;
    auto const write = [&](std::string const& name, auto const& normals) {
        for (int i = 1; i <= 3; ++i) {
            auto image = noisy_image({48, 32}, i);
            for (auto& plane : image.planes)
                if (plane.name.starts_with("normal.")) std::ranges::fill(plane.values, normals(plane.name));
            io::write_exr(folder / numbered(name + ".", i), image);
        }
    };
    write("none", [](auto const& plane) { return plane == "normal.Z" ? 1.f : 0.f; });
    write("empty", [](auto const&) { return 0.f; });
    auto const picture = [&](std::string const& name, std::string const& more) {
        auto const ran = denoise("--in '" + (folder / (name + ".%04d.exr")).string() + "' --json --quiet " + more + output(folder, "out."));
        REQUIRE(ran.code == 0);
        CHECK(contains(nlohmann::json::parse(ran.out)["remarks"].dump(), "normals is 0 on every surface") == (name == "empty"));
        return pass(io::read_exr(folder / numbered("out.", 3)), "");
    };
    for (std::string const more : {"--layers picture ", "--layers picture --quick "})
        CHECK(picture("none", more) == picture("empty", more));
}
