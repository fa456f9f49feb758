#pragma once

#include <quell/io/channel_names.hpp>
#include <quell/io/exr_listing.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::io::detail {

/// A pass of Blender by its names in files. The first one stands for it here.
struct BlenderPass {
    /// In Blender 2.8 to 4, in 5 and newer, and in files of the compositor's node File Output where that calls it otherwise.
    std::array<std::string_view, 3> names;
    /// What its only component is called: by the render output, and by the node. Empty: it has several.
    std::array<std::string_view, 2> only = {};
    bool is_light = false; ///< whether it holds light that was scattered
};

inline constexpr BlenderPass blender_passes[] = {
    {{"Combined", "Combined", "Image"}},
    {{"Depth"}, {"Z", "V"}},
    {{"Vector"}},
    {{"Normal"}},
    {{"Position"}},
    {{"IndexOB", "Object Index"}, {"X", "V"}},
    {{"Emit", "Emission"}},
    {{"Env", "Environment"}},
    {{"DiffDir", "Diffuse Direct"}, {}, true},
    {{"DiffInd", "Diffuse Indirect"}, {}, true},
    {{"DiffCol", "Diffuse Color"}},
    {{"GlossDir", "Glossy Direct"}, {}, true},
    {{"GlossInd", "Glossy Indirect"}, {}, true},
    {{"GlossCol", "Glossy Color"}},
    {{"TransDir", "Transmission Direct"}, {}, true},
    {{"TransInd", "Transmission Indirect"}, {}, true},
    {{"TransCol", "Transmission Color"}},
    {{"SubsurfaceDir", "Subsurface Direct"}, {}, true},
    {{"SubsurfaceInd", "Subsurface Indirect"}, {}, true},
    {{"SubsurfaceCol", "Subsurface Color"}},
    {{"VolumeDir", "Volume Direct"}, {}, true},
    {{"VolumeInd", "Volume Indirect"}, {}, true},
    {{"VolumeCol", "Volume Color"}},
    {{"Denoising Albedo"}},
};

inline BlenderPass const& blender_pass(std::string_view name) {
    return *std::ranges::find(blender_passes, name, [](auto const& pass) { return pass.names[0]; });
}

/// A view layer of Blender, by the names of its passes.
struct ViewLayer {
    std::vector<ExrChannel> const& channels;
    std::string prefix; ///< its name and a dot; empty in files of the node File Output

    /// The channel of a pass's component; null if there is none.
    [[nodiscard]] ExrChannel const* find(std::string_view pass, std::string_view component) const {
        auto const& known = blender_pass(pass);
        auto const letters = known.only[0].empty() ? std::array{component, std::string_view()} : known.only;
        for (auto const name : known.names)
            for (auto const letter : letters) {
                if (name.empty() || letter.empty()) continue;
                auto const wanted = prefix + std::string(name) + "." + std::string(letter);
                auto const found = std::ranges::find(channels, wanted, &ExrChannel::name);
                if (found != channels.end()) return &*found;
            }
        return nullptr;
    }
    [[nodiscard]] bool has(std::string_view pass, std::string_view component) const { return find(pass, component) != nullptr; }
    /// What a component is called; of a pass that there is none of, what the render output of Blender 2.8 to 4 would call it.
    [[nodiscard]] std::string name_of(std::string_view pass, std::string_view component) const {
        auto const* const channel = find(pass, component);
        return channel ? channel->name : prefix + std::string(pass) + "." + std::string(component);
    }
    /// Sum of those of these passes that exist, per component; empty if a component has none.
    [[nodiscard]] std::vector<Source> sum_of(std::vector<std::string> const& passes) const {
        std::vector<Source> sources;
        for (std::string_view const component : {"R", "G", "B"}) {
            Source source;
            for (auto const& pass : passes)
                if (has(pass, component)) source.sum.push_back(name_of(pass, component));
            if (!source.sum.empty()) sources.push_back(source);
        }
        return sources.size() == 3 ? sources : std::vector<Source>();
    }
    [[nodiscard]] std::vector<Source> components_of(std::string_view pass, std::string_view letters) const {
        std::vector<Source> sources;
        for (std::size_t i = 0; i < letters.size(); ++i) sources.push_back({{name_of(pass, letters.substr(i, 1))}});
        return sources;
    }
    /// Whether it has a picture or light, and depth.
    [[nodiscard]] bool is_one() const {
        bool const has_light =
            std::ranges::any_of(blender_passes, [&](auto const& pass) { return pass.is_light && has(pass.names[0], "R"); });
        return (has_light || has("Combined", "R")) && has("Depth", "Z");
    }
};

/// Prefixes of Blender's view layers, such as "ViewLayer.": those with a combined image first, in the file's order.
inline std::vector<std::string> view_layer_prefixes(std::vector<ExrChannel> const& channels) {
    std::vector<std::string> prefixes;
    for (std::string_view const pass : {".Combined.R", ".DiffDir.R", ".Diffuse Direct.R", ".DiffInd.R", ".Diffuse Indirect.R", ".Depth.Z"})
        for (auto const& channel : channels) {
            if (!channel.name.ends_with(pass)) continue;
            auto const prefix = channel.name.substr(0, channel.name.size() - pass.size() + 1);
            if (std::ranges::find(prefixes, prefix) == prefixes.end()) prefixes.push_back(prefix);
        }
    return prefixes;
}

/// Prefix of the view layer with the most of light, depth and motion, of several the first; empty text for passes without a view layer, as
/// the node File Output writes them; nothing if the names are not Blender's. What the compositor writes else has light alone.
inline std::optional<std::string> view_layer_prefix(std::vector<ExrChannel> const& channels) {
    auto prefixes = view_layer_prefixes(channels);
    if (ViewLayer{channels, ""}.is_one()) prefixes.emplace_back();
    auto const guides = [&](std::string const& prefix) {
        ViewLayer const layer{channels, prefix};
        return (layer.has("Depth", "Z") ? 1 : 0) + (layer.has("Vector", "X") ? 1 : 0);
    };
    auto const most = std::ranges::max_element(prefixes, {}, guides);
    return most == prefixes.end() ? std::nullopt : std::optional(*most);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io::detail
