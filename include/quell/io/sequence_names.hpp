#pragma once

#include <quell/io/channel_names.hpp>
#include <quell/io/exr_listing.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// A signal that is denoised by itself: sources of the frame's channels, and the factor of the denoised signal in the image.
struct SignalNames {
    std::string name;                ///< for messages
    ChannelNames channels = {};      ///< sources of the frame's channels
    std::vector<Source> factor = {}; ///< one source per component; empty: 1
};

/// How a renderer's files make up the image: the sum of its signals, each times its factor, plus what has no noise.
struct SequenceNames {
    std::string renderer;                     ///< for messages
    std::vector<SignalNames> of_signals = {}; ///< at least one
    std::vector<Source> added = {};           ///< one source per component; empty: nothing is added
    std::vector<Source> picture = {};         ///< the image as the renderer has put it together, per component; empty: not known
    std::vector<std::string> remarks = {};    ///< for the user: what these files lack, and what is used instead
    std::string view = {};                    ///< which of several views of the files, for messages; empty: the only one
    std::string layer = {};                   ///< where further layers go: the view layer's name and a dot
    std::string eye = {};                     ///< the stereo view that stands before the last component of names, as left in left.R
};

/// Names of quell's own files: one signal, the image, which pipelines demodulate by its albedo.
[[nodiscard]] inline SequenceNames own_sequence() { return {"quell", {{"radiance"}}}; }

namespace detail {

/// A view layer of Blender, by the names of its passes.
struct ViewLayer {
    std::vector<ExrChannel> const& channels;
    std::string prefix;

    [[nodiscard]] bool has(std::string const& pass, std::string const& component) const {
        return std::ranges::any_of(channels, [&](auto const& c) { return c.name == prefix + pass + "." + component; });
    }
    /// Sum of those of these passes that exist, per component; empty if a component has none.
    [[nodiscard]] std::vector<Source> sum_of(std::vector<std::string> const& passes) const {
        std::vector<Source> sources;
        for (auto const* const component : {"R", "G", "B"}) {
            Source source;
            for (auto const& pass : passes)
                if (has(pass, component)) source.sum.push_back(prefix + pass + "." + component);
            if (!source.sum.empty()) sources.push_back(source);
        }
        return sources.size() == 3 ? sources : std::vector<Source>();
    }
    [[nodiscard]] std::vector<Source> components_of(std::string const& pass, std::string const& letters) const {
        std::vector<Source> sources;
        for (char const letter : letters) sources.push_back({{prefix + pass + "." + letter}});
        return sources;
    }
};

/// Prefixes of Blender's view layers, such as "ViewLayer.": those with a combined image first, in the file's order.
inline std::vector<std::string> view_layer_prefixes(std::vector<ExrChannel> const& channels) {
    std::vector<std::string> prefixes;
    for (std::string_view const pass : {".Combined.R", ".DiffDir.R", ".DiffInd.R", ".Depth.Z"})
        for (auto const& channel : channels) {
            if (!channel.name.ends_with(pass)) continue;
            auto const prefix = channel.name.substr(0, channel.name.size() - pass.size() + 1);
            if (std::ranges::find(prefixes, prefix) == prefixes.end()) prefixes.push_back(prefix);
        }
    return prefixes;
}

/// Prefix of the view layer with the most of light, depth and motion, of several the first; empty if the names are not Blender's. What
/// the compositor writes has light alone.
inline std::optional<std::string> view_layer_prefix(std::vector<ExrChannel> const& channels) {
    auto const prefixes = view_layer_prefixes(channels);
    auto const guides = [&](std::string const& prefix) {
        ViewLayer const layer{channels, prefix};
        return (layer.has("Depth", "Z") ? 1 : 0) + (layer.has("Vector", "X") ? 1 : 0);
    };
    auto const most = std::ranges::max_element(prefixes, {}, guides);
    return most == prefixes.end() ? std::nullopt : std::optional(*most);
}

/// Guides by Blender's conventions: motion in pixels with y up, depth 1e10 for a miss.
inline ChannelNames cycles_guides(ViewLayer const& layer) {
    ChannelNames names;
    names.sources["depth"] = layer.components_of("Depth", "Z");
    names.sources["motion"] = layer.components_of("Vector", "XY");
    if (layer.has("Vector", "Z")) {
        names.sources["motion_next"] = layer.components_of("Vector", "ZW");
        for (auto& source : names.sources["motion_next"]) source.scale = -1.f; // Blender's vector points from the next frame
    }
    names.sources["position"] = layer.components_of("Position", "XYZ");
    names.sources["instance"] = layer.components_of("IndexOB", "X");
    // A constant normal passes every test and stops no filter.
    names.sources["normal"] =
        layer.has("Normal", "X") ? layer.components_of("Normal", "XYZ") : std::vector<Source>{{{}, 0.f}, {{}, 0.f}, {{}, 1.f}};
    names.sources["albedo"] = std::vector<Source>(3, Source{{}, 1.f}); // light passes are divided by their colour already
    names.motion.y = MotionConvention::Y::up;
    names.miss_from = 1e9f;
    return names;
}

/// Light and colour of each kind of scattering that was rendered.
inline std::vector<SignalNames> cycles_signals(ViewLayer const& layer) {
    std::vector<SignalNames> named;
    auto const add = [&](std::string const& name, std::string const& pass) {
        auto const light = layer.sum_of({pass + "Dir", pass + "Ind"});
        if (light.empty()) return;
        SignalNames signal{name, cycles_guides(layer), layer.sum_of({pass + "Col"})};
        signal.channels.sources["radiance"] = light;
        named.push_back(std::move(signal));
    };
    add("diffuse", "Diff");
    add("glossy", "Gloss");
    add("transmission", "Trans");
    add("volume", "Volume");
    return named;
}

/// The combined image as one signal, and why.
inline SequenceNames cycles_combined(ViewLayer const& layer, std::string const& why) {
    SequenceNames names{"Blender Cycles", {{"combined", cycles_guides(layer)}}};
    auto& sources = names.of_signals[0].channels.sources;
    sources["radiance"] = layer.components_of("Combined", "RGB");
    if (layer.has("Denoising Albedo", "R")) sources["albedo"] = layer.components_of("Denoising Albedo", "RGB");
    names.remarks.push_back(why + ": the combined image is denoised as one signal");
    return names;
}

inline SequenceNames cycles_passes(ViewLayer const& layer) {
    SequenceNames names{"Blender Cycles", cycles_signals(layer)};
    if (names.of_signals.empty()) return cycles_combined(layer, "no light passes (DiffDir, DiffInd, DiffCol, ...)");
    names.added = layer.sum_of({"Emit", "Env"});
    names.picture = layer.sum_of({"Combined"});
    return names;
}
} // namespace detail

/// Names of Blender Cycles' files: every light pass of one view layer is a signal; emission and environment are added. What they
/// leave over of the combined image is found per frame. Without light passes that image is the only signal. Empty if the names are not
/// Blender's.
[[nodiscard]] inline std::optional<SequenceNames> cycles_sequence(ExrListing const& file) {
    auto const prefix = detail::view_layer_prefix(file.channels);
    if (!prefix) return std::nullopt;
    detail::ViewLayer const layer{file.channels, *prefix};
    auto names = detail::cycles_passes(layer);
    names.layer = *prefix;
    if (!layer.has("Normal", "X")) names.remarks.push_back("no Normal pass: surfaces are told apart by depth alone");
    return names;
}

/// Recognises the names of a file: quell's own or Blender Cycles'.
/// @throws Error naming the file and its channels if they are neither
[[nodiscard]] inline SequenceNames recognise(ExrListing const& file) {
    auto const has = [&](char const* name) { return file.find(name) != nullptr; };
    // A sequence traced for single effects has no R, G, B, but depth.
    if ((has("R") && has("G") && has("B")) || has("depth.Z")) return own_sequence();
    if (auto const names = cycles_sequence(file)) return *names;
    throw Error(file.name, "its channels are neither quell's (R, G, B, depth.Z, ...) nor Blender's (ViewLayer.Combined.R, ...)",
                "name them with a channel map; it has: " + detail::list_of_names(file.channels));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
