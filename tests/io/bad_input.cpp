#include "foreign.hpp"

#include <quell/io/exr/exr_original.hpp>

#include <random>

using namespace quell;
using namespace quell::tests;

namespace {
io::ExrImage good_image(Extent size = {40, 30}) {
    io::ExrImage image{.size = size};
    std::mt19937 random(1);
    for (auto const* const name : {"R", "G", "B", "depth.Z"})
        image.planes.push_back(plane(name, size, [&](int, int) { return static_cast<float>(random() % 1000) / 100.f; }));
    return image;
}
} // namespace

TEST_CASE("what isn't there, or isn't an EXR file, is named") {
    Folder const folder;
    auto const read = [&](std::string const& name) { return [&, name] { static_cast<void>(io::read_exr(folder / name)); }; };
    check_error(read("none.exr"), {"none.exr", "there is no such file", "check the path"});
    check_error(read(""), {"it is a folder"});
    write_bytes(folder / "empty.exr", "");
    check_error(read("empty.exr"), {"empty.exr", "it is empty"});
    write_bytes(folder / "text.exr", "this is no picture at all");
    check_error(read("text.exr"), {"text.exr", "isn't an EXR file"});
    write_bytes(folder / "png.exr", "\x89PNG\r\n\x1a\n");
    check_error(read("png.exr"), {"png.exr", "isn't an EXR file"});
}

TEST_CASE("a file cut off anywhere is refused with its name") {
    Folder const folder;
    io::write_exr(folder / "whole.exr", good_image());
    auto const bytes = bytes_of(folder / "whole.exr");
    for (auto const length : {std::size_t(9), std::size_t(100), bytes.size() / 4, bytes.size() / 2, bytes.size() - 1}) {
        INFO(length, " bytes of ", bytes.size());
        write_bytes(folder / "cut.exr", bytes.substr(0, length));
        check_error([&] { static_cast<void>(io::read_exr(folder / "cut.exr")); }, {"cut.exr", "again"});
    }
}

TEST_CASE("damaged files never crash") {
    Folder const folder;
    io::write_exr(folder / "whole.exr", good_image({24, 18}));
    write_parts(folder / "parts.exr", box(0, 0, 19, 9), {{"a", box(0, 0, 19, 9), {"R"}}, {"b", box(3, 3, 9, 9), {"R", "Z"}}});
    write_tiles(folder / "tiles.exr", box(0, 0, 39, 19), {"Z"});
    std::mt19937 random(7);
    int refused = 0, read = 0;
    for (auto const* const name : {"whole.exr", "parts.exr", "tiles.exr"}) {
        auto const bytes = bytes_of(folder / name);
        for (int i = 0; i < 300; ++i) {
            auto damaged = bytes;
            // Most of the damage goes into the header.
            auto const reach = i % 3 == 0 ? damaged.size() : std::min<std::size_t>(damaged.size(), 600);
            for (int k = 0; k < 1 + i % 4; ++k) damaged[8 + random() % (reach - 8)] = static_cast<char>(random());
            write_bytes(folder / "damaged.exr", damaged);
            try {
                auto const image = io::read_exr(folder / "damaged.exr");
                for (auto const& plane : image.planes) CHECK(plane.values.size() == image.pixels());
                ++read;
            } catch (Error const& error) {
                CHECK(contains(error.what(), "damaged.exr"));
                ++refused;
            }
        }
    }
    CHECK(refused > 50);
    CHECK(read > 10);
}

TEST_CASE("a header that claims more than a picture can have is refused before memory is taken") {
    Folder const folder;
    write_scan_lines(folder / "large.exr", box(0, 0, 9, 9), box(0, 0, 9, 9), {"Z"});
    auto bytes = bytes_of(folder / "large.exr");
    auto const display = bytes.find("displayWindow") + std::string("displayWindow\0box2i\0\0\0\0\0", 24).size();
    for (std::size_t i = 8; i < 16; ++i) bytes[display + i] = i % 4 == 3 ? '\x0f' : '\xff'; // the far corner
    write_bytes(folder / "large.exr", bytes);
    check_error([&] { static_cast<void>(io::read_exr(folder / "large.exr")); }, {"large.exr", "window", "2^28"});
}

TEST_CASE("tiles that are larger than any picture are refused before memory is taken") {
    Folder const folder;
    write_tiles(folder / "tiles.exr", box(0, 0, 39, 19), {"Z"});
    auto bytes = bytes_of(folder / "tiles.exr");
    auto const tiles = bytes.find("tiledesc") + std::string("tiledesc\0\0\0\0\0", 13).size();
    for (auto const* const height : {"\xff\xff\xff\x01", "\xff\xff\xff\x7f"}) {
        bytes.replace(tiles + 4, 4, height, 4); // of a tile, behind its width
        write_bytes(folder / "tiles.exr", bytes);
        check_error([&] { static_cast<void>(io::read_exr(folder / "tiles.exr")); }, {"tiles.exr", "again"});
        check_error([&] { static_cast<void>(io::ExrOriginal{folder / "tiles.exr"}.is_whole()); }, {"tiles.exr", "again"});
    }
}

TEST_CASE("what this OpenEXR is too old for is named, and what to save it as") {
    Folder const folder;
    write_parts(folder / "parts.exr", box(0, 0, 19, 9), {{"a", box(0, 0, 19, 9), {"R"}}, {"b", box(3, 3, 9, 9), {"R", "Z"}}});
    auto const bytes = bytes_of(folder / "parts.exr");
    std::string const attribute("compression\0compression\0\1\0\0\0", 28);
    for (auto const place : {bytes.find(attribute), bytes.rfind(attribute)}) { // of either part
        REQUIRE(place != std::string::npos);
        for (int const number : {10, 11, 12, 200}) {
            if (number < Imf::NUM_COMPRESSION_METHODS) continue;
            auto newer = bytes;
            newer[place + attribute.size()] = static_cast<char>(number);
            write_bytes(folder / "newer.exr", newer);
            auto const name = number == 10 ? " (HTJ2K256)" : number == 11 ? " (HTJ2K32)" : "";
            auto const version = std::string("OpenEXR ") + OPENEXR_VERSION_STRING;
            for (auto const& open : std::vector<std::function<void()>>{[&] { io::ExrFile{folder / "newer.exr"}; },
                                                                       [&] { io::ExrOriginal{folder / "newer.exr"}; }})
                check_error(open, {"newer.exr", "compression", std::to_string(number) + name, version.substr(0, version.rfind('.')),
                                   "save it as ZIP"});
        }
    }
    auto newer = bytes;
    newer[4] = 3; // of the format
    write_bytes(folder / "newer.exr", newer);
    check_error([&] { static_cast<void>(io::read_exr(folder / "newer.exr")); }, {"newer.exr", "version 3", "OpenEXR", "ZIP"});
}

TEST_CASE("a missing channel is named together with those that there are") {
    Folder const folder;
    io::write_exr(folder / "a.exr", good_image());
    auto const image = io::read_exr(folder / "a.exr");
    Frame<Channels<Radiance, Normal>> frame(image.size);
    check_error([&] { io::load(frame, image); }, {"a.exr", "no channel 'normal.X'", "channel map", "B, G, R, depth.Z"});
    std::vector<std::string> const wanted{"motion.X"};
    check_error([&] { static_cast<void>(io::ExrFile(folder / "a.exr").read(wanted)); }, {"a.exr", "motion.X", "B, G, R, depth.Z"});
}

TEST_CASE("sizes that differ are named") {
    auto const image = good_image({8, 6});
    Frame<Channels<Radiance>> frame({6, 8});
    check_error([&] { io::load(frame, image); }, {"8x6", "6x8"});
}

TEST_CASE("a channel of a type that it can't have is named") {
    auto image = good_image();
    image.name = "f.exr";
    image.planes[3].type = io::SampleType::uint32;
    Frame<Channels<Depth>> frame(image.size);
    check_error([&] { io::load(frame, image); }, {"f.exr channel 'depth.Z'", "uint", "half or float"});
}

TEST_CASE("sub-sampled channels are refused, others of the file are not") {
    Folder const folder;
    write_sub_sampled(folder / "luma.exr", 16, 8);
    check_error([&] { static_cast<void>(io::read_exr(folder / "luma.exr")); },
                {"luma.exr channel 'RY'", "sub-sampled 2x2", "full resolution"});
    std::vector<std::string> const wanted{"Y"};
    CHECK(io::ExrFile(folder / "luma.exr").read(wanted)["Y"].values.size() == 128);
}

TEST_CASE("what can't be written is refused, and what stood there before stays") {
    Folder const folder;
    auto const path = folder / "a.exr";
    io::write_exr(path, good_image());
    auto const before = bytes_of(path);
    auto const write = [&](auto change) {
        return [&, change] {
            auto image = good_image();
            change(image);
            io::write_exr(path, image);
        };
    };
    check_error(write([](auto& i) { i.planes.clear(); }), {"a.exr", "no channels"});
    check_error(write([](auto& i) { i.planes[1].values.pop_back(); }), {"a.exr channel 'G'", "1199 values", "40x30"});
    check_error(write([](auto& i) { i.planes[1].name = "R"; }), {"a.exr channel 'R'", "taken"});
    check_error(write([](auto& i) { i.size = {0, 5}; }), {"a.exr", "0x5"});
    check_error(write([](auto& i) { i.planes[0].type = io::SampleType::uint32; }), {"a.exr channel 'R'", "whole numbers"});
    CHECK(bytes_of(path) == before);
    CHECK(folder.files() == 1);
    check_error([&] { io::write_exr(folder / "no/such/folder.exr", good_image()); }, {"folder.exr", "can't be written", "folder exists"});
    std::filesystem::create_directory(folder / "taken.exr");
    check_error([&] { io::write_exr(folder / "taken.exr", good_image()); }, {"taken.exr", "can't be written"});
    CHECK(folder.files() == 2);
}
