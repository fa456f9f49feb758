#include "files.hpp"

#include <limits>

using namespace quell;
using namespace quell::tests;

TEST_CASE("every type and any name comes back from a file") {
    Folder const folder;
    Extent const size{37, 19};
    io::ExrImage image{.size = size};
    image.planes = {
        plane(
            "R", size, [](int x, int y) { return 0.25f * static_cast<float>(x) + static_cast<float>(y); }, io::SampleType::half),
        plane("some layer.with dots.X", size, [](int x, int y) { return 1.f / static_cast<float>(1 + x + 100 * y); }),
        plane(
            "id", size, [](int x, int y) { return static_cast<float>(x * y + 16776000); }, io::SampleType::uint32),
        plane(std::string(200, 'n'), size, [](int x, int) { return static_cast<float>(x) * -1e30f; })};
    io::write_exr(folder / "all.exr", image);
    auto const back = io::read_exr(folder / "all.exr");
    CHECK(back.size == size);
    CHECK(back.planes.size() == image.planes.size());
    for (auto const& plane : image.planes) {
        CHECK(back[plane.name].type == plane.type);
        CHECK(back[plane.name].values == plane.values);
        CHECK(back[plane.name].exact);
        CHECK_FALSE(back[plane.name].stored.has_value());
    }
}

TEST_CASE("sizes of one pixel, one row and one column come back") {
    Folder const folder;
    for (Extent const size : {Extent{1, 1}, Extent{300, 1}, Extent{1, 300}}) {
        io::ExrImage image{.size = size};
        image.planes = {plane("Z", size, [](int x, int y) { return static_cast<float>(x + y); })};
        io::write_exr(folder / "small.exr", image);
        CHECK(io::read_exr(folder / "small.exr")["Z"].values == image["Z"].values);
    }
}

TEST_CASE("infinities and NaN stay what they are, and what is finite stays finite in half") {
    Folder const folder;
    auto const infinity = std::numeric_limits<float>::infinity();
    io::ExrImage image{.size = {4, 1}};
    for (auto const type : {io::SampleType::half, io::SampleType::float32})
        image.planes.push_back({.name = io::to_string(type), .type = type, .values = {infinity, -infinity, std::nanf(""), 1e6f}});
    io::write_exr(folder / "special.exr", image);
    auto const back = io::read_exr(folder / "special.exr");
    for (auto const& plane : back.planes) {
        CHECK(plane.values[0] == infinity);
        CHECK(plane.values[1] == -infinity);
        CHECK(std::isnan(plane.values[2]));
    }
    CHECK(back["half"].values[3] == 65504.f);
    CHECK(back["float"].values[3] == 1e6f);
}

TEST_CASE("attributes of every type come back") {
    Folder const folder;
    io::ExrImage image{.size = {2, 2}};
    image.planes = {plane("Y", {2, 2}, [](int, int) { return 0.f; })};
    glm::mat4 matrix;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) matrix[c][r] = static_cast<float>(10 * c + r);
    image.attributes = {{"text", std::string("words, and \xc3\xa9")},
                        {"whole", -7},
                        {"number", 0.1f},
                        {"pair", glm::vec2(1.5f, -2.f)},
                        {"quell:view", matrix}};
    io::write_exr(folder / "attributes.exr", image);
    auto const back = io::read_exr(folder / "attributes.exr");
    for (auto const& attribute : image.attributes) {
        INFO(attribute.first);
        REQUIRE(back.attributes.contains(attribute.first));
        CHECK(back.attributes.at(attribute.first) == attribute.second);
    }
    CHECK(back.attribute<float>("whole") == nullptr); // of another type
}

TEST_CASE("a matrix follows OpenEXR's own convention of row vectors") {
    Folder const folder;
    io::ExrImage image{.size = {1, 1}};
    image.planes = {plane("Y", {1, 1}, [](int, int) { return 0.f; })};
    glm::mat4 move(1.f);
    move[3] = {5.f, 6.f, 7.f, 1.f};
    image.attributes["worldToCamera"] = move;
    io::write_exr(folder / "m.exr", image);
    Imf::MultiPartInputFile file((folder / "m.exr").string().c_str());
    auto const& stored = file.header(0).typedAttribute<Imf::M44fAttribute>("worldToCamera").value();
    CHECK(Imath::V3f(0.f, 0.f, 0.f) * stored == Imath::V3f(5.f, 6.f, 7.f));
}
