#pragma once

#include <quell/io/blender_passes.hpp>

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

/// Guides by Blender's conventions: motion in pixels with y up, depth 1e10 for a miss, or the largest half where it is stored as one.
inline ChannelNames cycles_guides(ViewLayer const& layer) {
    ChannelNames names;
    names.sources["depth"] = layer.components_of("Depth", "Z");
    names.sources["motion"] = layer.components_of("Vector", "XY");
    if (layer.has("Vector", "Z") && layer.has("Vector", "W")) { // the node File Output leaves out W
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
    auto const* const depth = layer.find("Depth", "Z");
    names.miss_from = depth && depth->type == SampleType::half ? 65504.f : 1e9f;
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
    add("subsurface", "Subsurface");
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
    if (names.of_signals.empty())
        return cycles_combined(layer, "no light passes (DiffDir, DiffInd, DiffCol, ...; of Blender 5: Diffuse Direct, ...)");
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
    throw Error(
        file.name,
        "its channels are neither quell's (R, G, B, depth.Z, ...) nor Blender's (ViewLayer.Combined.R, or Image.R and Depth.V, ...)",
        "name them with a channel map; it has: " + detail::list_of_names(file.channels));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
