#include "../io/whole_file.hpp"
#include "../jitter.hpp"
#include "programs.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace quell;
using namespace quell::tests;

namespace {

/// A frame of a picture of discs that stand still, without noise. Each pixel has one sample.
io::ExrImage discs(Extent size, glm::vec2 jitter, int samples_across = 1) {
    DenoiseFrame frame(size);
    frame.camera.jitter = jitter;
    auto const n = static_cast<float>(samples_across);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float sum = 0.f;
            for (int j = 0; j < samples_across; ++j)
                for (int i = 0; i < samples_across; ++i) {
                    auto const within = (glm::vec2(i, j) + .5f) / n;
                    auto const at = glm::fract((glm::vec2(x, y) + within + jitter) / static_cast<float>(size.width) * 4.f) - .5f;
                    sum += glm::dot(at, at) < .1f ? .8f : .1f;
                }
            frame[albedo].set(x, y, glm::vec3(1.f));
            frame[radiance].set(x, y, glm::vec3(sum / (n * n)));
            frame[normal].set(x, y, {0.f, 0.f, 1.f});
            frame[depth].set(x, y, 5.f);
            frame[motion].set(x, y, {0.f, 0.f});
        }
    return io::image_of(frame);
}

constexpr Extent size{32, 24}, twice{64, 48};

/// Frames 1 to `count`, each at another place, and what they show at twice the size.
void write_discs(Folder const& folder, int count, bool says_jitter = true) {
    for (int i = 1; i <= count; ++i) {
        auto image = discs(size, jitter_of(i));
        if (!says_jitter) std::erase_if(image.attributes, [](auto const& each) { return each.first.starts_with("quell:jitter"); });
        io::write_exr(folder / numbered("frame.", i), image);
        io::write_exr(folder / numbered("ref.", i), discs(twice, glm::vec2(0.f), 8));
    }
}
/// The pixels of noisy_image(), all of one colour.
io::ExrImage constant(int number, glm::vec2 jitter) {
    auto image = noisy_image(size, number);
    for (auto& plane : image.planes)
        if (plane.name == "R" || plane.name == "G" || plane.name == "B")
            plane.values.assign(image.pixels(), plane.name == "R" ? .25f : plane.name == "G" ? .5f : 2.f);
    image.planes.push_back({.name = "A", .type = io::SampleType::half, .values = std::vector<float>(image.pixels(), .5f)});
    image.attributes["quell:jitter"] = jitter;
    return image;
}
nlohmann::json summary_of(Ran const& ran) {
    INFO(ran.err);
    CHECK(ran.code == 0);
    return nlohmann::json::parse(ran.out);
}

} // namespace

TEST_CASE("--upsample refuses ratios that it has not, and options for more than the picture") {
    Folder const folder;
    write_sequence(folder, 1, 2);
    auto const both = input(folder) + output(folder);
    for (std::string const ratio : {"0.5", "4.01", "-2", "nan", "inf"})
        check_refused(denoise(both + "--upsample=" + ratio), {"--upsample", "1 to 4"});
    check_refused(denoise(both + "--upsample two"), {"--upsample", "two"});
    check_refused(denoise(both + "--upsample 2 --signal radiance"), {"--upsample", "--signal"});
    check_refused(denoise(both + "--upsample 2 --layers picture"), {"--upsample", "--layers"});
    check_refused(denoise(both + "--upsample 2 --preset general --debug-view clamp"), {"--upsample", "--debug-view"});
    CHECK(folder.files() == 2);
}

TEST_CASE("--upsample: a constant picture stays constant, at the size that was asked for, and so does its alpha") {
    for (bool const jittered : {true, false}) {
        Folder const folder;
        for (int i = 1; i <= 3; ++i) io::write_exr(folder / numbered("frame.", i), constant(i, jittered ? jitter_of(i) : glm::vec2(0.f)));
        struct Case {
            std::string ratio;
            Extent expected;
        };
        for (auto const& [its_ratio, expected] : {Case{"1", size}, {"1.5", {48, 36}}, {"1.7", {54, 41}}, {"2", twice}, {"4", {128, 96}}}) {
            auto const ratio = its_ratio; // clang++ 14 captures no part of a binding
            CAPTURE(jittered);
            CAPTURE(ratio);
            auto const json = summary_of(denoise(input(folder) + output(folder) + "--preset none --quiet --json --upsample " + ratio));
            CHECK(json["size"] == nlohmann::json{expected.width, expected.height});
            CHECK(json["upsampled_by"] == (jittered ? "resolve" : "bicubic"));
            for (int i = 1; i <= 3; ++i) {
                auto const image = io::read_exr(folder / numbered("out.", i));
                CHECK(image.size == expected);
                CHECK(image.planes.size() == 4); // nothing else is of this size
                for (auto const& [name, value] : {std::pair{"R", .25f}, {"G", .5f}, {"B", 2.f}, {"A", .5f}})
                    CHECK(std::ranges::all_of(image[name].values, [v = value](float a) { return std::abs(a - v) <= v * 1e-3f; }));
                CHECK(*image.attribute<glm::vec2>("quell:jitter") == glm::vec2(0.f));
                CHECK(image.attribute<glm::mat4>("quell:projection"));
            }
        }
    }
}

TEST_CASE("--upsample puts jittered frames together, with less error than each enlarged by itself") {
    Folder const known, unknown;
    write_discs(known, 9), write_discs(unknown, 9, false);
    auto const error = [](Folder const& folder, std::string const& more = "") {
        auto const json = summary_of(denoise(input(folder) + output(folder) + "--preset none --json --upsample 2 " + more +
                                             "--reference '" + (folder / "ref.%04d.exr").string() + "'"));
        return json["scores"].back()["rmse"].get<double>();
    };
    CHECK(error(known) < .75 * error(unknown));
    // At the same size it is anti-aliasing.
    for (int i = 1; i <= 9; ++i) io::write_exr(known / numbered("same.", i), discs(size, glm::vec2(0.f), 8));
    auto const same = [&](std::string const& more) {
        auto const ran = denoise(input(known) + more + "--preset none --reference '" + (known / "same.%04d.exr").string() + "'");
        return score_in(ran.lines().at(9), "rmse");
    };
    CHECK(same("--upsample 1 ") < .75 * same(""));
}

TEST_CASE("--upsample says on stderr why each frame is enlarged by itself") {
    Folder const unknown, none;
    write_discs(unknown, 2, false), write_sequence(none, 1, 2);
    auto const said = [](Folder const& folder) { return denoise(input(folder) + output(folder) + "--preset none --upsample 2").err; };
    CHECK(contains(said(unknown), "bicubically: the files do not say"));
    CHECK(contains(said(none), "bicubically: samples lie at the same place"));
    Folder const known;
    write_discs(known, 2);
    CHECK_FALSE(contains(said(known), "bicubically"));
    // Which frames a chunk has makes no difference.
    auto const json = summary_of(denoise(input(known) + output(known) + "--preset none --json --quiet --upsample 2 --chunk 2/2"));
    CHECK(json["upsampled_by"] == "resolve");
}

TEST_CASE("--upsample stops at a frame that does not say its jitter, where others do") {
    Folder const folder;
    write_discs(folder, 5);
    auto image = discs(size, jitter_of(5));
    image.attributes.erase("quell:jitter");
    io::write_exr(folder / numbered("frame.", 5), image);
    auto const run = [&] { return denoise(input(folder) + output(folder) + "--preset none --quiet --upsample 2"); };
    check_refused(run(), {"frame.0005.exr", "quell:jitter", "--upsample"});
    CHECK(io::read_exr(folder / "out.0004.exr").size == twice);
    image.attributes["quell:jitter"] = glm::vec2(1000.f, 0.f);
    io::write_exr(folder / numbered("frame.", 5), image);
    check_refused(run(), {"frame.0005.exr", "quell:jitter", "1000", "pixels"});
}

TEST_CASE("--upsample compares with references of the output's size alone") {
    Folder const folder;
    write_discs(folder, 2);
    for (int i = 1; i <= 2; ++i) io::write_exr(folder / numbered("few.", i), discs(size, glm::vec2(0.f)));
    auto const ran = denoise(input(folder) + "--preset none --quiet --upsample 2 --reference '" + (folder / "few.%04d.exr").string() + "'");
    check_refused(ran, {"few.0001.exr", "32x24", "64x48"});
}

TEST_CASE("--upsample: a shot in chunks is the shot in one, on any number of threads") {
    Folder const folder;
    write_discs(folder, 20);
    auto const at = input(folder) + "--quiet --preset none --upsample 1.5 ";
    CHECK(denoise(at + output(folder, "whole.")).code == 0);
    CHECK(denoise(at + output(folder, "part.") + "--threads 1 --chunk 2/2").code == 0);
    for (int i = 11; i <= 20; ++i) CHECK(bytes_of(folder / numbered("whole.", i)) == bytes_of(folder / numbered("part.", i)));
}

TEST_CASE("--upsample writes the picture's part alone, with scaled windows, and refuses what lies outside of the display window") {
    Folder const folder;
    auto const image = constant(1, jitter_of(1));
    auto const write = [&](Imath::Box2i const& display, Imath::V2i corner) {
        std::vector<WholeChannel> light, guides;
        for (auto const& each : image.planes)
            (each.name.size() == 1 ? light : guides)
                .push_back({each.name, io::detail::pixel_type(each.type), [&each, corner](int x, int y) {
                                return each.values[static_cast<std::size_t>((y - corner.y) * size.width + x - corner.x)];
                            }});
        Imath::Box2i const window{corner, corner + Imath::V2i(size.width - 1, size.height - 1)};
        write_whole(folder / numbered("frame.", 1), display,
                    {{"rgba", window, light, true, Imf::PIZ_COMPRESSION}, {"guides", window, guides, false, Imf::ZIP_COMPRESSION}});
    };
    auto const run = [&] { return denoise(input(folder) + output(folder) + "--preset none --quiet --upsample 2"); };
    write({{10, 20}, {41, 43}}, {10, 20});
    CHECK(run().code == 0);
    Imf::MultiPartInputFile const file((folder / numbered("out.", 1)).string().c_str());
    CHECK(file.parts() == 1);
    auto const& header = file.header(0);
    CHECK(header.name() == "rgba");
    CHECK(header.type() == Imf::SCANLINEIMAGE);
    CHECK(header.compression() == Imf::PIZ_COMPRESSION);
    CHECK(header.displayWindow() == Imath::Box2i({20, 40}, {83, 87}));
    CHECK(header.dataWindow() == header.displayWindow());
    CHECK(header.pixelAspectRatio() == 1.5f);
    CHECK(header.findTypedAttribute<Imf::StringAttribute>("owner"));
    CHECK_FALSE(header.findTypedAttribute<Imf::StringAttribute>("cryptomatte/f834d0a/name")); // its layers are not there
    write({{12, 20}, {41, 43}}, {10, 20});
    check_refused(run(), {"frame.0001.exr", "outside of its display window", "--upsample"});
}

TEST_CASE("--upsample enlarges each view of a file") {
    Folder const folder;
    Imath::Box2i const window{{0, 0}, {size.width - 1, size.height - 1}};
    std::vector<WholePart> parts;
    for (auto const& [name, scale] : {std::pair{"a", 1.f}, {"b", .25f}}) {
        parts.push_back({name, window, {}});
        for (auto const& each : constant(1, jitter_of(1)).planes)
            parts.back().channels.push_back(
                {each.name, io::detail::pixel_type(each.type), [each, by = each.name.size() == 1 ? scale : 1.f](int x, int y) {
                     return each.values[static_cast<std::size_t>(y * size.width + x)] * by;
                 }});
    }
    write_whole(folder / numbered("frame.", 1), window, parts);
    auto const json = summary_of(denoise(input(folder) + output(folder) + "--preset none --quiet --json --upsample 2"));
    CHECK(json["views"].size() == 2);
    auto const image = io::read_exr(folder / numbered("out.", 1));
    CHECK(image.size == twice);
    CHECK(image.planes.size() == 8);
    for (auto const& [name, value] : {std::pair{"a.R", .25f}, {"a.B", 2.f}, {"b.R", .0625f}, {"b.B", .5f}, {"b.A", .125f}})
        CHECK(std::ranges::all_of(image[name].values, [v = value](float each) { return std::abs(each - v) <= v * 1e-3f; }));
}

TEST_CASE("--plan says how large --upsample makes the frames") {
    Folder const folder;
    write_discs(folder, 1);
    CHECK(contains(denoise("--plan --preset none --upsample 1.5").out, "upsampled behind these passes, 1.5 times\n"));
    CHECK(contains(denoise("--plan --preset none --upsample 2 " + input(folder)).out, "2 times: 64x48 from 32x24\n"));
}
