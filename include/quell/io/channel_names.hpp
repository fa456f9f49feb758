#pragma once

#include <quell/core/error.hpp>
#include <quell/frame/channels.hpp>
#include <quell/frame/motion_convention.hpp>

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quell::io {

/// Where one component of a channel comes from: `scale` times the sum of these planes of a file; without planes, `scale` itself everywhere.
struct Source {
    std::vector<std::string> sum;
    float scale = 1.f;
};

/// How another renderer calls and counts what quell's channels hold. Empty, it stands for quell's own names: `R`, `albedo.R`,
/// `normal.X`, `depth.Z`. For a depth called Z in a file and motion whose y points up:
///     ChannelNames{.sources = {{"depth", {{{"Z"}}}}}, .motion = {.y = MotionConvention::Y::up}}
struct ChannelNames {
    std::map<std::string, std::vector<Source>, std::less<>> sources = {}; ///< by quell's name, a source per component
    MotionConvention motion = {};
    float miss_from = std::numeric_limits<float>::infinity(); ///< a depth of this or more is a miss
    std::optional<float> shutter = {};                        ///< of all frames, whatever the files say
};

namespace detail {
/// The components' names in quell's own files, for channels of its own and of a host.
inline std::vector<std::string> component_names(std::string_view channel, int components) {
    static std::map<std::string, std::string, std::less<>> const letters{{"radiance", "RGB"}, {"albedo", "RGB"},   {"direct", "RGB"},
                                                                         {"glossy", "RGB"},   {"indirect", "RGB"}, {"roughness", "R"},
                                                                         {"depth", "Z"},      {"visibility", "V"}, {"time", "T"}};
    if (channel == "instance") return {"ID"};
    auto const found = letters.find(channel);
    std::string const all = found != letters.end() ? found->second : components == 1 ? "V" : "XYZW";
    std::vector<std::string> names;
    for (int c = 0; c < components; ++c)
        names.push_back(components > 4 ? std::to_string(c) : std::string(1, all[static_cast<std::size_t>(c)]));
    return names;
}
} // namespace detail

/// What quell's own files call the components of a channel. The image itself has no layer.
template <ChannelTag C> [[nodiscard]] std::vector<std::string> own_names(C channel) {
    auto names = detail::component_names(channel.name, C::components);
    if (std::string_view(channel.name) != radiance.name)
        for (auto& each : names) each.insert(0, std::string(channel.name).append("."));
    return names;
}

/// Where a channel's components come from.
/// @throws Error where the names hold another number of them
template <ChannelTag C> [[nodiscard]] std::vector<Source> sources_of(ChannelNames const& names, C channel) {
    if (auto const found = names.sources.find(channel.name); found != names.sources.end()) {
        if (found->second.size() == static_cast<std::size_t>(C::components)) return found->second;
        throw Error("channel map: '" + std::string(channel.name) + "'", std::to_string(found->second.size()) + " components",
                    "name " + std::to_string(C::components));
    }
    std::vector<Source> sources;
    for (auto const& each : own_names(channel)) sources.push_back({{each}});
    return sources;
}

/// The planes of a file that these sources use, each once.
[[nodiscard]] inline std::vector<std::string> planes_of(std::vector<Source> const& sources) {
    std::vector<std::string> planes;
    for (auto const& source : sources) planes.insert(planes.end(), source.sum.begin(), source.sum.end());
    return planes;
}
/// Those that a frame of these channels uses.
template <class... Cs> [[nodiscard]] std::vector<std::string> planes_of(Channels<Cs...> set, ChannelNames const& names) {
    std::vector<std::string> planes;
    for_each_channel(set, [&](auto channel) {
        auto const more = planes_of(sources_of(names, channel));
        planes.insert(planes.end(), more.begin(), more.end());
    });
    return planes;
}

} // namespace quell::io
