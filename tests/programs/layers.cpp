#include "../io/whole_file.hpp"
#include "programs.hpp"

#include <cmath>

using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent usual_size{48, 32};

/// A frame's numbers as the channels of a file whose data window begins at `corner`.
std::vector<WholeChannel> channels_of(io::ExrImage const& image, Imath::V2i corner) {
    std::vector<WholeChannel> channels;
    for (auto const& each : image.planes)
        channels.push_back({each.name, io::detail::pixel_type(each.type), [=, size = image.size](int x, int y) {
                                return each.values[static_cast<std::size_t>((y - corner.y) * size.width + x - corner.x)];
                            }});
    return channels;
}
/// What else renderers write: alpha, numbers of objects, a layer of half numbers, Cryptomatte.
std::vector<WholeChannel> others() {
    auto const f = [](float scale) {
        return [=](int x, int y) { return scale * static_cast<float>(((x + 99) * 7919 + (y + 99) * 104729) % 1000); };
    };
    return {{"A", Imf::HALF, f(0.001f)},
            {"instance.ID", Imf::UINT, f(4000000.f)},
            {"specular.R", Imf::HALF, f(0.01f)},
            {"crypto00.R", Imf::FLOAT, f(1e-20f)},
            {"crypto00.A", Imf::FLOAT, f(0.00123f)}};
}
Imath::Box2i window_at(Imath::V2i corner, Extent size) { return {corner, {corner.x + size.width - 1, corner.y + size.height - 1}}; }

/// Frames 1 and 2 of a sequence, each in one part.
void write_frames(Folder const& folder, Imath::Box2i const& display, Imath::V2i corner, bool tiled, Imf::Compression compression,
                  Extent size = usual_size) {
    for (int i = 1; i <= 2; ++i) {
        auto channels = channels_of(noisy_image(size, i), corner);
        for (auto const& other : others()) channels.push_back(other);
        write_whole(folder / numbered("frame.", i), display, {{"", window_at(corner, size), channels, tiled, compression}});
    }
}
/// Sum of squared differences between neighbours: what noise makes large.
double unevenness(io::Plane const& plane, Extent size) {
    double sum = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 1; x < size.width; ++x) {
            auto const i = static_cast<std::size_t>(y * size.width + x);
            sum += std::pow(static_cast<double>(plane.values[i] - plane.values[i - 1]), 2);
        }
    return sum;
}
std::vector<std::string> const picture_only{"0 B half", "0 G half", "0 R half"};
std::vector<std::string> const picture_and_alpha{"0 A half", "0 B half", "0 G half", "0 R half"};

Ran denoised(Folder const& folder, std::string const& more = "", std::string const& name = "out.") {
    auto const ran = denoise(input(folder) + output(folder, name) + "--quiet --preset general " + more);
    INFO(ran.err);
    CHECK(ran.code == 0);
    return ran;
}

} // namespace

TEST_CASE("all of a file comes out again, with the picture denoised, whatever its windows, tiles and compression") {
    for (auto const& each : all_compressions())
        for (bool const tiled : {false, true}) {
            auto const name = each.first;
            auto const compression = each.second;
            INFO(name, tiled);
            Folder const folder;
            write_frames(folder, box(10, 20, 49, 45), {5, 17}, tiled, compression);
            denoised(folder);
            auto const before = whole_of(folder / "frame.0002.exr"), after = whole_of(folder / "out.0002.exr");
            bool const lossy = name.starts_with("b44") || name.starts_with("dwa");
            for (auto const& channel : different(before, after)) // light that is packed with loss is so again
                CHECK((std::ranges::count(picture_and_alpha, channel) == 1 || (lossy && channel == "0 specular.R half")));
            CHECK(before.channels.at("0 R half") != after.channels.at("0 R half"));
            if (!lossy) CHECK(before.attributes == after.attributes);
        }
}

TEST_CASE("files of several parts keep them, and what lies in other parts than the picture to the last bit") {
    Folder const folder;
    auto const display = window_at({0, 0}, usual_size);
    for (int i = 1; i <= 2; ++i) {
        auto of_frame = channels_of(noisy_image(usual_size, i), {0, 0});
        std::vector<WholeChannel> rgb;
        std::copy_n(of_frame.begin(), 3, std::back_inserter(rgb));
        of_frame.erase(of_frame.begin(), of_frame.begin() + 3);
        write_whole(folder / numbered("frame.", i), display,
                    {{"rgba", display, rgb, false, Imf::DWAA_COMPRESSION},
                     {"guides", display, of_frame, true, Imf::PIZ_COMPRESSION},
                     {"ids", box(-4, -4, 20, 20), others(), false, Imf::ZIPS_COMPRESSION}});
    }
    denoised(folder);
    auto const before = whole_of(folder / "frame.0002.exr"), after = whole_of(folder / "out.0002.exr");
    CHECK(after.part_names == std::vector<std::string>{"rgba", "guides", "ids"});
    CHECK(different(before, after) == picture_only);
    CHECK(before.attributes == after.attributes);
    denoised(folder, "--layers ids,picture", "few.");
    CHECK(whole_of(folder / "few.0002.exr").part_names == std::vector<std::string>{"rgba", "ids"});
}

TEST_CASE("what lies outside of the display window is denoised as if it lay inside") {
    Folder const whole, part;
    write_frames(whole, box(0, 0, 59, 43), {0, 0}, false, Imf::ZIP_COMPRESSION, {60, 44});
    write_frames(part, box(106, 54, 150, 80), {100, 50}, true, Imf::ZIP_COMPRESSION, {60, 44});
    denoised(whole), denoised(part);
    auto const expected = whole_of(whole / "out.0002.exr"), found = whole_of(part / "out.0002.exr");
    for (auto const& channel : picture_only) CHECK(expected.channels.at(channel) == found.channels.at(channel));
    CHECK(unevenness(io::read_exr(whole / "out.0002.exr")["R"], {60, 44}) <
          0.3 * unevenness(io::read_exr(whole / "frame.0002.exr")["R"], {60, 44}));
    // A region that was rendered alone keeps its window; nothing is added around it.
    Folder const region;
    write_frames(region, box(0, 0, 99, 79), {20, 30}, false, Imf::ZIP_COMPRESSION);
    denoised(region);
    CHECK(different(whole_of(region / "frame.0002.exr"), whole_of(region / "out.0002.exr")) == picture_and_alpha);
}

TEST_CASE("motion in parts of the image is of the display window") {
    Folder const whole, part;
    auto const write = [](Folder const& folder, Imath::Box2i const& display) {
        for (int i = 1; i <= 2; ++i) {
            auto image = noisy_image(usual_size, i);
            for (auto& each : image.planes)
                if (each.name == "motion.X") // 1 pixel, in parts of the display window
                    for (auto& value : each.values) value /= static_cast<float>(display.max.x - display.min.x + 1);
            write_whole(folder / numbered("frame.", i), display, {{"", window_at({0, 0}, usual_size), channels_of(image, {0, 0})}});
        }
        write_bytes(folder / "map.json", R"({"motion": {"unit": "uv"}})");
        denoised(folder, "--map '" + (folder / "map.json").string() + "'");
    };
    write(whole, box(0, 0, 47, 31));
    write(part, box(8, 4, 39, 19));
    auto const expected = io::read_exr(whole / "out.0002.exr"), found = io::read_exr(part / "out.0002.exr");
    double worst = 0;
    for (int y = 4; y < 20; ++y)
        for (int x = 8; x < 40; ++x)
            worst = std::max(worst, std::abs(static_cast<double>(expected["R"].values[static_cast<std::size_t>(y * 48 + x)]) -
                                             static_cast<double>(found["R"].values[static_cast<std::size_t>((y - 4) * 32 + x - 8)])));
    CHECK(worst < 1e-3);
}

TEST_CASE("cameras are of the display window") {
    Folder const whole, part;
    REQUIRE(
        trace("--scene room --size 48x32 --frames 2 --quiet --effects composite,shadow,glossy,indirect --out '" + whole.path.string() + "'")
            .code == 0);
    for (int i = 0; i < 2; ++i) { // the same pixels around a display window of a quarter of them, whose camera sees less
        auto const image = io::read_exr(whole / numbered("frame.", i));
        glm::mat4 crop(1.f);
        crop[0][0] = 2.f, crop[3][0] = 48.f / 24.f - 1.f - 2.f * 12.f / 24.f + 0.f;
        crop[1][1] = 2.f, crop[3][1] = -(32.f / 16.f - 1.f - 2.f * 6.f / 16.f);
        Imf::Header header(box(12, 6, 35, 21), window_at({0, 0}, usual_size));
        std::vector<std::vector<std::uint32_t>> words;
        io::ExrImage small{.size = image.size, .planes = image.planes, .attributes = image.attributes};
        for (auto const* const name : {"quell:projection", "quell:projection_previous"})
            small.attributes[name] = crop * std::get<glm::mat4>(image.attributes.at(name));
        for (auto const& [name, value] : small.attributes) io::detail::insert_attribute(header, name, value);
        Imf::FrameBuffer buffer;
        std::deque<io::detail::Outgoing> numbers;
        for (auto const& plane : small.planes) {
            header.channels().insert(plane.name, Imf::Channel(io::detail::pixel_type(plane.type)));
            buffer.insert(plane.name, Imf::Slice::Make(io::detail::pixel_type(plane.type), numbers.emplace_back("a test", plane).data,
                                                       header.dataWindow()));
        }
        Imf::OutputFile file((part / numbered("frame.", i)).string().c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(32);
    }
    for (auto const* const folder : {&whole, &part}) {
        auto const ran = denoise(input(*folder) + output(*folder) + "--quiet --preset trmv --layers picture");
        INFO(ran.err);
        REQUIRE(ran.code == 0);
    }
    auto const expected = io::read_exr(whole / "out.0001.exr"), found = io::read_exr(part / "out.0001.exr");
    int different_pixels = 0;
    for (int y = 6; y < 22; ++y)
        for (int x = 12; x < 36; ++x)
            if (std::abs(expected["G"].values[static_cast<std::size_t>(y * 48 + x)] -
                         found["G"].values[static_cast<std::size_t>((y - 6) * 24 + x - 12)]) > 1e-2f)
                ++different_pixels;
    CHECK(different_pixels <= 4); // rounding may turn a test for what is visible
}

namespace {
/// The sum of layers as floats, in this order, and how far it is from the picture.
float off_by(io::ExrImage const& image, std::vector<std::string> const& layers, std::string const& picture) {
    float worst = 0;
    for (std::string const letter : {"R", "G", "B"})
        for (std::size_t i = 0; i < image.pixels(); ++i) {
            float sum = 0;
            for (auto const& layer : layers) sum += image[layer + "." + letter].values[i];
            worst = std::max(worst, std::abs(sum - image[picture.empty() ? letter : picture + "." + letter].values[i]));
        }
    return worst;
}
} // namespace

TEST_CASE("denoised signals are layers that add up to the picture exactly, which takes the place that the map says") {
    Folder const folder;
    for (int i = 1; i <= 2; ++i) {
        auto image = noisy_image(usual_size, i);
        std::mt19937 random(static_cast<unsigned>(i));
        std::uniform_real_distribution<float> number(0.f, 1.f);
        for (std::string const layer : {"diffuse", "reflection", "glow", "beauty"})
            for (std::string const letter : {".R", ".G", ".B"})
                image.planes.push_back(plane(
                    layer + letter, usual_size, [&](int x, int) { return x % 5 == 0 ? 100.f * number(random) : number(random); },
                    io::SampleType::half));
        io::write_exr(folder / numbered("frame.", i), image);
    }
    write_bytes(folder / "map.json", R"({"signals": [{"name": "diffuse", "irradiance": "diffuse", "albedo": "albedo"},
                                                     {"radiance": "reflection", "albedo": 1}],
                                         "added": "glow", "picture": "beauty"})");
    auto const map = "--map '" + (folder / "map.json").string() + "' ";
    denoised(folder, map);
    auto const out = io::read_exr(folder / "out.0002.exr");
    // Some pixels of this beauty are far less than the glow that is added, whose rounding remains.
    CHECK(off_by(out, {"denoised_diffuse", "denoised_signals_1", "denoised_rest", "glow"}, "beauty") <= 100.f * 0x1p-24f);
    CHECK(out["beauty.R"].type == io::SampleType::half);
    CHECK(different(whole_of(folder / "frame.0002.exr"), whole_of(folder / "out.0002.exr")).size() == 3 + 9);
    // Without a place in the map: R, G, B.
    write_bytes(folder / "map.json",
                R"({"signals": [{"irradiance": "diffuse", "albedo": "albedo"}, {"radiance": "reflection", "albedo": 1}]})");
    denoised(folder, map, "rgb.");
    auto const rgb = io::read_exr(folder / "rgb.0002.exr");
    CHECK(off_by(rgb, {"denoised_signals_0", "denoised_signals_1"}, "") == 0.f);
    CHECK(rgb["beauty.G"].values == io::read_exr(folder / "frame.0002.exr")["beauty.G"].values);
    write_bytes(folder / "map.json", R"({"signals": [{"name": "a", "radiance": "diffuse"}, {"name": "a", "radiance": "reflection"}]})");
    check_refused(denoise(input(folder) + output(folder, "no.") + map + "--quiet"), {"map.json", "two signals have the name 'a'"});
    write_bytes(folder / "map.json", R"({"picture": 3})");
    check_refused(denoise(input(folder) + output(folder, "no.") + map + "--quiet"), {"map.json", "picture is 3", "name of a layer"});
}

TEST_CASE("the only signal of a map is the picture, and keeps its names and its format") {
    Folder const folder;
    for (int i = 1; i <= 2; ++i) {
        auto image = noisy_image(usual_size, i);
        for (auto& each : image.planes)
            if (each.name.size() == 1) each.name.insert(0, "main."), each.type = io::SampleType::float32;
        io::write_exr(folder / numbered("frame.", i), image);
    }
    write_bytes(folder / "map.json", R"({"signals": [{"radiance": "main"}]})");
    denoised(folder, "--map '" + (folder / "map.json").string() + "'");
    CHECK(different(whole_of(folder / "frame.0002.exr"), whole_of(folder / "out.0002.exr")) ==
          std::vector<std::string>{"0 main.B float", "0 main.G float", "0 main.R float"});
}

TEST_CASE("--layers chooses what is written") {
    Folder const folder;
    write_frames(folder, window_at({0, 0}, usual_size), {0, 0}, false, Imf::ZIP_COMPRESSION);
    auto const names = [&](std::string const& layers) {
        denoised(folder, "--layers " + layers);
        std::string list;
        for (auto const& channel : io::ExrFile(folder / "out.0002.exr").channels) list += channel.name + " ";
        return list;
    };
    CHECK(names("picture") == "A B G R ");
    CHECK(names("picture,depth,crypto00") == "A B G R crypto00.A crypto00.R depth.Z ");
    CHECK(names("normal") == "normal.X normal.Y normal.Z ");
    CHECK(names("A") == "A ");
    CHECK(names("all,depth").size() == names("all").size());
    std::filesystem::remove(folder / "out.0001.exr"), std::filesystem::remove(folder / "out.0002.exr");
    auto const files = folder.files();
    check_refused(denoise(input(folder) + output(folder) + "--quiet --layers picture,shadow"),
                  {"--layers", "no layer 'shadow' in", "frame.0001.exr",
                   "choose any of: all, picture, signals, guides, A, B, G, R, albedo, crypto00"});
    check_refused(denoise(input(folder) + output(folder) + "--quiet --preset svgf --layers signals"),
                  {"--layers", "but one signal in", "frame.0001.exr", "write picture"});
    check_refused(denoise(input(folder) + "--diagnose --quiet --layers picture"), {"--layers", "--out is missing"});
    CHECK(folder.files() == files);
}

TEST_CASE("Blender's files keep all passes, Combined is denoised, and its layers add up" * doctest::test_suite("shared data")) {
    auto const from = shared("data/sequences/cycles_occlusion");
    if (from.empty()) return;
    Folder const folder;
    auto const ran = denoise("--in '" + (from / "frame_%04d.exr").string() + "' --frames 40-41 --warmup 0 --quiet " + output(folder));
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    auto const before = whole_of(from / "frame_0040.exr"), after = whole_of(folder / "out.0040.exr");
    auto const changed = different(before, after);
    CHECK(changed.size() == 3 + 9);
    for (auto const& name : changed) CHECK((contains(name, " ViewLayer.Combined.") || contains(name, " ViewLayer.denoised_")));
    CHECK_FALSE(std::ranges::count(changed, "0 ViewLayer.Combined.A half"));
    CHECK(before.attributes == after.attributes);
    CHECK(off_by(io::read_exr(folder / "out.0040.exr"),
                 {"ViewLayer.denoised_diffuse", "ViewLayer.denoised_glossy", "ViewLayer.denoised_rest", "ViewLayer.Emit", "ViewLayer.Env"},
                 "ViewLayer.Combined") == 0.f);
    CHECK(denoise("--in '" + (from / "frame_%04d.exr").string() + "' --frames 40 --quiet --layers picture,signals,Depth " + output(folder))
              .code == 0);
    CHECK(io::ExrFile(folder / "out.0040.exr").channels.size() == 4 + 9 + 1);
}
