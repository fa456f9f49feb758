#include "files.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

/// The passes of a view layer, each component with a value of its own.
io::ExrImage cycles_image(std::string const& layer, std::vector<std::pair<std::string, std::string>> const& passes) {
    io::ExrImage image{.size = {4, 3}};
    for (auto const& [pass, letters] : passes)
        for (char const letter : letters) {
            auto const value = static_cast<float>(image.planes.size() + 1);
            image.planes.push_back(plane(layer + "." + pass + "." + letter, image.size, [=](int, int) { return value; }));
        }
    return image;
}
std::vector<std::pair<std::string, std::string>> const all_passes{
    {"Combined", "RGBA"}, {"Depth", "Z"},      {"Normal", "XYZ"},   {"Vector", "XYZW"},  {"DiffDir", "RGB"}, {"DiffInd", "RGB"},
    {"DiffCol", "RGB"},   {"GlossDir", "RGB"}, {"GlossInd", "RGB"}, {"GlossCol", "RGB"}, {"Emit", "RGB"},    {"Env", "RGB"}};

/// The same with all passes, and the combined image that these make up.
io::ExrImage whole_image(std::string const& layer) {
    auto image = cycles_image(layer, all_passes);
    for (std::string const letter : {".R", ".G", ".B"}) {
        auto const value = [&](std::string const& pass) { return image[layer + "." + pass + letter].values[0]; };
        auto const all = (value("DiffDir") + value("DiffInd")) * value("DiffCol") +
                         (value("GlossDir") + value("GlossInd")) * value("GlossCol") + value("Emit") + value("Env");
        for (auto& plane : image.planes)
            if (plane.name == layer + ".Combined" + letter) plane.values.assign(plane.values.size(), all);
    }
    return image;
}

io::SequenceNames names_of(Folder const& folder, io::ExrImage const& image) {
    io::write_exr(folder / "cycles.exr", image);
    return io::recognise(io::ExrFile(folder / "cycles.exr"));
}

/// What passes are called in Blender 2.8 to 4, and in 5.
std::vector<std::pair<std::string, std::string>> const new_names{{"DiffDir", "Diffuse Direct"},
                                                                 {"DiffInd", "Diffuse Indirect"},
                                                                 {"DiffCol", "Diffuse Color"},
                                                                 {"GlossDir", "Glossy Direct"},
                                                                 {"GlossInd", "Glossy Indirect"},
                                                                 {"GlossCol", "Glossy Color"},
                                                                 {"TransDir", "Transmission Direct"},
                                                                 {"TransInd", "Transmission Indirect"},
                                                                 {"TransCol", "Transmission Color"},
                                                                 {"SubsurfaceDir", "Subsurface Direct"},
                                                                 {"SubsurfaceInd", "Subsurface Indirect"},
                                                                 {"SubsurfaceCol", "Subsurface Color"},
                                                                 {"VolumeDir", "Volume Direct"},
                                                                 {"VolumeInd", "Volume Indirect"},
                                                                 {"Emit", "Emission"},
                                                                 {"Env", "Environment"},
                                                                 {"IndexOB", "Object Index"}};
std::string in_blender_5(std::string name) {
    for (auto const& [before, after] : new_names)
        if (auto const at = name.find("." + before + "."); at != std::string::npos) name.replace(at + 1, before.size(), after);
    return name;
}
/// Everything that names say, as text.
std::string text_of(io::SequenceNames const& names, auto const& called) {
    std::string text = names.renderer + "," + names.layer;
    auto const add = [&](std::string const& what, std::vector<io::Source> const& sources) {
        text += "\n" + what;
        for (auto const& source : sources) {
            text += "; " + std::to_string(source.scale);
            for (auto const& plane : source.sum) text += " " + called(plane);
        }
    };
    for (auto const& signal : names.of_signals) {
        for (auto const& [channel, sources] : signal.channels.sources) add(signal.name + " " + channel, sources);
        add(signal.name + " factor", signal.factor);
    }
    add("added", names.added), add("picture", names.picture);
    return text;
}

} // namespace

TEST_CASE("Blender 5 calls passes otherwise, and takes nothing else from them") {
    Folder const folder;
    auto passes = all_passes;
    passes.push_back({"IndexOB", "X"});
    for (auto const& [name, of_5] : new_names)
        if (name != "IndexOB" && std::ranges::find(passes, name, &std::pair<std::string, std::string>::first) == passes.end())
            passes.push_back({name, "RGB"});
    auto image = cycles_image("ViewLayer", passes);
    auto const before = names_of(folder, image);
    CHECK(before.of_signals.size() == 5);
    for (auto& plane : image.planes) plane.name = in_blender_5(plane.name);
    auto const after = names_of(folder, image);
    CHECK(after.remarks.empty());
    CHECK(text_of(after, [](std::string const& name) { return name; }) == text_of(before, in_blender_5));
    // A layer without a combined image is one too.
    std::erase_if(image.planes, [](auto const& plane) { return plane.name.find("Combined") != std::string::npos; });
    CHECK(names_of(folder, image).layer == "ViewLayer.");
}

TEST_CASE("files of Blender's compositor node File Output are read as those of the render output") {
    Folder const folder;
    for (auto const type : {io::SampleType::half, io::SampleType::float32}) {
        auto image = cycles_image("", {{"Image", "RGBA"}, {"Depth", "V"}, {"Normal", "XYZ"}, {"Vector", "XYZ"}, {"DiffDir", "RGBA"}});
        for (auto& plane : image.planes) plane.name.erase(0, 1), plane.type = type; // the dot
        for (auto& plane : image.planes)
            if (plane.name == "Depth.V") plane.values[1] = type == io::SampleType::half ? 65504.f : 1e10f, plane.values[2] = 65472.f;
        auto const names = names_of(folder, image);
        CHECK(names.renderer == "Blender Cycles");
        CHECK(names.layer.empty());
        REQUIRE(names.of_signals.size() == 1);
        CHECK(names.of_signals[0].name == "diffuse");
        CHECK(names.picture.at(1).sum == std::vector<std::string>{"Image.G"});
        CHECK_FALSE(names.of_signals[0].channels.sources.contains("motion_next")); // its y is not there
        Frame<Channels<Radiance, Normal, Depth, Motion>> frame(image.size);
        io::load(frame, image, names.of_signals[0].channels);
        CHECK(frame[depth].get(0, 0) == image["Depth.V"].values[0]);
        CHECK(frame[depth].get(1, 0) == std::numeric_limits<float>::infinity()); // the sky
        CHECK(frame[depth].get(2, 0) == 65472.f);
        CHECK(frame[motion].get(2, 2) == glm::vec2(image["Vector.X"].values[0], -image["Vector.Y"].values[0]));
        std::erase_if(image.planes, [](auto const& plane) { return plane.name.starts_with("Depth"); });
        check_error([&] { static_cast<void>(names_of(folder, image)); }, {"neither quell's", "Depth.V"});
    }
}

TEST_CASE("Blender's passes are recognised, whatever the view layer's name") {
    Folder const folder;
    for (auto const* const layer : {"ViewLayer", "View Layer", "shot.a"}) {
        auto const image = whole_image(layer);
        auto const names = names_of(folder, image);
        CHECK(names.renderer == "Blender Cycles");
        CHECK(names.remarks.empty());
        REQUIRE(names.of_signals.size() == 2);
        CHECK(names.of_signals[0].name == "diffuse");
        CHECK(names.of_signals[1].name == "glossy");
        CHECK(names.added[2].sum == std::vector<std::string>{std::string(layer) + ".Emit.B", std::string(layer) + ".Env.B"});
        CHECK(names.of_signals[0].factor[1].sum == std::vector<std::string>{std::string(layer) + ".DiffCol.G"});
    }
}

TEST_CASE("Cycles' light, motion and depth arrive in quell's conventions") {
    Folder const folder;
    auto image = whole_image("ViewLayer");
    auto const names = names_of(folder, image);
    for (auto& plane : image.planes)
        if (plane.name == "ViewLayer.Depth.Z") plane.values[1] = 1e10f;
    Frame<Channels<Radiance, Albedo, Normal, Depth, Motion, MotionNext>> frame(image.size);
    io::load(frame, image, names.of_signals[0].channels);
    auto const value = [&](std::string const& name) { return image["ViewLayer." + name].values[0]; };
    CHECK(frame[radiance].get(0, 0).y == value("DiffDir.G") + value("DiffInd.G"));
    CHECK(frame[albedo].get(0, 0) == glm::vec3(1.f));
    CHECK(frame[motion].get(2, 2) == glm::vec2(value("Vector.X"), -value("Vector.Y")));
    CHECK(frame[motion_next].get(2, 2) == glm::vec2(-value("Vector.Z"), value("Vector.W"))); // of which Blender has the other end
    CHECK(frame[normal].get(1, 1) == glm::vec3(value("Normal.X"), value("Normal.Y"), value("Normal.Z")));
    CHECK(frame[depth].get(0, 0) == value("Depth.Z"));
    CHECK(frame[depth].get(1, 0) == std::numeric_limits<float>::infinity());
}

TEST_CASE("passes that weren't rendered are done without where that is possible") {
    Folder const folder;
    auto const image = cycles_image("V", {{"Depth", "Z"}, {"Vector", "XYZW"}, {"DiffInd", "RGB"}, {"DiffCol", "RGB"}});
    auto const names = names_of(folder, image);
    REQUIRE(names.of_signals.size() == 1);
    CHECK(names.added.empty());
    REQUIRE(names.remarks.size() == 1);
    CHECK(contains(names.remarks[0], "Normal"));
    Frame<Channels<Radiance, Normal>> frame(image.size);
    io::load(frame, image, names.of_signals[0].channels);
    CHECK(frame[normal].get(3, 2) == glm::vec3(0.f, 0.f, 1.f));

    auto const combined =
        names_of(folder, cycles_image("V", {{"Combined", "RGBA"}, {"Depth", "Z"}, {"Normal", "XYZ"}, {"Vector", "XYZW"}}));
    REQUIRE(combined.of_signals.size() == 1);
    CHECK(combined.of_signals[0].name == "combined");
    CHECK(combined.remarks.size() == 1);
}

TEST_CASE("light passes are the signals, whether or not they hold all of the combined image") {
    Folder const folder;
    auto image = cycles_image("V", {{"Combined", "RGB"}, {"Depth", "Z"}, {"Normal", "XYZ"}, {"Vector", "XYZW"}});
    auto const add = [&](std::string const& pass, float value) {
        for (auto const* const letter : {".R", ".G", ".B"})
            image.planes.push_back(plane("V." + pass + letter, image.size, [=](int, int) { return value; }));
    };
    add("DiffDir", 0.6f), add("DiffCol", 0.5f);
    auto const few = names_of(folder, image);
    REQUIRE(few.of_signals.size() == 1);
    CHECK(few.of_signals[0].name == "diffuse");
    CHECK(few.added.empty());
    REQUIRE(few.picture.size() == 3); // what they leave over of it is found in each frame
    CHECK(few.picture[2].sum == std::vector<std::string>{"V.Combined.B"});
    CHECK(few.remarks.empty());
    add("Emit", 0.7f);
    CHECK(names_of(folder, image).added.size() == 3);
    // A pass of which one component is there is as good as none.
    std::erase_if(image.planes, [](auto const& p) { return p.name == "V.Emit.G" || p.name == "V.DiffCol.B"; });
    CHECK(names_of(folder, image).added.empty());
    CHECK(names_of(folder, image).of_signals[0].factor.empty());
    std::erase_if(image.planes, [](auto const& p) { return p.name == "V.DiffDir.R"; });
    auto const none = names_of(folder, image);
    CHECK(none.of_signals[0].name == "combined");
    REQUIRE(none.remarks.size() == 1);
    for (auto const* const part : {"no light passes", "one signal"}) CHECK(contains(none.remarks[0], part));
}

TEST_CASE("a missing Vector pass is named") {
    Folder const folder;
    auto const image = cycles_image("V", {{"Combined", "RGBA"}, {"Depth", "Z"}, {"Normal", "XYZ"}});
    auto const names = names_of(folder, image);
    Frame<Channels<Radiance, Motion>> frame(image.size);
    check_error([&] { io::load(frame, image, names.of_signals[0].channels); }, {"no channel 'V.Vector.X'", "V.Depth.Z"});
}

TEST_CASE("quell's own names go before others, and unknown ones are listed") {
    Folder const folder;
    auto own = cycles_image("V", {{"Combined", "RGB"}});
    for (auto const* const name : {"R", "G", "B"}) own.planes.push_back(plane(name, own.size, [](int, int) { return 1.f; }));
    CHECK(names_of(folder, own).renderer == "quell");
    auto const unknown = cycles_image("beauty", {{"colour", "RGB"}});
    check_error([&] { static_cast<void>(names_of(folder, unknown)); }, {"cycles.exr", "neither quell's", "channel map", "beauty.colour.B"});
}

TEST_CASE("the Cycles sequence is recognised, and its passes make up its image" * doctest::test_suite("shared data")) {
    auto const folder = shared("data/sequences/cycles_occlusion");
    if (folder.empty()) return;
    io::ExrFile const file(folder / "frame_0040.exr");
    auto const names = io::recognise(file);
    CHECK(names.renderer == "Blender Cycles");
    CHECK(names.of_signals.size() == 2);
    auto const image = file.read();
    double worst = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        double sum = 0;
        auto const value = [&](io::Source const& source) {
            double all = 0;
            for (auto const& name : source.sum) all += static_cast<double>(image[name].values[i] * source.scale);
            return all;
        };
        for (auto const& signal : names.of_signals) sum += value(signal.channels.sources.at("radiance")[0]) * value(signal.factor[0]);
        sum += value(names.added[0]);
        double const combined = static_cast<double>(image["ViewLayer.Combined.R"].values[i]);
        worst = std::max(worst, std::abs(sum - combined) / std::max(1., combined));
    }
    CHECK(worst < 0.01); // passes are half
}
