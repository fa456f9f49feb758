#include <denoise/map_file.hpp>
#include <denoise/renderer_maps.hpp>

#include <quell/io/part_names.hpp>

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>

namespace quell::examples {

namespace {

using Json = nlohmann::json;

/// A member of the file together with the way to it, for messages.
struct Member {
    std::string file, path;
    Json const& value;
    io::ExrListing const* frame; ///< that the names are for, which decides between several; may be null

    [[noreturn]] void fail(std::string const& remedy) const {
        auto text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (text.size() > 60) text = text.substr(0, 57) + "...";
        throw Error(file, (path.empty() ? "it" : path) + " is " + text, remedy);
    }
    [[nodiscard]] Member at(std::string const& key) const { return {file, path.empty() ? key : path + "." + key, value.at(key), frame}; }
    [[nodiscard]] Member at(std::size_t i) const { return {file, path + "[" + std::to_string(i) + "]", value.at(i), frame}; }
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

/// A name that begins with "*." is of the file's view layer, as Blender writes them: whatever that is called.
std::string in_view_layer(std::string const& name, io::ExrListing const* frame) {
    if (!name.starts_with("*.")) return name;
    return (frame ? io::detail::view_layer_prefix(frame->channels).value_or("") : "") + name.substr(2);
}

/// Letters that renderers have for a layer's component.
std::vector<std::string> letters_of(std::size_t index) {
    static std::vector<std::vector<std::string>> const letters{{"R", "r", "X", "x", "red", "Z", "z", "T", "V", "Y", "y"},
                                                               {"G", "g", "Y", "y", "green"},
                                                               {"B", "b", "Z", "z", "blue"},
                                                               {"A", "a", "W", "w"}};
    return index < letters.size() ? letters[index] : std::vector<std::string>();
}

/// One name, or a list of them.
std::vector<std::string> names_in(Member const& from) {
    if (!from.value.is_array()) return {from.text("write a name or a list of names")};
    if (from.value.empty()) from.fail("write at least one name");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < from.value.size(); ++i) names.push_back(from.at(i).text("write a name"));
    return names;
}

/// A component of a layer: its place among the others, and its letter, which is empty where the layer's name is all of the plane's.
struct Component {
    std::size_t index = 0;
    std::string letter = {};
    bool is_whole_name = false; ///< the map names the plane itself
};

/// The plane of a layer's component: by quell's own letter, or by another that the frame has.
std::string plane_in(std::string layer, Component const& component, io::ExrListing const* frame) {
    layer = in_view_layer(layer, frame);
    auto const with = [&](std::string const& letter) { return letter.empty() || layer.empty() ? layer + letter : layer + "." + letter; };
    auto const own = with(component.letter);
    if (!frame || component.is_whole_name || frame->find(own)) return own;
    for (auto const& letter : letters_of(component.index))
        if (frame->find(with(letter))) return with(letter);
    return own;
}

/// {"from": ..., "scale": ..., "offset": ...}, a name, or a number.
io::Source source_in(Member const& member, Component const& component) {
    io::Source source;
    if (member.value.is_number())
        source.scale = member.number();
    else if (member.value.is_object()) {
        check_keys(member, {"from", "scale", "offset"});
        if (!member.has("from")) member.fail("name the channel, {\"from\": \"name\", \"scale\": 1, \"offset\": 0}");
        source.sum = names_in(member.at("from"));
        if (member.has("scale")) source.scale = member.at("scale").number();
        if (member.has("offset")) source.offset = member.at("offset").number();
    } else
        source.sum = {member.text("write a name, a number or {\"from\": \"name\", \"scale\": 1, \"offset\": 0}")};
    for (auto& name : source.sum) name = plane_in(name, component, member.frame);
    return source;
}

std::vector<io::Source> sources_in(Member const& member, std::vector<std::string> const& components);

/// The first of several that the frame has; without a frame, the first.
std::vector<io::Source> first_of(Member const& member, std::vector<std::string> const& components) {
    check_keys(member, {"first_of"});
    auto const choices = member.at("first_of");
    if (!choices.value.is_array() || choices.value.empty()) choices.fail("write a list of at least one of what may stand in its place");
    auto const choice = [&](std::size_t i) { return sources_in(choices.at(i), components); };
    for (std::size_t i = 0; i < choices.value.size(); ++i)
        if (auto const sources = choice(i); !member.frame || member.frame->has_all(io::planes_of(sources))) return sources;
    return choice(0); // reading it says what it lacks
}

/// @param components the names of the channel's components
std::vector<io::Source> sources_in(Member const& member, std::vector<std::string> const& components) {
    if (member.value.is_object() && member.has("first_of")) return first_of(member, components);
    auto const count = components.size();
    std::vector<io::Source> sources;
    if (member.value.is_array()) {
        if (member.value.size() != count) member.fail("write a list of " + std::to_string(count) + ", one for each component");
        for (std::size_t c = 0; c < count; ++c) sources.push_back(source_in(member.at(c), {c, "", true}));
    } else
        for (auto const& name : components) sources.push_back(source_in(member, {sources.size(), count == 1 ? "" : name}));
    return sources;
}

/// The names of the components of the channel of that name; none where there is no such channel.
std::vector<std::string> components_of_channel(std::string const& name) {
    std::vector<std::string> components;
    for_each_channel(AllChannels{}, [&](auto channel) {
        if (channel.name == name) components = io::detail::component_names(channel);
    });
    return components;
}

void add_channel(Member const& object, std::string const& name, io::ChannelNames& names) {
    auto const components = components_of_channel(name);
    if (components.empty()) object.at(name).fail("quell has no such channel; see the table of channels in docs/channels.md");
    names.sources[name] = sources_in(object.at(name), components);
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
    if (map.has("miss_to")) names.miss_to = map.at("miss_to").number();
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
    signal.channels.sources["radiance"] = sources_in(object.at("irradiance"), io::detail::component_names(radiance));
    signal.factor = io::sources_of(signal.channels, albedo);
    auto const is_one = [](io::Source const& source) { return source.sum.empty() && source.scale == 1.f; };
    if (std::ranges::all_of(signal.factor, is_one)) signal.factor.clear(); // there is none
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

/// A file's text, or that of a renderer's map. A file comes first.
std::string text_of(std::string const& map) {
    auto const remedy = "give the path of a channel map in JSON, or one of: " + names_of_renderers();
    if (auto const* const of_renderer = find_renderer_map(map); of_renderer && !std::filesystem::exists(map))
        return std::string(*of_renderer);
    std::ifstream file(map, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad() || std::filesystem::is_directory(map)) throw Error(map, "it can't be read", remedy);
    return text;
}

/// What the user should know of a guide that there is none of.
std::string without(std::string const& guide) {
    if (guide == motion.name)
        return "without motion vectors: history is right only where neither the camera nor anything moves (--preset atrous has none)";
    if (guide == albedo.name) return "without albedo: textures are filtered as light is";
    return "without " + guide;
}

/// What a renderer's files don't have, or do not say: one line, empty where they have all.
std::string remark_in(Member const& map, io::SequenceNames const& names) {
    std::vector<std::string> parts;
    auto const& sources = names.of_signals.front().channels.sources;
    for (std::string const guide : {motion.name, albedo.name, normal.name, depth.name}) {
        auto const found = sources.find(guide);
        if (found == sources.end() || !io::planes_of(found->second).empty()) continue;
        bool const has_reason = map.has("lacks") && map.at("lacks").has(guide.c_str());
        parts.push_back(without(guide) + (has_reason ? ": " + map.at("lacks").at(guide).text("write a sentence") : ""));
    }
    if (map.has("remark")) parts.push_back(map.at("remark").text("write a sentence"));
    return fmt::format("{}", fmt::join(parts, "; "));
}

/// Whether a frame has all layers of one of several lists.
bool is_recognised(Member const& lists, io::ExrListing const& frame) {
    auto const has = [&](std::string const& layer) {
        return std::ranges::any_of(std::array{0, 1, 2},
                                   [&](int c) { return frame.find(plane_in(layer, {static_cast<std::size_t>(c)}, &frame)) != nullptr; });
    };
    for (std::size_t i = 0; i < lists.value.size(); ++i)
        if (std::ranges::all_of(names_in(lists.at(i)), has)) return true;
    return false;
}

} // namespace

io::SequenceNames parse_map(std::string const& text, std::string const& name, io::ExrListing const* frame) {
    auto const json = json_in(text, name);
    Member const map{name, "", json, frame};
    check_keys(map, {"channels", "motion", "depth", "miss_from", "miss_to", "shutter", "signals", "added", "picture", "renderer", "source",
                     "recognised_by", "lacks", "remark"});
    auto const guides = guides_in(map);
    io::SequenceNames names{map.has("renderer") ? map.at("renderer").text("write its name") : name};
    if (map.has("picture")) {
        auto const layer = map.at("picture").text(name_a_layer);
        for (auto const* const component : {"R", "G", "B"}) names.picture.push_back({{layer + (layer.empty() ? "" : ".") + component}});
    }
    if (map.has("added")) names.added = sources_in(map.at("added"), io::detail::component_names(radiance));
    if (map.has("signals")) {
        auto const signals = map.at("signals");
        if (!signals.value.is_array() || signals.value.empty()) signals.fail("write a list of at least one signal");
        for (std::size_t i = 0; i < signals.value.size(); ++i) names.of_signals.push_back(signal_in(signals.at(i), guides));
    } else
        names.of_signals.push_back({"radiance", guides});
    if (map.has("renderer"))
        if (auto const remark = remark_in(map, names); !remark.empty()) names.remarks.push_back(names.renderer + ": " + remark);
    return frame ? io::names_in_parts(names, *frame) : names;
}

io::SequenceNames read_map(std::string const& map, io::ExrListing const* frame) { return parse_map(text_of(map), map, frame); }

namespace {

io::SequenceNames recognised_as_one(io::ExrListing const& frame) {
    for (auto const& [name, text] : renderer_maps()) {
        auto const json = json_in(std::string(text), std::string(name));
        Member const map{std::string(name), "", json, &frame};
        if (map.has("recognised_by") && is_recognised(map.at("recognised_by"), frame))
            return parse_map(std::string(text), std::string(name), &frame);
    }
    return io::names_in_parts(io::recognise(frame), frame);
}

/// Whether a frame has light, depth and motion.
bool is_view(io::ExrListing const& frame, io::SequenceNames const& names) {
    auto const has = [&](auto channel, io::SignalNames const& signal) {
        return frame.has_all(io::planes_of(io::sources_of(signal.channels, channel)));
    };
    bool has_light = std::ranges::all_of(names.of_signals, [&](auto const& signal) { return has(radiance, signal); });
    if (names.of_signals.size() == 1) // a sequence traced for single effects has other light
        for_each_channel(Channels<Direct, Visibility, Glossy, Indirect>{},
                         [&](auto channel) { has_light = has_light || has(channel, names.of_signals[0]); });
    return has_light && has(depth, names.of_signals[0]) && has(motion, names.of_signals[0]);
}

} // namespace

io::FileViews views_in(io::ExrListing const& frame, std::string const& map) {
    auto const text = map.empty() ? std::string() : text_of(map);
    return io::views_of(frame, [&](io::ExrListing const& view) -> std::optional<io::SequenceNames> {
        try {
            auto const names = map.empty() ? recognised_as_one(view) : parse_map(text, map, &view);
            return is_view(view, names) ? std::optional(names) : std::nullopt;
        } catch (Error const&) {
            return std::nullopt; // whoever takes the whole frame complains
        }
    });
}

io::SequenceNames names_in_file(io::FileView const& view, io::ExrListing const& frame) {
    return io::names_in_file(view, frame, AllChannels{});
}

io::SequenceNames recognised(io::ExrListing const& frame) {
    auto const views = views_in(frame);
    return views.views.empty() ? recognised_as_one(frame) : names_in_file(views.views[0], frame);
}

} // namespace quell::examples
