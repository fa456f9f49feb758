#pragma once

#include <quell/core/real.hpp>
#include <quell/io/exr/exr_attributes.hpp>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::io::detail {

/// The part of a channel's name before its last dot, and what stands behind it.
struct SplitName {
    std::string layer, component;

    explicit SplitName(std::string const& name) {
        auto const dot = name.rfind('.');
        layer = dot == std::string::npos ? "" : name.substr(0, dot + 1), component = name.substr(dot + 1); // npos + 1 is 0
    }
};

/// Whether a channel Y is the y of a vector, and not luminance.
inline bool is_of_vector(Imf::Header const& header, std::string const& layer) {
    auto const has = [&](char const* component) { return header.channels().findChannel(layer + component) != nullptr; };
    if (has("RY") || has("BY")) return false;
    return has("X") || (!layer.empty() && (has("Z") || has("W"))); // Z beside the picture itself is depth
}

/// Whether a name is of a layer of Cryptomatte: cryptomatte/<id>/name is the beginning of its layers' names.
inline bool is_cryptomatte(Imf::Header const& header, std::string const& name) {
    for (auto i = header.begin(); i != header.end(); ++i) {
        std::string_view const attribute = i.name();
        auto const* const text = dynamic_cast<Imf::StringAttribute const*>(&i.attribute());
        if (text && attribute.starts_with("cryptomatte/") && attribute.ends_with("/name") && name.starts_with(text->value())) return true;
    }
    return false;
}

/// Whether numbers mean something else than light, by their name: then no compression may change them.
inline bool is_data(Imf::Header const& header, std::string const& name, Imf::PixelType type) {
    if (type == Imf::UINT || is_cryptomatte(header, name)) return true;
    auto const [layer, component] = SplitName(name);
    if (component == "Y") return is_of_vector(header, layer);
    static std::vector<std::string> const colours{"R", "G", "B", "A", "RY", "BY"};
    return std::ranges::find(colours, component) == colours.end();
}

/// Whether a compression made light infinite, or NaN, that was not: DWA does so next to the largest half.
inline bool made_infinite(std::vector<float> const& light, std::vector<float> const& packed) {
    for (std::size_t i = 0; i < light.size(); ++i)
        if (is_finite(light[i]) && !is_finite(packed[i])) return true;
    return false;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io::detail
