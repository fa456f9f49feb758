#include "passes.hpp"

#include <denoise/anti_alias.hpp>
#include <denoise/map_file.hpp>
#include <denoise/sample_count.hpp>

#include <fstream>

// Files as Blender's Cycles writes them, with what is odd about its passes.
using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent size{40, 24};
constexpr int frames = 3;

bool is_sky(int, int y) { return y < 6; }

/// Passes of a wall under the sky: diffuse light, and what lies behind everything. Without a view layer in front.
io::ExrImage passes_of(int number) {
    auto const own = noisy_image(size, number);
    io::ExrImage image{.size = size};
    auto const add = [&](std::string const& name, auto&& value) {
        image.planes.push_back(plane(name, size, [&](int x, int y) { return value(x, y, static_cast<std::size_t>(y * size.width + x)); }));
    };
    for (std::string const c : {"R", "G", "B"}) {
        auto const &light = own[c].values, &colour = own["albedo." + c].values;
        add("Combined." + c, [&](int x, int y, auto i) { return is_sky(x, y) ? 0.5f : light[i]; });
        add("DiffDir." + c, [&](int x, int y, auto i) { return is_sky(x, y) ? 0.f : light[i] / colour[i]; });
        add("DiffCol." + c, [&](int x, int y, auto i) { return is_sky(x, y) ? 0.f : colour[i]; });
        add("Env." + c, [&](int x, int y, auto) { return is_sky(x, y) ? 0.5f : 0.f; });
    }
    add("Combined.A", [](int, int, auto) { return 1.f; });
    add("Depth.Z", [](int x, int y, auto) { return is_sky(x, y) ? 1e10f : 5.f; });
    add("Vector.X", [](int, int, auto) { return -1.f; });
    add("Vector.Y", [](int, int, auto) { return 0.f; });
    add("Vector.Z", [](int, int, auto) { return -1.f; });
    add("Vector.W", [](int, int, auto) { return 0.f; });
    for (std::string const c : {"X", "Y", "Z"})
        add("Normal." + c, [&](int x, int y, auto) { return !is_sky(x, y) && c == "Z" ? 1.f : 0.f; });
    return image;
}

using Change = std::function<void(io::ExrImage&)>;
Change const none = [](io::ExrImage&) {};
Change renamed(std::vector<std::pair<std::string, std::string>> const& names) {
    return [=](io::ExrImage& image) {
        for (auto& plane : image.planes)
            for (auto const& [before, after] : names)
                if (plane.name.starts_with(before)) {
                    plane.name.replace(0, before.size(), after);
                    break;
                }
    };
}
Change in_layer(std::string const& name) {
    return [=](io::ExrImage& image) {
        for (auto& plane : image.planes) plane.name.insert(0, name + ".");
    };
}
Change each_value(std::string const& names, std::function<float(int x, int y, float value)> const& f) {
    return [=](io::ExrImage& image) {
        for (auto& each : image.planes)
            if (each.name.find(names) != std::string::npos)
                each = plane(each.name, size,
                             [&, was = each.values](int x, int y) { return f(x, y, was[static_cast<std::size_t>(y * size.width + x)]); });
    };
}

/// The frames of a sequence that were changed and denoised.
std::vector<io::ExrImage> frames_denoised(std::vector<Change> const& changes, std::string const& options = "",
                                          std::string const& said = "") {
    Folder const folder;
    for (int i = 0; i < frames; ++i) {
        auto image = passes_of(i);
        for (auto const& change : changes) change(image);
        image.attributes["cycles.ViewLayer.samples"] = std::string("1");
        io::write_exr(folder / numbered("frame.", i), image);
    }
    auto const ran = denoise(input(folder) + output(folder) + options);
    INFO(ran.err);
    CHECK(ran.code == 0);
    if (!said.empty()) CHECK(contains(ran.err, said));
    std::vector<io::ExrImage> images;
    for (int i = 0; i < frames && ran.code == 0; ++i) images.push_back(io::read_exr(folder / numbered("out.", i)));
    return images;
}
/// The picture of each.
std::vector<Colours> pictures(std::vector<io::ExrImage> const& images, std::string const& layer) {
    std::vector<Colours> all;
    for (auto const& image : images) all.push_back(pass(image, layer));
    return all;
}

} // namespace

TEST_CASE("the names of Blender 5 give the picture of those before") {
    auto const before = frames_denoised({in_layer("ViewLayer")}),
               after =
                   frames_denoised({renamed({{"DiffDir.", "Diffuse Direct."}, {"DiffCol.", "Diffuse Color."}, {"Env.", "Environment."}}),
                                    in_layer("ViewLayer")});
    CHECK(pictures(after, "ViewLayer.Combined") == pictures(before, "ViewLayer.Combined"));
    CHECK(pictures(after, "ViewLayer.denoised_diffuse") == pictures(before, "ViewLayer.denoised_diffuse"));
    CHECK(pictures(before, "ViewLayer.Combined") != pictures({passes_of(0), passes_of(1), passes_of(2)}, "Combined"));
}

TEST_CASE("a file of the compositor's node File Output gives the picture that a map gives") {
    Folder const folder;
    auto const map = folder / "map.json";
    for (bool const has_colour : {true, false}) {
        std::ofstream(map) << R"({"channels": {"depth": "Depth.V", "normal": "Normal", "motion": ["Vector.X", "Vector.Y"]},
                                  "motion": {"points": "to_previous", "unit": "pixel", "y": "up"}, "miss_from": 65504, "picture": "Image",
                                  "signals": [{"name": "diffuse", "irradiance": "DiffDir", "albedo": )"
                           << (has_colour ? R"("DiffCol"}], "added": "Env"})" : "1}]}");
        auto const as_the_node = [=](io::ExrImage& image) {
            std::erase_if(image.planes, [=](auto const& plane) {
                return plane.name == "Vector.W" || (!has_colour && (plane.name.starts_with("DiffCol") || plane.name.starts_with("Env")));
            });
            for (auto& plane : image.planes) {
                plane.type = io::SampleType::half;
                for (auto& value : plane.values) value = std::min(value, 65504.f); // the node limits them
            }
        };
        std::vector<Change> const changes{renamed({{"Combined.", "Image."}, {"Depth.Z", "Depth.V"}}), as_the_node};
        auto const alone = frames_denoised(changes, "", "Blender Cycles"),
                   by_map = frames_denoised(changes, "--map '" + map.string() + "'");
        CHECK(pictures(alone, "Image") == pictures(by_map, "Image"));
        if (has_colour) CHECK(pictures(alone, "denoised_diffuse") == pictures(by_map, "denoised_diffuse"));
    }
}

TEST_CASE("the number of samples is that of the view layer that is read") {
    io::ExrListing file{.name = "file", .size = {4, 3}};
    for (std::string const layer : {"ViewLayer", "ViewLayer.far", "FG layer"})
        for (std::string const pass : {".DiffDir.R", ".DiffDir.G", ".DiffDir.B", ".Depth.Z", ".Vector.X", ".Vector.Y"})
            file.channels.push_back({.name = layer + pass, .in_part = layer + pass});
    auto const samples_of = [&](std::string const& layer) {
        auto const views = examples::views_in(file);
        auto const view = std::ranges::find(views.views, layer, [](auto const& each) { return each.names.view; });
        return examples::samples_in(file, examples::names_in_file(*view, file));
    };
    CHECK(samples_of("FG layer") == 0);
    file.attributes = {{"cycles.FG layer.samples", std::string("128")},
                       {"cycles.FG layer.total_time", std::string("00:00.16")},
                       {"cycles.ViewLayer.samples", std::string("4")},
                       {"cycles.ViewLayer.far.samples", std::string("16")}};
    CHECK(samples_of("ViewLayer") == 4);
    CHECK(samples_of("ViewLayer.far") == 16);
    CHECK(samples_of("FG layer") == 128);
    // By a map that names no layer of Blender's.
    io::SequenceNames other{"a map", {{"radiance"}}};
    CHECK(examples::samples_in(file, other) == 0);
    file.attributes.erase("cycles.ViewLayer.samples"), file.attributes.erase("cycles.ViewLayer.far.samples");
    CHECK(examples::samples_in(file, other) == 128);
}

TEST_CASE("outside of a render region there is no surface, and vectors of 10000 lead nowhere") {
    // Cycles fills all passes there: depth with 1e11, vectors with 10000, light with 0.
    auto const is_outside = [](int x) { return x >= 24; };
    auto const outside = [=](std::string const& name, float there) {
        return each_value(name, [=](int x, int, float value) { return is_outside(x) ? there : value; });
    };
    auto const images = frames_denoised({outside("Combined", 0.f), outside("Diff", 0.f), outside("Env", 0.f), outside("Normal", 0.f),
                                         outside("Depth", 1e11f), outside("Vector", 10000.f), in_layer("ViewLayer")});
    for (auto const& picture : pictures(images, "ViewLayer.Combined"))
        for (std::size_t i = 0; i < picture.size(); ++i) {
            auto const x = static_cast<int>(i) % size.width;
            CHECK(glm::all(glm::lessThan(picture[i], glm::vec3(60.f))));
            if (is_outside(x)) CHECK(picture[i] == glm::vec3(0.f));
        }
}

TEST_CASE("normals of length 2, as Cycles writes them for catchers, are as good as those of length 1") {
    auto const twice = each_value("Normal", [](int x, int, float value) { return x % 8 < 4 ? 2.f * value : value; });
    CHECK(pictures(frames_denoised({twice, in_layer("V")}, "", "normal not of length 1"), "V.Combined") ==
          pictures(frames_denoised({in_layer("V")}), "V.Combined"));
}

TEST_CASE("colours that are twice too large give no more light than the picture has") {
    // As under subsurface scattering and on catchers.
    auto const twice = each_value("DiffCol", [](int, int, float value) { return 2.f * value; });
    auto const mean_of = [](std::vector<io::ExrImage> const& images) {
        double sum = 0;
        for (auto const& colour : pass(images.back(), "V.Combined")) sum += static_cast<double>(colour.x);
        return sum / static_cast<double>(size.pixels());
    };
    CHECK(mean_of(frames_denoised({twice, in_layer("V")})) == doctest::Approx(mean_of(frames_denoised({in_layer("V")}))).epsilon(0.02));
}

TEST_CASE("colours near the largest half stay finite in a file of lossy compression, enlarged or not, and vectors stay what they are") {
    Folder const folder;
    auto image = passes_of(1);
    in_layer("ViewLayer")(image);
    for (auto& each : image.planes)
        if (each.name.find("Combined") != std::string::npos || each.name.find("Env") != std::string::npos)
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < size.width; ++x)
                    if ((x * 7 + y * 5) % 3 == 0 && !each.name.ends_with(".A"))
                        each.values[static_cast<std::size_t>(y * size.width + x)] = 65504.f;
    for (auto& each : image.planes)
        if (each.name.find("Normal") != std::string::npos || each.name.find("Vector") != std::string::npos)
            for (std::size_t i = 0; i < each.values.size(); ++i) each.values[i] += 0.01f * static_cast<float>(i * 7919 % 97) / 97.f;
    io::write_exr(folder / numbered("frame.", 1), image, Imf::DWAA_COMPRESSION);
    for (std::string const option : {"", "--upsample 2 "}) {
        auto const ran = denoise(input(folder) + output(folder) + option);
        CHECK(ran.code == 0);
        INFO(ran.err);
        if (option.empty()) CHECK(contains(ran.err, "packed without loss (ZIP)"));
        auto const in = io::read_exr(folder / numbered("frame.", 1)), out = io::read_exr(folder / numbered("out.", 1));
        for (auto const& each : out.planes) {
            INFO(each.name);
            bool const is_passed_on = each.name.find("Env") != std::string::npos; // infinite in the input already
            if (!is_passed_on) CHECK(std::ranges::all_of(each.values, [](float value) { return is_finite(value); }));
            bool const is_vector = each.name.find("Normal") != std::string::npos || each.name.find("Vector") != std::string::npos;
            if (is_vector) CHECK(each.values == in[each.name].values);
        }
    }
}
