#include "programs.hpp"

#include <denoise/map_file.hpp>

using namespace quell;
using namespace quell::tests;
using quell::examples::map_example;
using quell::examples::parse_map;

namespace {
io::SequenceNames map(std::string const& text) { return parse_map(text, "map.json"); }
using Names = std::vector<std::string>;
} // namespace

TEST_CASE("an empty map stands for quell's own names") {
    auto const names = map("{}");
    REQUIRE(names.of_signals.size() == 1);
    CHECK(io::planes_of(Channels<Radiance, Depth>{}, names.of_signals[0].channels) == Names{"R", "G", "B", "depth.Z"});
    CHECK(names.added.empty());
}

TEST_CASE("layers, whole names, sums, scales and constants") {
    auto const names = map(R"({
        // comments are welcome
        "channels": {"depth": "Z", "normal": "N", "albedo": 1, "radiance": {"from": ["direct", "indirect"], "scale": 2},
                     "motion": ["speed.x", {"from": "speed.y", "scale": -1}], "position": [{"from": ["a", "b"]}, "c", 0.5]},
        "miss_from": 1e6, "shutter": 0.25})");
    auto const& channels = names.of_signals[0].channels;
    CHECK(io::planes_of(Channels<Depth, Normal, Albedo>{}, channels) == Names{"Z", "N.X", "N.Y", "N.Z"});
    CHECK(channels.sources.at("albedo")[2].scale == 1.f);
    CHECK(channels.sources.at("radiance")[1].sum == Names{"direct.G", "indirect.G"});
    CHECK(channels.sources.at("radiance")[1].scale == 2.f);
    CHECK(channels.sources.at("motion")[1].sum == Names{"speed.y"});
    CHECK(channels.sources.at("motion")[1].scale == -1.f);
    CHECK(channels.sources.at("position")[0].sum == Names{"a", "b"});
    CHECK(channels.sources.at("position")[2].scale == 0.5f);
    CHECK(channels.miss_from == 1e6f);
    CHECK(channels.shutter == 0.25f);
}

TEST_CASE("the layer without a name is the image itself") {
    CHECK(io::planes_of(map(R"({"channels": {"albedo": ""}})").of_signals[0].channels.sources.at("albedo")) == Names{"R", "G", "B"});
}

TEST_CASE("channels that only some presets read can be named too") {
    auto const names = map(R"({"channels": {"radiance_gradient": "change", "sweep_bend": ["bx", "by"], "sweep_visibility": 0,
                                            "sweep_glossy": "mirrored"}})");
    auto const& channels = names.of_signals[0].channels;
    CHECK(io::planes_of(Channels<GradientOf<Radiance>, SweepBend, SweepOf<Visibility>, SweepOf<Glossy>>{}, channels) ==
          Names{"change.X", "change.Y", "bx", "by", "mirrored.X", "mirrored.Y"});
}

TEST_CASE("offsets, and depths without a surface") {
    auto const names = map(R"({"channels": {"normal": {"from": "N", "scale": 2, "offset": -1}, "depth": {"from": "Z", "offset": 0.5},
                                            "motion": [{"from": "u", "scale": 64, "offset": -32}, "v"]}, "miss_to": 0})");
    auto const& channels = names.of_signals[0].channels;
    for (auto const& source : channels.sources.at("normal")) CHECK((source.scale == 2.f && source.offset == -1.f));
    CHECK(channels.sources.at("depth")[0].offset == 0.5f);
    CHECK(channels.sources.at("motion")[0].offset == -32.f);
    CHECK(channels.sources.at("motion")[1].offset == 0.f);
    CHECK(channels.miss_to == 0.f);
}

TEST_CASE("names that stand for each other, and letters, go by what the file has") {
    Folder const folder;
    io::ExrImage image{.size = {4, 3}};
    for (auto const* const name : {"c.r", "c.g", "c.b", "N.R", "N.G", "N.B", "d.Z"})
        image.planes.push_back(plane(name, image.size, [](int, int) { return 1.f; }));
    io::write_exr(folder / "f.exr", image);
    io::ExrFile const file(folder / "f.exr");
    std::string const text =
        R"({"channels": {"radiance": {"first_of": ["beauty", "c"]}, "normal": {"first_of": ["N", [0, 0, 1]]}, "depth": "d",
                                              "albedo": {"first_of": ["paint", 1]}, "motion": {"first_of": ["mv", ["a", "b"]]}}})";
    auto const with = parse_map(text, "map.json", &file).of_signals[0].channels;
    CHECK(io::planes_of(Channels<Radiance, Normal, Depth>{}, with) == Names{"c.r", "c.g", "c.b", "N.R", "N.G", "N.B", "d.Z"});
    CHECK(io::planes_of(with.sources.at("albedo")).empty());
    CHECK(with.sources.at("albedo")[1].scale == 1.f);
    CHECK(io::planes_of(with.sources.at("motion")) == Names{"mv.X", "mv.Y"}); // it has neither: the message names the first
    auto const without = map(text).of_signals[0].channels;
    CHECK(io::planes_of(Channels<Radiance, Normal>{}, without) == Names{"beauty.R", "beauty.G", "beauty.B", "N.X", "N.Y", "N.Z"});
}

TEST_CASE("motion in another convention") {
    using C = MotionConvention;
    auto const names = map(R"({"motion": {"points": "from_previous", "unit": "ndc", "y": "up", "jitter": "left_in"}})");
    CHECK(names.of_signals[0].channels.motion == C{C::Points::from_previous, C::Unit::ndc, C::Y::up, C::Jitter::left_in});
    CHECK(map(R"({"motion": {}})").of_signals[0].channels.motion == C{});
}

TEST_CASE("depth along rays") {
    auto const depth = map(R"({"depth": {"along": "ray", "vertical_field_of_view": 40}})").of_signals[0].channels.depth;
    CHECK(depth.along == io::DepthConvention::Along::ray);
    CHECK(depth.vertical_field_of_view == 40.f);
    CHECK(map("{}").of_signals[0].channels.depth.along == io::DepthConvention::Along::view_axis);
}

TEST_CASE("signals with and without their albedo, and what is added") {
    auto const names = map(R"({
        "channels": {"depth": "Z"},
        "signals": [{"name": "all", "radiance": "beauty", "albedo": "colour"},
                    {"irradiance": "light", "albedo": "paint", "normal": "N2"}],
        "added": {"from": ["emission", "sky"]}})");
    REQUIRE(names.of_signals.size() == 2);
    auto const& all = names.of_signals[0];
    CHECK(all.name == "all");
    CHECK(all.factor.empty());
    CHECK(io::planes_of(Channels<Radiance, Albedo, Depth>{}, all.channels) ==
          Names{"beauty.R", "beauty.G", "beauty.B", "colour.R", "colour.G", "colour.B", "Z"});
    auto const& light = names.of_signals[1];
    CHECK(io::planes_of(light.factor) == Names{"paint.R", "paint.G", "paint.B"});
    CHECK(io::planes_of(Channels<Radiance, Albedo>{}, light.channels) == Names{"light.R", "light.G", "light.B"});
    CHECK(light.channels.sources.at("normal")[2].sum == Names{"N2.Z"});
    CHECK_FALSE(all.channels.sources.contains("normal"));
    CHECK(names.added[1].sum == Names{"emission.G", "sky.G"});
}

TEST_CASE("mistakes are named with their place and what to write") {
    auto const check = [](std::string const& text, std::initializer_list<std::string> parts) {
        INFO(text);
        check_error([&] { static_cast<void>(map(text)); }, parts);
    };
    check("", {"map.json", "isn't JSON"});
    check("{\"channels\": ", {"map.json", "isn't JSON"});
    check(R"({"channels": {"depth": {"first_of": []}}})", {"channels.depth.first_of is []", "at least one"});
    check(R"({"channels": {"depth": {"first_of": ["Z"], "scale": 2}}})", {"channels.depth.scale", "any of: first_of"});
    check(R"({"channels": {"depth": {"from": "Z", "offset": "x"}}})", {"channels.depth.offset is \"x\"", "write a number"});
    check("[1]", {"map.json", "it is [1]", "write an object"});
    check(R"({"chanels": {}})",
          {"map.json", "chanels is {}", "no member of that name", "channels, motion, depth, miss_from, miss_to, shutter, signals, added"});
    check(R"({"channels": {"dept": "Z"}})", {"channels.dept is \"Z\"", "no such channel"});
    check(R"({"channels": 3})", {"channels is 3", "write an object"});
    check(R"({"channels": {"normal": ["a", "b"]}})", {"channels.normal is [\"a\",\"b\"]", "a list of 3"});
    check(R"({"channels": {"motion": ["a", true]}})", {"channels.motion[1] is true", "write a name, a number"});
    check(R"({"channels": {"depth": {"scale": 2}}})", {"channels.depth", "name the channel"});
    check(R"({"channels": {"depth": {"from": 5}}})", {"channels.depth.from is 5", "a name or a list"});
    check(R"({"channels": {"depth": {"from": []}}})", {"channels.depth.from is []", "at least one name"});
    check(R"({"added": {"from": []}})", {"added.from is []", "at least one name"});
    check(R"({"channels": {"depth": {"from": "Z", "scale": "x"}}})", {"channels.depth.scale is \"x\"", "write a number"});
    check(R"({"motion": {"y": "left"}})", {"motion.y is \"left\"", "write down or up"});
    check(R"({"motion": {"unit": 1}})", {"motion.unit is 1", "pixel or uv or ndc"});
    check(R"({"depth": {"along": "axis"}})", {"depth.along is \"axis\"", "view_axis or ray"});
    check(R"({"depth": {"vertical_field_of_view": 180}})", {"depth.vertical_field_of_view is 180", "between 0 and 180"});
    check(R"({"shutter": -1})", {"map.json", "shutter is -1", "0 or more"});
    check(R"({"signals": []})", {"signals is []", "at least one signal"});
    check(R"({"signals": ["beauty"]})", {"signals[0] is \"beauty\"", "\"radiance\" or \"irradiance\""});
    check(R"({"signals": [{"radiance": "a", "irradiance": "b"}]})", {"signals[0]", "not both"});
    std::string const brackets(100'000, '[');
    check(brackets, {"map.json", "deep in each other"});
    check("{\"motion\": " + brackets + std::string(brackets.size(), ']') + "}", {"map.json", "deep in each other"});
    check_error([] { static_cast<void>(examples::read_map("/nowhere/map.json")); },
                {"/nowhere/map.json", "can't be read", "one of: arnold, karma, "});
}

TEST_CASE("the example of a map is one, with every member, and stands in the documentation and in --help") {
    auto const names = parse_map(std::string(map_example), "example");
    CHECK(names.of_signals.size() == 2);
    CHECK(!names.added.empty());
    CHECK(contains(bytes_of(QUELL_ROOT "/docs/programs.md"), std::string(map_example)));
    CHECK(contains(denoise("--help").out, std::string(map_example)));
}
