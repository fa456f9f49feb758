#include "whole_file.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::vector<WholeChannel> constants(std::vector<std::string> const& names, float value) {
    std::vector<WholeChannel> channels;
    for (auto const& name : names) channels.push_back({name, Imf::FLOAT, [=](int, int) { return value; }});
    return channels;
}
std::vector<WholeChannel> eye(float value) { return constants({"B", "G", "R", "Z"}, value); }

auto const window = box(0, 0, 7, 5);

io::SequenceNames with_light(std::string const& part, std::string const& depth) {
    io::SequenceNames names{"test", {{"light"}}};
    auto& sources = names.of_signals[0].channels.sources;
    for (auto const* const letter : {"R", "G", "B"}) sources["radiance"].push_back({{part + letter}});
    sources["depth"] = {{{depth}}};
    return names;
}

/// Loads radiance and depth of a file by these names.
glm::vec2 loaded(std::filesystem::path const& path, io::SequenceNames const& names) {
    io::ExrFile const file(path);
    auto const channels = io::names_in_parts(names, file).of_signals[0].channels;
    Frame<Channels<Radiance, Depth>> frame(file.size);
    auto const planes = io::planes_of(Channels<Radiance, Depth>{}, channels);
    io::load(frame, file.read(planes), channels);
    return {frame[radiance].get(3, 2).x, frame[depth].get(3, 2)};
}

} // namespace

TEST_CASE("a name that several parts have is that of the picture's part") {
    Folder const folder;
    write_whole(folder / "eyes.exr", window, {{"left", window, eye(1.f)}, {"right", window, eye(2.f)}});
    CHECK(loaded(folder / "eyes.exr", with_light("", "Z")) == glm::vec2(1.f, 1.f)); // without a part, the first
    CHECK(loaded(folder / "eyes.exr", with_light("left.", "Z")) == glm::vec2(1.f, 1.f));
    CHECK(loaded(folder / "eyes.exr", with_light("right.", "Z")) == glm::vec2(2.f, 2.f));
    CHECK(loaded(folder / "eyes.exr", with_light("right.", "left.Z")) == glm::vec2(2.f, 1.f)); // said so
}

TEST_CASE("so are names that a map leaves out, factors, and what is added") {
    Folder const folder;
    auto const channels = [](float value) { return constants({"B", "G", "R", "depth.Z", "paint.B", "paint.G", "paint.R"}, value); };
    write_whole(folder / "eyes.exr", window, {{"left", window, channels(1.f)}, {"right", window, channels(2.f)}});
    io::ExrFile const file(folder / "eyes.exr");
    auto names = with_light("right.", "depth.Z");
    names.of_signals[0].channels.sources.erase("depth");
    names.of_signals[0].factor = {{{"paint.R"}}, {{"paint.G"}}, {{"paint.B"}}};
    names.added = names.of_signals[0].factor;
    CHECK(loaded(folder / "eyes.exr", names) == glm::vec2(2.f, 2.f));
    auto const found = io::names_in_parts(names, file);
    CHECK(file.find(found.of_signals[0].factor[1].sum[0])->part == 1);
    CHECK(file.find(found.added[2].sum[0])->part == 1);
}

TEST_CASE("parts of one view belong together") {
    Folder const folder;
    std::vector<WholePart> parts;
    for (std::string const view : {"left", "right"}) {
        float const value = view == "left" ? 1.f : 2.f;
        parts.push_back({"rgb." + view, window, constants({"B", "G", "R"}, value)});
        parts.push_back({"depth." + view, window, constants({"Z"}, value)});
        parts[parts.size() - 2].view = parts.back().view = view;
    }
    write_whole(folder / "views.exr", window, parts);
    CHECK(loaded(folder / "views.exr", with_light("rgb.left.", "Z")) == glm::vec2(1.f, 1.f));
    CHECK(loaded(folder / "views.exr", with_light("rgb.right.", "Z")) == glm::vec2(2.f, 2.f));
}

TEST_CASE("a name is refused where no rule tells which part's it is, and taken where one part has it") {
    Folder const folder;
    std::vector<WholePart> parts{{"beauty", window, constants({"B", "G", "R"}, 1.f)}, {"near", window, constants({"Z"}, 2.f)}};
    write_whole(folder / "one.exr", window, parts);
    CHECK(loaded(folder / "one.exr", with_light("", "Z")) == glm::vec2(1.f, 2.f));
    parts.push_back({"far", window, constants({"Z"}, 3.f)});
    write_whole(folder / "two.exr", window, parts);
    check_error([&] { static_cast<void>(loaded(folder / "two.exr", with_light("", "Z"))); },
                {"two.exr channel 'Z'", "the parts near, far have it", "the picture lies in part beauty", "near.Z"});
    CHECK(loaded(folder / "two.exr", with_light("", "far.Z")) == glm::vec2(1.f, 3.f));
    CHECK(loaded(folder / "two.exr", with_light("", "near.Z")) == glm::vec2(1.f, 2.f)); // it has the bare name in the file
}

TEST_CASE("an offset and a scale are those of what the file holds") {
    Folder const folder;
    auto const data = box(2, 1, 6, 4);
    write_whole(folder / "packed.exr", window, {{"", data, constants({"B", "G", "R"}, 0.75f)}});
    io::ChannelNames names;
    for (auto const* const letter : {"R", "G", "B"}) names.sources["normal"].push_back({{letter}, 2.f, -1.f});
    names.sources["depth"] = {{{"R"}, 100.f, 10.f}};
    Frame<Channels<Normal, Depth>> frame({8, 6});
    io::load(frame, io::read_exr(folder / "packed.exr"), names);
    CHECK(frame[normal].get(3, 2) == glm::vec3(0.5f));
    CHECK(frame[depth].get(3, 2) == 85.f);
    CHECK(frame[normal].get(0, 2) == glm::vec3(0.f)); // outside of the data window there is nothing, not the offset
    CHECK(frame[depth].get(7, 5) == std::numeric_limits<float>::infinity());
    names.miss_to = 85.f;
    io::load(frame, io::read_exr(folder / "packed.exr"), names);
    CHECK(frame[depth].get(3, 2) == std::numeric_limits<float>::infinity());
}
