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

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// Source of a channel's component: `scale` times the sum of planes of a file, plus `offset`. Without planes, the constant `scale`. Normals
/// that a file holds as n * .5 + .5 have the scale 2 and the offset -1.
struct Source {
    std::vector<std::string> sum; ///< names of planes
    float scale = 1.f;            ///< factor or constant
    float offset = 0.f;           ///< in the channel's own unit
};

/// What the depth of a file measures.
struct DepthConvention {
    /// The direction in which distance is measured.
    enum class Along { view_axis, ray };
    Along along = Along::view_axis; ///< ray: distance from the camera to the surface
    /// Degrees, above 0 and below 180, for `ray` in files without a camera; 0: not known.
    float vertical_field_of_view = 0.f;
};

/// Names and conventions of another renderer's files. By default quell's own: `R`, `albedo.R`, `normal.X`, `depth.Z`. For a depth called Z
/// and motion with y up:
///
///     ChannelNames{.sources = {{"depth", {{{"Z"}}}}}, .motion = {.y = MotionConvention::Y::up}}
struct ChannelNames {
    std::map<std::string, std::vector<Source>, std::less<>> sources = {}; ///< by quell's name of the channel: one source per component
    MotionConvention motion = {};                                         ///< of motion and motion_next
    DepthConvention depth = {};                                           ///< of depth
    float miss_from = std::numeric_limits<float>::infinity();             ///< a depth of at least this is a miss
    float miss_to = -std::numeric_limits<float>::infinity();              ///< and so is one of at most this
    std::optional<float> shutter = {};                                    ///< in place of the files' shutter: fraction of the frame time
};

namespace detail {
/// Names of a channel's components in quell's own files, without the layer.
template <ChannelTag C> std::vector<std::string> component_names(C) {
    std::string_view const all = C::component_names;
    std::vector<std::string> names;
    for (int c = 0; c < C::components; ++c)
        names.push_back(C::components == 1  ? std::string(all)
                        : C::components > 4 ? std::to_string(c)
                                            : std::string(1, all[static_cast<std::size_t>(c)]));
    return names;
}
} // namespace detail

/// Names of a channel's components in quell's own files. The picture has no layer: R, G, B, A.
template <ChannelTag C> [[nodiscard]] std::vector<std::string> own_names(C channel) {
    auto names = detail::component_names(channel);
    if constexpr (!std::is_same_v<C, Radiance> && !std::is_same_v<C, RadianceAlpha>)
        for (auto& each : names) each.insert(0, std::string(channel.name).append("."));
    return names;
}

/// Sources of a channel's components.
/// @throws Error where `names` has another number of them
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

/// The planes that these sources use, each once.
[[nodiscard]] inline std::vector<std::string> planes_of(std::vector<Source> const& sources) {
    std::vector<std::string> planes;
    for (auto const& source : sources) planes.insert(planes.end(), source.sum.begin(), source.sum.end());
    return planes;
}
/// The planes that a frame of these channels uses.
template <class... Cs> [[nodiscard]] std::vector<std::string> planes_of(Channels<Cs...> set, ChannelNames const& names) {
    std::vector<std::string> planes;
    for_each_channel(set, [&](auto channel) {
        auto const more = planes_of(sources_of(names, channel));
        planes.insert(planes.end(), more.begin(), more.end());
    });
    return planes;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
