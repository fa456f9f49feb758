#include "whole_file.hpp"

#include <quell/io/exr/exr_copy.hpp>

#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>

#include <cmath>

using namespace quell;
using namespace quell::tests;

namespace {

/// Numbers without a pattern that a lossy compression would keep by chance.
float scatter(int x, int y, int seed) {
    auto const u = [](int number) { return static_cast<std::uint32_t>(number); };
    auto const bits = (u(x) * 73856093u ^ u(y) * 19349663u ^ u(seed) * 83492791u) * 2654435761u;
    return static_cast<float>(bits >> 9) / static_cast<float>(1u << 23);
}
std::function<float(int, int)> scattered(int seed, float scale = 1.f) {
    return [=](int x, int y) { return scale * scatter(x, y, seed); };
}

/// Light, alpha, a depth, an id, a Cryptomatte layer, half guides.
std::vector<WholeChannel> usual_channels() {
    return {{"R", Imf::HALF, scattered(1)},           {"G", Imf::HALF, scattered(2)},
            {"B", Imf::HALF, scattered(3)},           {"A", Imf::HALF, scattered(4)},
            {"depth.Z", Imf::FLOAT, scattered(5, 9)}, {"instance.ID", Imf::UINT, scattered(6, 16777216.f)},
            {"crypto00.R", Imf::FLOAT, scattered(7)}, {"crypto00.G", Imf::FLOAT, scattered(8)},
            {"normal.X", Imf::HALF, scattered(9)},    {"diffuse.R", Imf::FLOAT, scattered(10)}};
}

io::NewNumbers constant(std::string channel, float value, Region const& canvas, int part = 0) {
    return {part, std::move(channel), io::SampleType::float32,
            std::vector<float>(static_cast<std::size_t>(io::detail::size_of(canvas).pixels()), value)};
}
/// A copy whose R is 0.25 everywhere, and what was said about it.
std::vector<std::string> copy_with_new_red(std::filesystem::path const& from, std::filesystem::path const& to) {
    io::ExrOriginal const original(from);
    auto const canvas = original.canvas();
    return io::write_copy(to, original, {.canvas = canvas, .numbers = {constant("R", 0.25f, canvas)}});
}

} // namespace

TEST_CASE("a copy has other numbers in one channel, and everything else as it was, by every compression") {
    Folder const folder;
    auto const display = box(10, -5, 41, 18), data = box(7, -9, 50, 12);
    for (auto const& each : all_compressions())
        for (bool const tiled : {false, true}) {
            auto const name = each.first;
            auto const compression = each.second;
            INFO(name, tiled);
            write_whole(folder / "in.exr", display, {{"", data, usual_channels(), tiled, compression}});
            CHECK(copy_with_new_red(folder / "in.exr", folder / "out.exr").size() <= 1);
            auto const before = whole_of(folder / "in.exr"), after = whole_of(folder / "out.exr");
            bool const lossy = name.starts_with("b44") || name.starts_with("dwa");
            if (!lossy) {
                CHECK(different(before, after) == std::vector<std::string>{"0 R half"});
                CHECK(before.attributes == after.attributes);
            }
            for (auto const* const exact :
                 {"0 depth.Z float", "0 instance.ID uint", "0 crypto00.R float", "0 crypto00.G float", "0 normal.X half"})
                CHECK(before.channels.at(exact) == after.channels.at(exact));
            CHECK(before.channels.size() == after.channels.size());
        }
}

TEST_CASE("a lossy compression stays where it keeps all data") {
    Folder const folder;
    auto channels = usual_channels();
    std::erase_if(channels, [](auto const& channel) { return channel.name.starts_with("crypto") || channel.name.starts_with("normal"); });
    for (auto const& each : all_compressions()) {
        auto const name = each.first;
        auto const compression = each.second;
        INFO(name);
        write_whole(folder / "in.exr", box(0, 0, 31, 23), {{"", box(0, 0, 31, 23), channels, false, compression}});
        CHECK(copy_with_new_red(folder / "in.exr", folder / "out.exr").empty());
        CHECK(whole_of(folder / "in.exr").attributes == whole_of(folder / "out.exr").attributes);
    }
}

TEST_CASE("where a lossy compression would change data, the part is packed without loss, and named") {
    Folder const folder;
    write_whole(folder / "in.exr", box(0, 0, 31, 23), {{"", box(0, 0, 31, 23), usual_channels(), false, Imf::DWAA_COMPRESSION}});
    CHECK(copy_with_new_red(folder / "in.exr", folder / "out.exr") == std::vector<std::string>{"0"});
    CHECK(different(whole_of(folder / "in.exr"), whole_of(folder / "out.exr")) == std::vector<std::string>{"0 R half"});
}

TEST_CASE("the y of vectors is data, and that of luminance is not") {
    Folder const folder;
    auto const window = box(0, 0, 31, 23);
    auto const harmed = [&](std::vector<std::string> const& names) {
        std::vector<WholeChannel> channels{{"R", Imf::HALF, scattered(1)}};
        for (auto const& name : names) channels.push_back({name, Imf::FLOAT, scattered(static_cast<int>(channels.size()) + 1, 9)});
        write_whole(folder / "in.exr", window, {{"", window, channels, false, Imf::DWAA_COMPRESSION}});
        auto const packed = copy_with_new_red(folder / "in.exr", folder / "out.exr");
        auto const changed = different(whole_of(folder / "in.exr"), whole_of(folder / "out.exr"));
        CHECK(packed.empty() == (changed != std::vector<std::string>{"0 R half"}));
        return !packed.empty();
    };
    for (auto const& others : std::vector<std::vector<std::string>>{
             {"Normal.X", "Normal.Y", "Normal.Z"}, {"V.Vector.X", "V.Vector.Y"}, {"Position.Y", "Position.Z"}, {"X", "Y"}, {"a.Y", "a.W"}})
        CHECK(harmed(others));
    for (auto const& others : std::vector<std::vector<std::string>>{{"Y", "RY", "BY"}, {"Y"}, {"fog.Y"}, {"b.Y", "b.A"}}) {
        INFO(others[0]);
        CHECK_FALSE(harmed(others));
    }
    // What is read as a guide is one, whatever it is called.
    io::ExrOriginal const original(folder / "in.exr");
    auto const canvas = original.canvas();
    CHECK(io::write_copy(folder / "out.exr", original,
                         {.canvas = canvas, .numbers = {constant("R", 0.25f, canvas)}, .guides = {{0, "b.Y"}}}) ==
          std::vector<std::string>{"0"});
}

TEST_CASE("light that a compression would make infinite is packed without loss") {
    Folder const folder;
    auto const window = box(0, 0, 31, 23);
    for (auto const type : {Imf::HALF, Imf::FLOAT})
        for (float const brightest : {65504.f, 900.f}) {
            std::vector<WholeChannel> channels;
            for (int c = 0; c < 3; ++c) channels.push_back({std::string(1, "RGB"[c]), type, scattered(c)});
            write_whole(folder / "in.exr", window, {{"", window, channels, false, Imf::DWAA_COMPRESSION}});
            io::ExrOriginal const original(folder / "in.exr");
            io::ExrChanges changes{.canvas = original.canvas()};
            for (auto const& channel : channels) {
                auto& numbers = changes.numbers.emplace_back(io::NewNumbers{0, channel.name, io::SampleType::half, {}}).values;
                for (int i = 0; i < 32 * 24; ++i) numbers.push_back(scatter(i % 32, i / 32, 3) > 0.5f ? brightest : 20000.f);
            }
            auto const named = io::write_copy(folder / "out.exr", original, changes);
            auto const written = io::read_exr(folder / "out.exr");
            CHECK(named.empty() == (brightest < 65504.f));
            for (auto const& plane : written.planes) {
                CHECK(std::ranges::all_of(plane.values, [](float value) { return is_finite(value); }));
                if (!named.empty()) CHECK(plane.values == changes.numbers[0].values);
            }
        }
}

TEST_CASE("parts without new numbers are the same to the last packed byte, and channels and parts can be left out") {
    Folder const folder;
    auto const display = box(0, 0, 31, 23);
    std::vector<WholePart> const parts{{"beauty", display, usual_channels(), false, Imf::PIZ_COMPRESSION},
                                       {"tiles", box(4, 4, 40, 40), usual_channels(), true, Imf::DWAB_COMPRESSION},
                                       {"lossy", box(-3, 2, 9, 9), usual_channels(), false, Imf::B44_COMPRESSION}};
    write_whole(folder / "in.exr", display, parts);
    CHECK(copy_with_new_red(folder / "in.exr", folder / "out.exr").empty());
    auto const before = whole_of(folder / "in.exr"), after = whole_of(folder / "out.exr");
    CHECK(different(before, after) == std::vector<std::string>{"0 R half"});
    CHECK(before.attributes == after.attributes);

    io::ExrOriginal const original(folder / "in.exr");
    auto const canvas = original.canvas();
    // What was read of it before makes no difference.
    CHECK(original.is_whole());
    CHECK(original.read(std::vector<std::string>{"tiles.R", "lossy.G"}, canvas).planes.size() == 2);
    io::write_copy(folder / "again.exr", original, {.canvas = canvas, .numbers = {constant("R", 0.25f, canvas)}});
    CHECK(bytes_of(folder / "again.exr") == bytes_of(folder / "out.exr"));
    CHECK(canvas.x0 == -3);
    CHECK(canvas.y1 == 41);
    io::write_copy(folder / "few.exr", original,
                   {.canvas = canvas, .numbers = {constant("new.R", 2.f, canvas, 1)}, .keeps = [](auto const& part, auto const& channel) {
                        return part == "tiles" ? channel == "depth.Z" : part == "lossy";
                    }});
    auto const few = whole_of(folder / "few.exr");
    CHECK(few.part_names == std::vector<std::string>{"tiles", "lossy"});
    CHECK(few.channels.size() == 2 + usual_channels().size());
    CHECK(few.channels.at("0 depth.Z float") == before.channels.at("1 depth.Z float"));
    CHECK(few.channels.at("1 R half") == before.channels.at("2 R half"));
    CHECK(few.channels.contains("0 new.R float"));
    check_error(
        [&] { io::write_copy(folder / "no.exr", original, {.canvas = canvas, .keeps = [](auto const&, auto const&) { return false; }}); },
        {"in.exr", "no channels"});
    CHECK_FALSE(std::filesystem::exists(folder / "no.exr"));
}

TEST_CASE("an original is read with what lies outside of its display window") {
    Folder const folder;
    auto const display = box(100, 50, 131, 73), data = box(90, 60, 140, 80);
    write_whole(folder / "in.exr", display, {{"", data, {{"R", Imf::FLOAT, foreign_value}, {"G", Imf::FLOAT, foreign_value}}}});
    io::ExrOriginal const original(folder / "in.exr");
    auto const canvas = original.canvas();
    CHECK(canvas.x0 == -10);
    CHECK(canvas.y0 == 0);
    CHECK(canvas.x1 == 41);
    CHECK(canvas.y1 == 31);
    auto const image = original.read(std::vector<std::string>{"G", "R", "G"}, canvas);
    CHECK(image.planes.size() == 2);
    CHECK(image.size == Extent{51, 31});
    CHECK(image["R"].values[10 * 51] == foreign_value(90, 60));
    CHECK(image["R"].values[30 * 51 + 50] == foreign_value(140, 80));
    CHECK(image["R"].values[9 * 51 + 5] == 0.f);
    REQUIRE(image["R"].stored);
    CHECK(image["R"].stored->y0 == 10);
    check_error([&] { static_cast<void>(original.read(std::vector<std::string>{"Q"}, canvas)); }, {"in.exr", "no channel 'Q'", "R"});
    // What was read goes back to where it was.
    io::write_copy(folder / "out.exr", original, {.canvas = canvas, .numbers = {{0, "R", io::SampleType::half, image["R"].values}}});
    CHECK(different(whole_of(folder / "in.exr"), whole_of(folder / "out.exr")).empty());
    write_whole(folder / "right.exr", display, {{"", box(110, 60, 140, 80), {{"R", Imf::FLOAT, foreign_value}}}});
    io::ExrOriginal const right(folder / "right.exr");
    auto const values = right.read(std::vector<std::string>{"R"}, right.canvas())["R"].values;
    io::write_copy(folder / "out.exr", right, {.canvas = right.canvas(), .numbers = {{0, "R", io::SampleType::half, values}}});
    CHECK(different(whole_of(folder / "right.exr"), whole_of(folder / "out.exr")).empty());
    check_error(
        [&] {
            io::write_copy(folder / "no.exr", original, {.canvas = {0, 0, 32, 24}, .numbers = {constant("R", 1.f, {0, 0, 32, 24})}});
        },
        {"in.exr", "'R'", "canvas"});
    check_error(
        [&] {
            io::write_copy(folder / "no.exr", original, {.canvas = canvas, .numbers = {{0, "R", io::SampleType::half, {1.f}}}});
        },
        {"in.exr", "'R'", "1 numbers"});
}

TEST_CASE("infinities, NaN with their payloads and uint above 2^24 pass through a copy") {
    Folder const folder;
    auto const odd = [](int x, int y) { return std::bit_cast<float>(0x7f800000u + static_cast<std::uint32_t>(x + 64 * y)); };
    auto const large = [](int x, int y) { return 4294967040.f - static_cast<float>(256 * (x + y)); };
    write_whole(folder / "in.exr", box(0, 0, 31, 23),
                {{"", box(0, 0, 31, 23), {{"R", Imf::HALF, scattered(1)}, {"Z", Imf::FLOAT, odd}, {"ID", Imf::UINT, large}}}});
    copy_with_new_red(folder / "in.exr", folder / "out.exr");
    CHECK(different(whole_of(folder / "in.exr"), whole_of(folder / "out.exr")) == std::vector<std::string>{"0 R half"});
}

TEST_CASE("deep parts are copied as they are") {
    Folder const folder;
    auto const window = box(0, 0, 7, 5);
    std::vector<Imf::Header> headers(2, Imf::Header(window, window));
    headers[0].setName("flat"), headers[0].setType(Imf::SCANLINEIMAGE), headers[0].channels().insert("R", Imf::Channel(Imf::HALF));
    headers[1].setName("deep"), headers[1].setType(Imf::DEEPSCANLINE), headers[1].channels().insert("Z", Imf::Channel(Imf::FLOAT));
    headers[1].compression() = Imf::ZIPS_COMPRESSION;
    std::vector<unsigned> counts(48, 1);
    std::vector<float> depths(48, 3.5f);
    std::vector<float*> samples;
    for (auto& z : depths) samples.push_back(&z);
    {
        Imf::MultiPartOutputFile file((folder / "in.exr").string().c_str(), headers.data(), 2);
        Imf::OutputPart first(file, 0);
        std::vector<std::uint16_t> const halves(48, 0x3c00);
        Imf::FrameBuffer of_halves;
        of_halves.insert("R", Imf::Slice::Make(Imf::HALF, halves.data(), window));
        first.setFrameBuffer(of_halves);
        first.writePixels(6);
        Imf::DeepFrameBuffer deep;
        deep.insertSampleCountSlice(Imf::Slice::Make(Imf::UINT, counts.data(), window));
        deep.insert("Z",
                    Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), sizeof(float*), 8 * sizeof(float*), sizeof(float)));
        Imf::DeepScanLineOutputPart second(file, 1);
        second.setFrameBuffer(deep);
        second.writePixels(6);
    }
    copy_with_new_red(folder / "in.exr", folder / "out.exr");
    Imf::MultiPartInputFile copy((folder / "out.exr").string().c_str());
    REQUIRE(copy.parts() == 2);
    Imf::DeepScanLineInputPart part(copy, 1);
    std::vector<unsigned> read_counts(48, 0);
    std::vector<float> read_depths(48, 0.f);
    std::vector<float*> places;
    for (auto& z : read_depths) places.push_back(&z);
    Imf::DeepFrameBuffer deep;
    deep.insertSampleCountSlice(Imf::Slice::Make(Imf::UINT, read_counts.data(), window));
    deep.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(places.data()), sizeof(float*), 8 * sizeof(float*), sizeof(float)));
    part.setFrameBuffer(deep);
    part.readPixelSampleCounts(0, 5);
    part.readPixels(0, 5);
    CHECK(read_counts == counts);
    CHECK(read_depths == depths);
}

TEST_CASE("mip maps with new numbers are refused, and copied otherwise") {
    Folder const folder;
    auto const window = box(0, 0, 31, 23);
    Imf::Header header(window, window);
    header.setTileDescription({16, 16, Imf::MIPMAP_LEVELS});
    header.setType(Imf::TILEDIMAGE);
    header.channels().insert("R", Imf::Channel(Imf::FLOAT));
    {
        std::vector<float> const values(32 * 24, 0.5f);
        Imf::TiledOutputFile file((folder / "in.exr").string().c_str(), header);
        for (int level = 0; level < file.numLevels(); ++level) {
            Imf::FrameBuffer buffer;
            buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, values.data(), file.dataWindowForLevel(level)));
            file.setFrameBuffer(buffer);
            file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
        }
    }
    check_error([&] { copy_with_new_red(folder / "in.exr", folder / "out.exr"); }, {"in.exr", "several levels", "one level"});
    io::ExrOriginal const original(folder / "in.exr");
    io::write_copy(folder / "same.exr", original, {.canvas = original.canvas()});
    CHECK(bytes_of(folder / "same.exr") == bytes_of(folder / "in.exr"));
}

TEST_CASE("a file that was cut off isn't whole, though its header is") {
    Folder const folder;
    for (bool const tiled : {false, true})
        for (int const parts : {1, 2}) {
            std::vector<WholePart> list{{"a", box(0, 0, 63, 63), usual_channels(), tiled},
                                        {"b", box(9, 9, 40, 40), usual_channels(), tiled}};
            list.resize(static_cast<std::size_t>(parts));
            write_whole(folder / "in.exr", box(0, 0, 63, 63), list);
            CHECK(io::ExrOriginal(folder / "in.exr").is_whole());
            auto const bytes = bytes_of(folder / "in.exr");
            for (auto const cut : {bytes.size() - 1, bytes.size() * 3 / 4, bytes.size() / 2}) {
                write_bytes(folder / "cut.exr", bytes.substr(0, cut));
                CHECK_FALSE(io::ExrOriginal(folder / "cut.exr").is_whole());
            }
        }
}
