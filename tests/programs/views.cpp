#include "../io/whole_file.hpp"
#include "../shared_data.hpp"
#include "programs.hpp"

#include <quell/io/file_views.hpp>

#include <nlohmann/json.hpp>

#include <fstream>

// Files with several pictures, each of which is denoised by itself: as if it were alone in the file.
using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent size{32, 20};
constexpr int last_frame = 3;

/// Whether it is the first or another picture: of another time, so that noise and textures differ.
io::ExrImage picture_of(int which, int number) { return noisy_image(size, number + 100 * which); }

/// A frame as Blender's passes: diffuse light alone, and what lights by itself.
io::ExrImage passes_of(int which, int number) {
    auto const own = picture_of(which, number);
    io::ExrImage image{.size = size};
    auto const add = [&](std::string const& name, auto&& value, io::SampleType type = io::SampleType::float32) {
        image.planes.push_back({.name = name, .type = type, .values = {}});
        for (std::size_t i = 0; i < image.pixels(); ++i) image.planes.back().values.push_back(value(i));
    };
    for (std::string const c : {"R", "G", "B"}) {
        auto const &light = own[c].values, &colour = own["albedo." + c].values;
        add(
            "Combined." + c, [&](auto i) { return light[i] + 0.25f; }, io::SampleType::half);
        add("DiffDir." + c, [&](auto i) { return light[i] / colour[i]; });
        add("DiffCol." + c, [&](auto i) { return colour[i]; });
        add("Emit." + c, [&](auto) { return 0.25f; });
    }
    add(
        "Combined.A", [](auto i) { return i % 7 == 0 ? 0.5f : 1.f; }, io::SampleType::half);
    add("Depth.Z", [&](auto i) { return own["depth.Z"].values[i]; });
    add("Vector.X", [&](auto i) { return own["motion.X"].values[i]; });
    add("Vector.Y", [&](auto i) { return -own["motion.Y"].values[i]; });
    add("Vector.Z", [&](auto i) { return -own["motion_next.X"].values[i]; });
    add("Vector.W", [&](auto i) { return own["motion_next.Y"].values[i]; });
    for (std::string const c : {"X", "Y", "Z"}) add("Normal." + c, [&](auto i) { return own["normal." + c].values[i]; });
    return image;
}

using Renames = std::function<std::string(std::string const&)>;
Renames in_layer(std::string const& layer) {
    return [=](std::string const& name) { return layer + "." + name; };
}
Renames of_eye(std::string const& eye) {
    return [=](std::string const& name) { return io::detail::with_eye(name, eye); };
}
std::string as_it_is(std::string const& name) { return name; }

/// A frame's planes as channels of a part.
std::vector<WholeChannel> channels_of(io::ExrImage const& image, Renames const& rename) {
    std::vector<WholeChannel> channels;
    for (auto const& each : image.planes)
        channels.push_back({rename(each.name), io::detail::pixel_type(each.type),
                            [values = each.values](int x, int y) { return values[static_cast<std::size_t>(y * size.width + x)]; }});
    return channels;
}
std::vector<WholeChannel> joined(std::vector<WholeChannel> a, std::vector<WholeChannel> const& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
WholePart part(std::string const& name, std::vector<WholeChannel> const& channels, std::string const& view = {}) {
    return {name, box(0, 0, size.width - 1, size.height - 1), channels, false, Imf::ZIP_COMPRESSION, view};
}

/// Writes a sequence, each frame of these parts.
void write(Folder const& folder, std::function<std::vector<WholePart>(int)> const& parts) {
    for (int i = 0; i <= last_frame; ++i) write_whole(folder / numbered("frame.", i), box(0, 0, size.width - 1, size.height - 1), parts(i));
}
/// One picture alone.
void write_alone(Folder const& folder, std::function<io::ExrImage(int)> const& picture, Renames const& rename = as_it_is) {
    write(folder, [&](int i) { return std::vector{part("", channels_of(picture(i), rename))}; });
}

nlohmann::json run(Folder const& folder, std::string const& options) {
    auto const ran = denoise(input(folder) + output(folder) + "--quiet --json " + options);
    INFO(ran.out, ran.err);
    REQUIRE(ran.code == 0);
    return nlohmann::json::parse(ran.out);
}

/// The channels of a file, without the part's number in front: `part` says which, and `rename` what stands in their place.
std::map<std::string, std::string> channels_in(std::filesystem::path const& path, int of_part = 0) {
    std::map<std::string, std::string> channels;
    for (auto const& [name, bytes] : whole_of(path).channels)
        if (name.starts_with(std::to_string(of_part) + " ")) channels[name.substr(2)] = bytes;
    return channels;
}
/// The name without its format, renamed.
std::string renamed(std::string const& name, Renames const& rename) {
    auto const space = name.rfind(' ');
    return rename(name.substr(0, space)) + name.substr(space);
}
/// Checks that all channels of the picture that was denoised alone are in the other file, with the same bytes.
void check_as_alone(Folder const& alone, Folder const& together, Renames const& rename, int in_part = 0) {
    for (int i = 2; i <= last_frame; ++i) {
        auto const expected = channels_in(alone / numbered("out.", i)), found = channels_in(together / numbered("out.", i), in_part);
        CHECK(expected != channels_in(alone / numbered("frame.", i)));
        for (auto const& [name, bytes] : expected) {
            INFO(renamed(name, rename), " of frame ", i);
            REQUIRE(found.contains(renamed(name, rename)));
            CHECK(found.at(renamed(name, rename)) == bytes);
        }
    }
}

std::string const options = "--preset general --first 2 --last 3 ";

/// Checks for both pictures, with names of their own in the file, that they come out as alone.
void check_both(Folder const& together, std::function<io::ExrImage(int, int)> const& picture, std::array<Renames, 2> const& rename,
                std::array<int, 2> const& in_part, std::string const& more = "") {
    auto const summary = run(together, options + more);
    REQUIRE(summary.at("views").size() == 2);
    for (int which = 0; which < 2; ++which) {
        Folder const alone;
        write_alone(alone, [&](int i) { return picture(which, i); });
        auto const one = run(alone, options + more);
        CHECK_FALSE(one.contains("views"));
        auto const index = static_cast<std::size_t>(which);
        check_as_alone(alone, together, rename[index], in_part[index]);
    }
}
std::size_t mentions(nlohmann::json const& summary, std::string const& word) {
    std::size_t count = 0;
    for (auto const& line : summary.at("remarks")) count += contains(line.get<std::string>(), word) ? 1 : 0;
    return count;
}
std::vector<WholePart> two_layers(int i, std::string const& first = "FG layer.001", std::string const& second = "FG layer") {
    return {part("", joined(channels_of(passes_of(0, i), in_layer(first)), channels_of(passes_of(1, i), in_layer(second))))};
}

} // namespace

TEST_CASE("each view layer comes out as if it were alone in the file") {
    Folder const folder;
    write(folder, [](int i) { return two_layers(i); });
    std::array<std::string, 2> const layers{"FG layer.001", "FG layer"};
    for (std::string const more : {"", "--extra-frames 0 --keep-alpha", "--signal diffuse", "--layers signals", "--layers picture"}) {
        INFO(more);
        auto const summary = run(folder, options + more);
        REQUIRE(summary.at("views").size() == 2);
        for (int which = 0; which < 2; ++which) {
            auto const name = layers[static_cast<std::size_t>(which)];
            CHECK(summary.at("views")[static_cast<std::size_t>(which)].at("name") == name);
            Folder const alone;
            write_alone(
                alone, [&](int i) { return passes_of(which, i); }, in_layer(name));
            run(alone, options + more);
            check_as_alone(alone, folder, as_it_is);
        }
        auto const format = more == "--signal diffuse" ? "half" : "float";
        auto const signal = std::string("FG layer.001.denoised_diffuse.R ") + format;
        CHECK(channels_in(folder / numbered("out.", 3)).contains(signal) == (more != "--layers picture"));
        CHECK(mentions(summary, "left as") == 0);
    }
}

TEST_CASE("a frame that was denoised before its turn comes out as if its view were alone") {
    Folder const folder;
    write(folder, [](int i) { return two_layers(i); });
    std::string const refined = "--preset final-frame --first 1 --last 3";
    auto const both = run(folder, refined);
    for (int which = 0; which < 2; ++which) {
        Folder const alone;
        write_alone(
            alone, [&](int i) { return passes_of(which, i); }, in_layer(which == 0 ? "FG layer.001" : "FG layer"));
        auto const one = run(alone, refined);
        CHECK(one.at("bytes_per_pixel").get<double>() < both.at("bytes_per_pixel").get<double>());
        check_as_alone(alone, folder, as_it_is);
    }
}

TEST_CASE("what the compositor wrote is left as it is, and one remark says so") {
    Folder const folder, alone;
    auto const composite = [](int i) {
        auto passes = passes_of(1, i);
        std::erase_if(passes.planes, [](auto const& each) { return !each.name.starts_with("Combined"); });
        return channels_of(passes, in_layer("Composite"));
    };
    auto const layer = in_layer("ViewLayer");
    write(folder, [&](int i) { return std::vector{part("", joined(channels_of(passes_of(0, i), layer), composite(i)))}; });
    write_alone(
        alone, [](int i) { return passes_of(0, i); }, layer);
    auto const summary = run(folder, options);
    CHECK_FALSE(summary.contains("views"));
    CHECK(summary.at("remarks").size() == run(alone, options).at("remarks").size() + 1);
    CHECK(mentions(summary, "Composite") == 1);
    check_as_alone(alone, folder, as_it_is);
    auto const before = channels_in(folder / numbered("frame.", 3)), after = channels_in(folder / numbered("out.", 3));
    CHECK(before.at("Composite.Combined.R half") == after.at("Composite.Combined.R half"));
}

TEST_CASE("each eye of a stereo picture comes out as if it were alone") {
    auto const in_one_part = [](Renames const& left, Renames const& right, std::vector<std::string> const& eyes) {
        return [=](int i) {
            auto whole = part("", joined(channels_of(picture_of(0, i), left), channels_of(picture_of(1, i), right)));
            whole.eyes = eyes;
            return std::vector{whole};
        };
    };
    SUBCASE("named in channels") {
        Folder const folder;
        write(folder, in_one_part(of_eye("left"), of_eye("right"), {}));
        check_both(folder, picture_of, {of_eye("left"), of_eye("right")}, {0, 0});
    }
    SUBCASE("the default one without a name") {
        Folder const folder;
        write(folder, in_one_part(as_it_is, of_eye("right"), {}));
        check_both(folder, picture_of, {as_it_is, of_eye("right")}, {0, 0});
    }
    SUBCASE("of other names, which an attribute lists") {
        Folder const folder;
        write(folder, in_one_part(as_it_is, of_eye("near"), {"far", "near"}));
        check_both(folder, picture_of, {as_it_is, of_eye("near")}, {0, 0});
    }
    SUBCASE("Blender's") {
        Folder const folder;
        auto const layer = in_layer("ViewLayer");
        auto const eye = [&](std::string const& name) { return [=](std::string const& pass) { return of_eye(name)(layer(pass)); }; };
        write(folder, [&](int i) {
            return std::vector{part("", joined(channels_of(passes_of(0, i), eye("left")), channels_of(passes_of(1, i), eye("right"))))};
        });
        auto const summary = run(folder, options);
        REQUIRE(summary.at("views").size() == 2);
        for (int which = 0; which < 2; ++which) {
            Folder const alone;
            write_alone(
                alone, [&](int i) { return passes_of(which, i); }, layer);
            run(alone, options);
            check_as_alone(alone, folder, of_eye(which == 0 ? "left" : "right"));
        }
        CHECK(channels_in(folder / numbered("out.", 3)).contains("ViewLayer.denoised_diffuse.right.R float"));
    }
    SUBCASE("in parts of their own, whose guides lie in other parts") {
        Folder const folder;
        auto const some = [](int which, int i, bool guides) {
            auto image = picture_of(which, i);
            std::erase_if(image.planes, [&](auto const& each) { return (each.name.find('.') != std::string::npos) != guides; });
            return channels_of(image, as_it_is);
        };
        write(folder, [&](int i) {
            return std::vector{part("rgbL", some(0, i, false), "left"), part("rgbR", some(1, i, false), "right"),
                               part("dataL", some(0, i, true), "left"), part("dataR", some(1, i, true), "right")};
        });
        auto const summary = run(folder, options);
        REQUIRE(summary.at("views").size() == 2);
        for (int which = 0; which < 2; ++which) {
            Folder const alone;
            write_alone(alone, [&](int i) { return picture_of(which, i); });
            run(alone, options);
            auto const expected = channels_in(alone / numbered("out.", 3)), found = channels_in(folder / numbered("out.", 3), which);
            for (std::string const name : {"R half", "G half", "B half"}) CHECK(found.at(name) == expected.at(name));
        }
    }
    SUBCASE("an eye without guides of its own takes none from the other") {
        Folder const folder;
        auto const light_alone = [](int i) {
            auto image = picture_of(1, i);
            std::erase_if(image.planes, [](auto const& each) { return each.name.find('.') != std::string::npos; });
            return channels_of(image, of_eye("right"));
        };
        write(folder, [&](int i) { return std::vector{part("", joined(channels_of(picture_of(0, i), as_it_is), light_alone(i)))}; });
        auto const summary = run(folder, options);
        CHECK(mentions(summary, "left as in the files: right") == 1);
        auto const before = channels_in(folder / numbered("frame.", 3)), after = channels_in(folder / numbered("out.", 3));
        CHECK(before.at("right.R half") == after.at("right.R half"));
        CHECK(before.at("R half") != after.at("R half"));
    }
}

TEST_CASE("each part that is whole by itself comes out as if it were alone") {
    Folder const folder;
    write(folder, [](int i) {
        return std::vector{part("near", channels_of(picture_of(0, i), as_it_is)), part("far", channels_of(picture_of(1, i), as_it_is))};
    });
    SUBCASE("quell's own") { check_both(folder, picture_of, {as_it_is, as_it_is}, {0, 1}); }
    SUBCASE("with alpha in one of them") {
        auto const alpha = std::vector<WholeChannel>{{"A", Imf::HALF, [](int x, int) { return x < 9 ? 0.f : 0.75f; }}};
        write(folder, [&](int i) {
            return std::vector{part("near", channels_of(picture_of(0, i), as_it_is)),
                               part("far", joined(channels_of(picture_of(1, i), as_it_is), alpha))};
        });
        run(folder, options);
        for (int which = 0; which < 2; ++which) {
            Folder const alone;
            write(alone, [&](int i) {
                auto const channels = channels_of(picture_of(which, i), as_it_is);
                return std::vector{part("", which == 0 ? channels : joined(channels, alpha))};
            });
            run(alone, options);
            check_as_alone(alone, folder, as_it_is, which);
        }
    }
    SUBCASE("with layers of Blender's") {
        auto const layer = in_layer("ViewLayer");
        write(folder, [&](int i) {
            return std::vector{part("near", channels_of(passes_of(0, i), layer)), part("far", channels_of(passes_of(1, i), layer))};
        });
        run(folder, options);
        for (int which = 0; which < 2; ++which) {
            Folder const alone;
            write_alone(
                alone, [&](int i) { return passes_of(which, i); }, layer);
            run(alone, options);
            check_as_alone(alone, folder, as_it_is, which);
        }
    }
}

TEST_CASE("a map is for each view, and where it names one, for that alone") {
    Folder const folder;
    auto const other_names = [](int which, int i) {
        auto image = picture_of(which, i);
        for (auto& plane : image.planes) {
            if (plane.name == "depth.Z") plane.name = "Z";
            if (plane.name.starts_with("motion.")) plane.name = plane.name == "motion.X" ? "u" : "v";
        }
        return image;
    };
    write(folder, [&](int i) {
        return std::vector{
            part("", joined(channels_of(other_names(0, i), of_eye("left")), channels_of(other_names(1, i), of_eye("right"))))};
    });
    auto const map = (folder / "map.json").string();
    std::ofstream(map) << R"({"channels": {"depth": "Z", "motion": ["u", "v"]}})";
    check_both(folder, other_names, {of_eye("left"), of_eye("right")}, {0, 0}, "--map '" + map + "'");

    std::ofstream(map) << R"({"channels": {"depth": "right.Z", "motion": ["u", "v"]}})";
    auto const summary = run(folder, options + "--map '" + map + "'");
    CHECK(mentions(summary, "left as in the files: left") == 1);
    auto const before = channels_in(folder / numbered("frame.", 3)), after = channels_in(folder / numbered("out.", 3));
    CHECK(before.at("left.R half") == after.at("left.R half"));
    CHECK(before.at("right.R half") != after.at("right.R half"));
}

TEST_CASE("references score the first view in the table, and all views in the summary") {
    Folder const folder;
    write(folder, [](int i) { return two_layers(i); });
    auto const references = "--reference '" + (folder / "frame.%04d.exr").string() + "' ";
    auto const summary = run(folder, options + references);
    auto const& views = summary.at("views");
    REQUIRE(views.size() == 2);
    CHECK(views[0].at("scores") == summary.at("scores"));
    for (std::size_t which = 0; which < 2; ++which) {
        Folder const alone;
        write_alone(
            alone, [&](int i) { return passes_of(static_cast<int>(which), i); }, in_layer(which == 0 ? "FG layer.001" : "FG layer"));
        auto const one = run(alone, options + "--reference '" + (alone / "frame.%04d.exr").string() + "' ");
        CHECK(views[which].at("scores") == one.at("scores"));
        CHECK(views[which].at("mean") == one.at("mean"));
    }
    auto const table = denoise(input(folder) + "--quiet " + options + references).lines();
    CHECK(table.size() == 4);
}

TEST_CASE("memory is that of all histories, and of images and scratch of one view") {
    auto const bytes_of_views = [](int count) {
        Folder const folder;
        write(folder, [&](int i) {
            std::vector<WholeChannel> channels;
            for (int which = 0; which < count; ++which)
                channels = joined(channels, channels_of(passes_of(which, i), in_layer("layer" + std::to_string(which))));
            return std::vector{part("", channels)};
        });
        return run(folder, "--preset general").at("bytes_per_pixel").get<double>();
    };
    auto const one = bytes_of_views(1), two = bytes_of_views(2), three = bytes_of_views(3);
    auto const history = two - one;
    CHECK(history > 0);
    CHECK(history < one / 2);
    CHECK(three - two == doctest::Approx(history));
}

TEST_CASE("parts of a job come out as the whole, with several views as with one") {
    Folder const folder;
    write(folder, [](int i) { return two_layers(i); });
    run(folder, "--preset general --extra-frames 1");
    auto const whole = whole_of(folder / numbered("out.", 3));
    for (int i = 0; i <= last_frame; ++i) std::filesystem::remove(folder / numbered("out.", i));
    run(folder, "--preset general --extra-frames 1 --chunk 2/2");
    CHECK(different(whole, whole_of(folder / numbered("out.", 3))).empty());
    auto const rest = run(folder, "--preset general --extra-frames 1 --skip-existing");
    CHECK(rest.at("skipped") == nlohmann::json{2, 3});
    CHECK(rest.at("written") == nlohmann::json{0, 1});
}

TEST_CASE("Blender's view layers are all denoised, and the compositor's picture is left" * doctest::test_suite("shared data")) {
    auto const cases = shared("data/cases");
    if (cases.empty()) return;
    auto const run_case = [&](std::string const& name, Folder const& folder) {
        auto const ran =
            denoise("--in '" + (cases / name / "frame_%04d.exr").string() + "' " + output(folder) + "--quiet --json --preset general");
        INFO(ran.out, ran.err);
        REQUIRE(ran.code == 0);
        return nlohmann::json::parse(ran.out);
    };
    Folder const layers, comp;
    CHECK(run_case("layers", layers).at("views").size() == 2);
    CHECK(mentions(run_case("comp", comp), "Composite") == 1);
    auto const changed = [&](std::string const& name, Folder const& folder) {
        return different(whole_of(cases / name / "frame_0003.exr"), whole_of(folder / numbered("out.", 3)));
    };
    std::size_t pictures = 0;
    for (auto const& channel : changed("layers", layers)) pictures += contains(channel, ".Combined.R") ? 1 : 0;
    CHECK(pictures == 2);
    bool has_view_layer = false;
    for (auto const& channel : changed("comp", comp)) {
        CHECK_FALSE(contains(channel, "Composite"));
        has_view_layer = has_view_layer || contains(channel, "ViewLayer.Combined.R");
    }
    CHECK(has_view_layer);
}

TEST_CASE("overscan, debug views and findings are those of each view") {
    Folder const together;
    // The right eye's motion points the wrong way.
    auto const seen_by = [](int which, int i) {
        auto image = picture_of(which, i);
        if (which == 1)
            for (auto& plane : image.planes)
                if (plane.name.starts_with("motion."))
                    for (auto& value : plane.values) value = -value;
        return image;
    };
    auto const with_overscan = [](Folder const& folder, std::function<std::vector<WholeChannel>(int)> const& channels) {
        for (int i = 0; i <= last_frame; ++i)
            write_whole(folder / numbered("frame.", i), box(3, 2, size.width - 4, size.height - 3), {part("", channels(i))});
    };
    with_overscan(together,
                  [&](int i) { return joined(channels_of(seen_by(0, i), of_eye("left")), channels_of(seen_by(1, i), of_eye("right"))); });
    auto const more = options + "--debug-view history_length --diagnose";
    auto const summary = run(together, more);
    for (int which = 0; which < 2; ++which) {
        std::string const eye = which == 0 ? "left" : "right";
        Folder const alone;
        with_overscan(alone, [&](int i) { return channels_of(seen_by(which, i), as_it_is); });
        auto const one = run(alone, more);
        check_as_alone(alone, together, of_eye(eye));
        auto const lengths = [&](Folder const& folder, std::string const& view) {
            return io::read_exr(folder / ("out.0003." + view + "history_length.exr"))["Y"].values;
        };
        CHECK(lengths(together, eye + ".") == lengths(alone, ""));
        std::size_t found = 0;
        for (auto const& line : summary.at("findings")) found += contains(line.get<std::string>(), "view " + eye) ? 1 : 0;
        CHECK(found == one.at("findings").size());
    }
}
