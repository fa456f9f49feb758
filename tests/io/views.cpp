#include "whole_file.hpp"

#include <quell/io/file_views.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

io::ExrListing listing(std::vector<std::string> const& names, std::vector<std::string> const& eyes = {}) {
    io::ExrListing file{.name = "file", .size = {4, 3}};
    file.eyes = eyes;
    for (auto const& name : names) file.channels.push_back({.name = name, .in_part = name});
    return file;
}
/// A picture R with a depth Z is a view.
std::optional<io::SequenceNames> with_depth(io::ExrListing const& file) {
    if (!file.has_all({"R", "Z"})) return std::nullopt;
    io::SequenceNames names{"test", {{"radiance"}}};
    names.of_signals[0].channels.sources["radiance"] = {{{"R"}}, {{"R"}}, {{"R"}}};
    names.of_signals[0].channels.sources["depth"] = {{{"Z"}}};
    return names;
}
std::vector<std::string> names_of(io::FileViews const& found) {
    std::vector<std::string> names;
    for (auto const& view : found.views) names.push_back(view.names.view);
    return names;
}
std::string depth_of(io::FileView const& view, io::ExrListing const& file) {
    return io::names_in_file(view, file, Channels<>{}).of_signals[0].channels.sources.at("depth")[0].sum[0];
}

} // namespace

TEST_CASE("eyes are a component of channels' names, or have none where another has") {
    auto const both = listing({"left.R", "left.Z", "right.R", "right.Z"});
    auto const of_both = io::views_of(both, with_depth);
    CHECK(names_of(of_both) == std::vector<std::string>{"left", "right"});
    CHECK(depth_of(of_both.views[1], both) == "right.Z");

    auto const one = listing({"R", "Z", "left.R", "left.Z"});
    auto const of_one = io::views_of(one, with_depth);
    CHECK(names_of(of_one) == std::vector<std::string>{"right", "left"});
    CHECK(depth_of(of_one.views[0], one) == "Z");

    auto const listed = listing({"R", "Z", "b.R", "b.Z", "c.R"}, {"a", "b", "c"});
    auto const of_listed = io::views_of(listed, with_depth);
    CHECK(names_of(of_listed) == std::vector<std::string>{"a", "b"});
    CHECK(of_listed.left == std::vector<std::string>{"c"});
}

TEST_CASE("an eye's guides are its own, and what it lacks goes by the name that it would have") {
    auto const shared = listing({"left.R", "right.R", "Z"});
    CHECK(io::views_of(shared, with_depth).views.empty());

    auto const file = listing({"left.R", "left.Z", "right.R", "right.Z", "motion_next.X"});
    auto const names = io::names_in_file(io::views_of(file, with_depth).views[1], file, Channels<MotionNext>{});
    CHECK(names.of_signals[0].channels.sources.at("motion_next")[0].sum[0] == "motion_next.right.X");
}

TEST_CASE("parts are views where several are whole by themselves") {
    auto file = listing({"R", "Z"});
    for (auto& channel : file.channels) channel.part_name = "near";
    CHECK(names_of(io::views_of(file, with_depth)) == std::vector<std::string>{""});
    for (std::string const name : {"R", "Z"})
        file.channels.push_back({.name = "far." + name, .in_part = name, .part = 1, .part_name = "far"});
    auto const found = io::views_of(file, with_depth);
    CHECK(names_of(found) == std::vector<std::string>{"near", "far"});
    CHECK(depth_of(found.views[0], file) == "near.Z");
    CHECK(depth_of(found.views[1], file) == "far.Z");
}

TEST_CASE("a layer's name may begin as another's, and eyes have layers") {
    std::vector<std::string> names;
    for (std::string const layer : {"FG", "FG.001"})
        for (std::string const eye : {"left", "right"})
            for (std::string const pass : {".Combined.", ".Depth."})
                names.push_back(layer + pass + eye + (pass == ".Depth." ? ".Z" : ".R"));
    auto const any_layer = [](io::ExrListing const& file) -> std::optional<io::SequenceNames> {
        auto const prefixes = io::detail::view_layer_prefixes(file.channels);
        if (prefixes.size() != 1 || file.channels.size() != 2) return std::nullopt;
        return io::SequenceNames{"test", {{"radiance"}}};
    };
    CHECK(names_of(io::views_of(listing(names), any_layer)) ==
          std::vector<std::string>{"left, FG", "left, FG.001", "right, FG", "right, FG.001"});
}

TEST_CASE("a picture without a layer goes before those of layers") {
    auto const file = listing({"R", "Z", "ViewLayer.Combined.R", "ViewLayer.Depth.Z"});
    auto const found = io::views_of(file, with_depth);
    REQUIRE(found.views.size() == 1);
    CHECK(found.views[0].listing.channels.size() == file.channels.size());
    CHECK(found.left.empty());
}

TEST_CASE("a file's attribute names its eyes") {
    Folder const folder;
    auto const window = box(0, 0, 3, 2);
    WholePart part{"", window, {{"R", Imf::HALF, [](int, int) { return 1.f; }}}};
    part.eyes = {"left", "right"};
    write_whole(folder / "file.exr", window, {part});
    CHECK(io::ExrFile(folder / "file.exr").eyes == std::vector<std::string>{"left", "right"});
}
