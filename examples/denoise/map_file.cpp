#include <denoise/map_file.hpp>

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <fstream>
#include <initializer_list>
#include <iterator>

namespace quell::examples {

namespace {

using Json = nlohmann::json;

/// A member of the file together with the way to it, for messages.
struct Member {
    std::string file, path;
    Json const& value;

    [[noreturn]] void fail(std::string const& remedy) const {
        auto text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (text.size() > 60) text = text.substr(0, 57) + "...";
        throw Error(file, (path.empty() ? "it" : path) + " is " + text, remedy);
    }
    [[nodiscard]] Member at(std::string const& key) const { return {file, path.empty() ? key : path + "." + key, value.at(key)}; }
    [[nodiscard]] Member at(std::size_t i) const { return {file, path + "[" + std::to_string(i) + "]", value.at(i)}; }
    [[nodiscard]] bool has(char const* key) const { return value.contains(key); }
    [[nodiscard]] std::string text(std::string const& remedy) const {
        return value.is_string() ? value.get<std::string>() : (fail(remedy), "");
    }
    [[nodiscard]] float number() const { return value.is_number() ? value.get<float>() : (fail("write a number"), 0.f); }
};

void check_keys(Member const& object, std::initializer_list<char const*> known) {
    auto const list = fmt::format("{}", fmt::join(known, ", "));
    if (!object.value.is_object()) object.fail("write an object with any of: " + list);
    for (auto const& [key, value] : object.value.items())
        if (std::ranges::find(known, key) == known.end()) object.at(key).fail("there is no member of that name; write any of: " + list);
}

/// One name, or a list of them.
std::vector<std::string> names_in(Member const& from) {
    if (!from.value.is_array()) return {from.text("write a name or a list of names")};
    if (from.value.empty()) from.fail("write at least one name");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < from.value.size(); ++i) names.push_back(from.at(i).text("write a name"));
    return names;
}

/// {"from": ..., "scale": ...}, a name, or a number. Names have `suffix` appended.
io::Source source_in(Member const& member, std::string const& suffix) {
    io::Source source;
    if (member.value.is_number())
        source.scale = member.number();
    else if (member.value.is_object()) {
        check_keys(member, {"from", "scale"});
        if (!member.has("from")) member.fail("name the channel, {\"from\": \"name\", \"scale\": 1}");
        source.sum = names_in(member.at("from"));
        if (member.has("scale")) source.scale = member.at("scale").number();
    } else
        source.sum = {member.text("write a name, a number or {\"from\": \"name\", \"scale\": 1}")};
    for (auto& name : source.sum) name += name.empty() && !suffix.empty() ? suffix.substr(1) : suffix;
    return source;
}

std::vector<io::Source> sources_in(Member const& member, std::string_view channel, int components) {
    auto const count = static_cast<std::size_t>(components);
    std::vector<io::Source> sources;
    if (member.value.is_array()) {
        if (member.value.size() != count) member.fail("write a list of " + std::to_string(components) + ", one for each component");
        for (std::size_t c = 0; c < count; ++c) sources.push_back(source_in(member.at(c), ""));
    } else
        for (auto const& letter : io::detail::component_names(channel, components))
            sources.push_back(source_in(member, components == 1 ? "" : "." + letter));
    return sources;
}

/// What presets read that isn't in quell's own files always: how paths bend, how signals change by themselves, how they sweep, where things
/// go next, and what the renderer knows of its samples.
using MappedChannels =
    decltype(AllChannels{} |
             Channels<SweepBend, GradientOf<Radiance>, SweepOf<Visibility>, SweepOf<Glossy>, MotionNext, SampleCount, SampleVariance>{});

/// The number of components of the channel of that name; 0 where there is none.
int components_of_channel(std::string const& name) {
    int components = 0;
    for_each_channel(MappedChannels{}, [&]<class C>(C) {
        if (C::name == name) components = C::components;
    });
    return components;
}

void add_channel(Member const& object, std::string const& name, io::ChannelNames& names) {
    auto const components = components_of_channel(name);
    if (components == 0) object.at(name).fail("quell has no such channel; see the table of channels in docs/channels.md");
    names.sources[name] = sources_in(object.at(name), name, components);
}

/// One of several words.
template <class Choice>
Choice choice_in(Member const& object, char const* key, Choice otherwise, std::initializer_list<std::pair<char const*, Choice>> choices) {
    if (!object.has(key)) return otherwise;
    std::string list;
    for (auto const& [word, choice] : choices) {
        if (object.value.at(key) == word) return choice;
        list += (list.empty() ? "" : " or ") + std::string(word);
    }
    object.at(key).fail("write " + list);
}

MotionConvention motion_in(Member const& object) {
    using C = MotionConvention;
    check_keys(object, {"points", "unit", "y", "jitter"});
    C const own;
    return {choice_in(object, "points", own.points, {{"to_previous", C::Points::to_previous}, {"from_previous", C::Points::from_previous}}),
            choice_in(object, "unit", own.unit, {{"pixel", C::Unit::pixel}, {"uv", C::Unit::uv}, {"ndc", C::Unit::ndc}}),
            choice_in(object, "y", own.y, {{"down", C::Y::down}, {"up", C::Y::up}}),
            choice_in(object, "jitter", own.jitter, {{"left_out", C::Jitter::left_out}, {"left_in", C::Jitter::left_in}})};
}

io::DepthConvention depth_in(Member const& object) {
    using C = io::DepthConvention;
    check_keys(object, {"along", "vertical_field_of_view"});
    C depth{.along = choice_in(object, "along", C::Along::view_axis, {{"view_axis", C::Along::view_axis}, {"ray", C::Along::ray}})};
    if (!object.has("vertical_field_of_view")) return depth;
    auto const angle = object.at("vertical_field_of_view");
    depth.vertical_field_of_view = angle.number();
    if (!(depth.vertical_field_of_view > 0.f && depth.vertical_field_of_view < 180.f)) angle.fail("write degrees between 0 and 180");
    return depth;
}

/// What all signals have in common.
io::ChannelNames guides_in(Member const& map) {
    io::ChannelNames names;
    if (map.has("motion")) names.motion = motion_in(map.at("motion"));
    if (map.has("depth")) names.depth = depth_in(map.at("depth"));
    if (map.has("miss_from")) names.miss_from = map.at("miss_from").number();
    if (map.has("shutter")) {
        names.shutter = map.at("shutter").number();
        if (!(*names.shutter >= 0.f)) map.at("shutter").fail("write a part of the frame time, 0 or more");
    }
    if (!map.has("channels")) return names;
    auto const channels = map.at("channels");
    if (!channels.value.is_object()) channels.fail("write an object of quell's channel names");
    for (auto const& [name, value] : channels.value.items()) add_channel(channels, name, names);
    return names;
}

io::SignalNames signal_in(Member const& object, io::ChannelNames const& guides) {
    if (!object.value.is_object()) object.fail("write an object with \"radiance\" or \"irradiance\"");
    io::SignalNames signal{object.has("name") ? object.at("name").text("write a word") : object.path, guides};
    for (auto const& [name, value] : object.value.items())
        if (name != "name" && name != "irradiance") add_channel(object, name, signal.channels);
    if (!object.has("irradiance")) return signal;
    if (object.has("radiance")) object.fail("write \"radiance\" or \"irradiance\", not both");
    signal.channels.sources["radiance"] = sources_in(object.at("irradiance"), "radiance", 3);
    signal.factor = io::sources_of(signal.channels, albedo);
    signal.channels.sources["albedo"] = std::vector<io::Source>(3, io::Source{{}, 1.f});
    return signal;
}

/// Values are walked over by functions that call themselves, those of the library too.
constexpr int deepest = 16;

Json json_in(std::string const& text, std::string const& name) {
    auto const remedy = "see `quell-denoise --help` for an example";
    auto const check_depth = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest)
            throw Error(name, "lists and objects lie more than " + std::to_string(deepest) + " deep in each other", remedy);
        return true;
    };
    try {
        return Json::parse(text, check_depth, true, true);
    } catch (Json::exception const& why) {
        throw Error(name, std::string("it isn't JSON: ") + why.what(), remedy);
    }
}

constexpr auto name_a_layer = "write the name of a layer";

std::string text_of(std::filesystem::path const& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad() || std::filesystem::is_directory(path))
        throw Error(path.string(), "it can't be read", "give the path of a channel map in JSON");
    return text;
}

} // namespace

io::SequenceNames parse_map(std::string const& text, std::string const& name) {
    auto const json = json_in(text, name);
    Member const map{name, "", json};
    check_keys(map, {"channels", "motion", "depth", "miss_from", "shutter", "signals", "added", "picture"});
    auto const guides = guides_in(map);
    io::SequenceNames names{name};
    if (map.has("picture")) {
        auto const layer = map.at("picture").text(name_a_layer);
        for (auto const* const component : {"R", "G", "B"}) names.picture.push_back({{layer + (layer.empty() ? "" : ".") + component}});
    }
    if (map.has("added")) names.added = sources_in(map.at("added"), "radiance", 3);
    if (!map.has("signals")) {
        names.of_signals.push_back({"radiance", guides});
        return names;
    }
    auto const signals = map.at("signals");
    if (!signals.value.is_array() || signals.value.empty()) signals.fail("write a list of at least one signal");
    for (std::size_t i = 0; i < signals.value.size(); ++i) names.of_signals.push_back(signal_in(signals.at(i), guides));
    return names;
}

io::SequenceNames read_map(std::filesystem::path const& path) { return parse_map(text_of(path), path.string()); }

std::optional<std::string> read_picture_layer(std::filesystem::path const& path) {
    auto const json = json_in(text_of(path), path.string());
    Member const map{path.string(), "", json};
    if (!json.is_object() || !map.has("picture")) return std::nullopt;
    return map.at("picture").text(name_a_layer);
}

} // namespace quell::examples
