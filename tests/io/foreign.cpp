#include "foreign.hpp"

using namespace quell;
using namespace quell::tests;

TEST_CASE("a data window anywhere lands at its place in the display window") {
    Folder const folder;
    auto const display = box(-3, 10, 16, 24);
    for (auto const& data :
         {box(-3, 10, 16, 24), box(0, 12, 5, 13), box(-9, 2, 40, 40), box(10, 20, 30, 30), box(-20, 0, -10, 5), box(16, 24, 16, 24)}) {
        INFO(data.min.x, ",", data.min.y, " to ", data.max.x, ",", data.max.y);
        write_scan_lines(folder / "window.exr", display, data, {"Z"});
        auto const image = io::read_exr(folder / "window.exr");
        CHECK(image.size == Extent{20, 15});
        bool right = true;
        for (int y = 0; y < 15; ++y)
            for (int x = 0; x < 20; ++x) {
                bool const inside = data.intersects(Imath::V2i(x - 3, y + 10));
                right = right && image["Z"].values[static_cast<std::size_t>(y * 20 + x)] == (inside ? foreign_value(x - 3, y + 10) : 0.f);
            }
        CHECK(right);
    }
}

TEST_CASE("a small region of a large picture is read") {
    Folder const folder;
    write_scan_lines(folder / "region.exr", box(0, 0, 4095, 2159), box(100, 100, 131, 131), {"R", "G", "B", "Z"});
    auto const image = io::read_exr(folder / "region.exr");
    CHECK(image.size == Extent{4096, 2160});
    CHECK(image["Z"].values[std::size_t(4096) * 100 + 131] == foreign_value(131, 100));
}

TEST_CASE("outside of the data window there is no surface, and no light") {
    Folder const folder;
    write_scan_lines(folder / "window.exr", box(0, 0, 9, 9), box(2, 2, 7, 7), {"R", "G", "B", "depth.Z"});
    Frame<Channels<Radiance, Depth>> frame({10, 10});
    io::load(frame, io::read_exr(folder / "window.exr"));
    CHECK(frame[depth].get(0, 0) == std::numeric_limits<float>::infinity());
    CHECK(frame[depth].get(8, 5) == std::numeric_limits<float>::infinity());
    CHECK(frame[depth].get(2, 7) == foreign_value(2, 7));
    CHECK(frame[radiance].get(0, 0) == glm::vec3(0.f));
}

TEST_CASE("tiles are read as rows") {
    Folder const folder;
    auto const window = box(0, 0, 40, 20);
    write_tiles(folder / "tiles.exr", window, {"Z"});
    CHECK(io::read_exr(folder / "tiles.exr")["Z"].values == foreign_values(window));
}

TEST_CASE("channels of several parts go by their names, and by their part's where two are alike") {
    Folder const folder;
    write_parts(
        folder / "parts.exr", box(0, 0, 9, 5),
        {{"right", box(0, 0, 9, 5), {"R", "G", "B"}}, {"left", box(4, 0, 9, 5), {"R", "G", "B"}}, {"depth", box(0, 0, 9, 5), {"Z"}}});
    io::ExrFile const file(folder / "parts.exr");
    CHECK(file.channels.size() == 7);
    auto const image = file.read();
    CHECK(image["R"].values[0] == foreign_value(0, 0));
    CHECK(image["R"].values[1] == foreign_value(1, 0));
    CHECK(image["left.R"].values[1] == 0.f);
    CHECK(image["left.R"].values[4] == foreign_value(4, 0));
    CHECK(image["Z"].values[13] == foreign_value(3, 1));
    REQUIRE(file.find("depth.Z") != nullptr);
    CHECK(file.find("depth.Z")->name == "Z");
    CHECK(file.find("right.R") == file.find("R"));
}

TEST_CASE("only the channels that are asked for are read, each once") {
    Folder const folder;
    write_scan_lines(folder / "many.exr", box(0, 0, 9, 5), box(0, 0, 9, 5), {"A", "B", "C", "D"});
    std::vector<std::string> const wanted{"C", "A", "C"};
    auto const image = io::ExrFile(folder / "many.exr").read(wanted);
    CHECK(image.planes.size() == 2);
    CHECK(image.find("B") == nullptr);
    CHECK(image.find("C") != nullptr);
}

TEST_CASE("numbers without sign that a float can't hold are told from those that it can") {
    Folder const folder;
    std::vector<std::uint32_t> const ids{1u, 16777217u};
    Imf::Header header(2, 1);
    header.channels().insert("instance.ID", Imf::Channel(Imf::UINT));
    {
        Imf::OutputFile file((folder / "ids.exr").string().c_str(), header);
        Imf::FrameBuffer buffer;
        buffer.insert("instance.ID", Imf::Slice::Make(Imf::UINT, ids.data(), header.dataWindow()));
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    auto const image = io::read_exr(folder / "ids.exr");
    CHECK_FALSE(image["instance.ID"].exact);
    Frame<Channels<Instance>> frame({2, 1});
    check_error([&] { io::load(frame, image); }, {"ids.exr channel 'instance.ID'", "not exact in float", "2^24"});
}

TEST_CASE("the same image from one part and from several" * doctest::test_suite("shared data")) {
    auto const folder = shared("data/scenes/exr");
    if (folder.empty()) return;
    auto const one = io::read_exr(folder / "singlepart.0001.exr"), several = io::read_exr(folder / "multipart.0001.exr");
    CHECK(one.size == several.size);
    for (auto const* const name : {"R", "G", "B", "A", "disparityL.x", "disparityR.y"}) CHECK(one[name].values == several[name].values);
    CHECK(one["left.R"].values == several["rgba_left.R"].values);
    CHECK(one["whitebarmask.right.mask"].values == several["whitebarmask_right.whitebarmask.mask"].values);
}
