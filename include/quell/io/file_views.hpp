#pragma once

#include <quell/io/part_names.hpp>

#include <functional>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// One of the pictures of a file that has several: a view layer, a stereo view or a part, with guides of its own.
struct FileView {
    ExrListing listing;       ///< its channels alone, without the stereo view in their names
    SequenceNames names = {}; ///< how these make it up
    std::string eye = {};     ///< the component that its names in the file have before the last: left in left.R; may be empty
};

/// The views of a file, and what else has light but can't be denoised by itself.
struct FileViews {
    std::vector<FileView> views;   ///< each with light, depth and motion
    std::vector<std::string> left; ///< names of what stays as it is
};

/// How a view's channels make up its picture; nothing where its light, its depth or its motion is not there.
using RecognisesView = std::function<std::optional<SequenceNames>(ExrListing const&)>;

namespace detail {

/// The component before the last: left in ViewLayer.Combined.left.R. Empty where there is none.
inline std::string eye_in_name(std::string_view channel) {
    auto const last = channel.rfind('.');
    if (last == std::string_view::npos) return {};
    auto const rest = channel.substr(0, last);
    return std::string(rest.substr(rest.rfind('.') + 1)); // npos + 1 is 0
}
inline std::string without_eye(std::string name, std::string const& eye) {
    auto const last = name.rfind('.');
    return name.erase(last - eye.size(), eye.size() + 1);
}
inline std::string with_eye(std::string const& name, std::string const& eye) {
    if (eye.empty()) return name;
    auto const last = name.rfind('.');
    return last == std::string::npos ? eye + "." + name : name.substr(0, last + 1) + eye + "." + name.substr(last + 1);
}

/// Stereo views, the default one first. What has no view in its name, nor in its part, is the default one's.
struct Eyes {
    std::vector<std::string> names;
    std::string otherwise = {}; ///< the default one; empty: there is none

    explicit Eyes(ExrListing const& file) : names(file.eyes), otherwise(file.eyes.empty() ? "" : file.eyes[0]) {
        auto const add = [&](std::string const& eye) {
            if (!eye.empty() && std::ranges::find(names, eye) == names.end()) names.push_back(eye);
        };
        if (file.eyes.empty())
            for (auto const& channel : file.channels) add(channel.view);
        if (!names.empty()) return;
        for (std::string const eye : {"left", "right"})
            if (std::ranges::any_of(file.channels, [&](auto const& c) { return eye_in_name(c.in_part) == eye; })) add(eye);
        if (names.size() != 1) return;
        otherwise = names[0] == "left" ? "right" : "left";
        names.insert(names.begin(), otherwise);
    }
    [[nodiscard]] bool has_in_name(ExrChannel const& channel) const {
        return std::ranges::find(names, eye_in_name(channel.in_part)) != names.end();
    }
    [[nodiscard]] std::string of(ExrChannel const& channel) const {
        if (has_in_name(channel)) return eye_in_name(channel.in_part);
        return channel.view.empty() ? otherwise : channel.view;
    }
};

/// Some channels of a listing by other names: each name once, by the part's before it where an earlier one has it.
inline ExrListing some_of(ExrListing const& all, std::function<std::optional<std::string>(ExrChannel const&)> const& name_of) {
    ExrListing some{all.name, all.size, {}, all.attributes, {}};
    for (auto channel : all.channels) {
        auto const name = name_of(channel);
        if (!name) continue;
        bool const taken = std::ranges::any_of(some.channels, [&](auto const& c) { return c.name == *name; });
        channel.name = taken ? channel.part_name + "." + *name : *name;
        some.channels.push_back(channel);
    }
    return some;
}

/// Finds views: eyes, in each of them parts, and in each of these view layers.
class ViewFinder {
    RecognisesView const& recognise_view;

public:
    explicit ViewFinder(RecognisesView const& r) : recognise_view(r) {}

    [[nodiscard]] FileViews eyes_of(FileView const& whole) const {
        Eyes const eyes(whole.listing);
        FileViews found;
        for (auto const& eye : eyes.names) {
            FileView view{some_of(whole.listing, [&](auto const& c) -> std::optional<std::string> {
                if (eyes.of(c) != eye) return std::nullopt;
                return eyes.has_in_name(c) ? without_eye(c.in_part, eye) : c.in_part;
            })};
            bool const in_name = std::ranges::any_of(view.listing.channels, [&](auto const& c) { return eyes.has_in_name(c); });
            view.eye = in_name ? eye : "";
            add(found, parts_of(view), eye, eye);
        }
        return found.views.empty() || eyes.names.size() < 2 ? parts_of(whole) : found;
    }

private:
    [[nodiscard]] FileViews parts_of(FileView const& whole) const {
        std::vector<std::string> names;
        for (auto const& c : whole.listing.channels)
            if (std::ranges::find(names, c.part_name) == names.end()) names.push_back(c.part_name);
        FileViews found;
        std::size_t complete = 0;
        for (auto const& part : names) {
            FileView view{some_of(whole.listing, [&](auto const& c) {
                bool const has_eye = !whole.eye.empty() && eye_in_name(c.in_part) == whole.eye;
                return c.part_name != part ? std::nullopt : std::optional(has_eye ? without_eye(c.in_part, whole.eye) : c.in_part);
            })};
            view.eye = whole.eye;
            auto const layers = layers_of(view);
            if (!layers.views.empty()) ++complete;
            bool const has_picture = view.listing.has_all({"R", "G", "B"});
            add(found, layers, part, has_picture ? part : "");
        }
        return complete < 2 ? layers_of(whole) : found;
    }

    [[nodiscard]] FileViews layers_of(FileView const& whole) const {
        auto const prefixes = view_layer_prefixes(whole.listing.channels);
        auto const layer_of = [&](ExrChannel const& channel) { // names of layers may have dots
            std::string longest;
            for (auto const& prefix : prefixes)
                if (channel.name.starts_with(prefix) && prefix.size() > longest.size()) longest = prefix;
            return longest;
        };
        auto const only = [&](std::string const& prefix) {
            auto view = whole;
            view.listing =
                some_of(whole.listing, [&](auto const& c) { return layer_of(c) == prefix ? std::optional(c.name) : std::nullopt; });
            return leaf(view);
        };
        if (!only("").views.empty()) return leaf(whole); // a picture without a layer goes before those of layers
        FileViews found;
        std::string own_layer; // by recognition
        for (auto const& prefix : prefixes) {
            auto alone = only(prefix);
            auto const name = prefix.substr(0, prefix.size() - 1);
            for (auto& each : alone.views) own_layer = std::exchange(each.names.layer, prefix);
            add(found, alone, name, name);
        }
        if (found.views.size() == 1) found.views[0].names.view.clear(), found.views[0].names.layer = own_layer;
        return found.views.empty() ? leaf(whole) : found;
    }

    [[nodiscard]] FileViews leaf(FileView view) const {
        auto const names = recognise_view(view.listing);
        if (!names) return {};
        view.names = *names;
        return {{view}, {}};
    }

    /// @param left what to call it where it has no view
    static void add(FileViews& all, FileViews const& more, std::string const& name, std::string const& left) {
        auto const joined = [&](std::string const& inner) { return inner.empty() ? name : name + ", " + inner; };
        for (auto view : more.views) {
            view.names.view = joined(view.names.view);
            all.views.push_back(view);
        }
        for (auto const& inner : more.left) all.left.push_back(joined(inner));
        if (more.views.empty() && !left.empty()) all.left.push_back(left);
    }
};

inline bool has_several_parts(ExrListing const& file) { return file.channels.front().part != file.channels.back().part; }

/// The name of a view's plane in its file. One that the file lacks is called what it would be there.
inline std::string name_in_file(std::string const& plane, FileView const& view, ExrListing const& file) {
    auto const* const channel = view.listing.find(plane);
    auto const in_part = channel ? channel->in_part : with_eye(plane, view.eye);
    if (!has_several_parts(file)) return in_part;
    return (channel ? *channel : view.listing.channels.front()).part_name + "." + in_part;
}

} // namespace detail

/// The views of a file, each of which is denoised by itself: Blender's view layers; stereo views, which are a component of channels' names
/// (left.R, ViewLayer.Combined.left.R), those of the attribute multiView, or a part's attribute view; and parts that are whole by
/// themselves. None where none is whole.
[[nodiscard]] inline FileViews views_of(ExrListing const& file, RecognisesView const& recognise_view) {
    auto found = detail::ViewFinder(recognise_view).eyes_of({file});
    if (found.views.size() == 1) found.views[0].names.view.clear();
    return found;
}

/// The names by which the file has what a view's names say.
/// @param view whose names are translated
/// @param file that it is of
/// @param set  the channels that are read, also those that go by quell's own names
template <class Set> [[nodiscard]] SequenceNames names_in_file(FileView const& view, ExrListing const& file, Set set) {
    auto names = view.names;
    if (view.listing.channels.size() == file.channels.size()) return names;
    auto const translate = [&](std::vector<Source>& sources) {
        for (auto& source : sources)
            for (auto& plane : source.sum) plane = detail::name_in_file(plane, view, file);
    };
    for (auto& signal : names.of_signals) {
        for_each_channel(set, [&](auto channel) { signal.channels.sources.emplace(channel.name, sources_of(signal.channels, channel)); });
        for (auto& [channel, sources] : signal.channels.sources) translate(sources);
        translate(signal.factor);
    }
    translate(names.added), translate(names.picture);
    names.eye = view.eye;
    return names;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
