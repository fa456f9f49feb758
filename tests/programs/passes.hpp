#pragma once

#include "programs.hpp"

#include <denoise/light_split.hpp>

#include <quell/core/half.hpp>

// Pictures that are put together of passes, as renderers write them.
namespace quell::tests {

using Colours = std::vector<glm::vec3>;
constexpr std::array letters{"R", "G", "B"};

/// The colours of all pixels: f(x, y).
inline Colours colours(Extent size, auto const& f) {
    Colours result;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) result.push_back(f(x, y));
    return result;
}

inline float as_stored(float value, io::SampleType type) {
    return type == io::SampleType::half ? float_from_half(io::detail::stored_half(value)) : value;
}

/// Adds a layer, rounded as the file would round it.
inline void add_pass(io::ExrImage& image, std::string const& name, Colours const& values, io::SampleType type) {
    for (glm::length_t c = 0; c < 3; ++c) {
        io::Plane plane{.name = (name.empty() ? "" : name + ".") + letters[static_cast<std::size_t>(c)], .type = type, .values = {}};
        for (auto const& value : values) plane.values.push_back(as_stored(value[c], type));
        image.planes.push_back(std::move(plane));
    }
}
inline void add_guides(io::ExrImage& image, auto const& depth, glm::vec2 const& motion = glm::vec2(0.f)) {
    image.planes.push_back(plane("depth.Z", image.size, depth));
    for (auto const& [name, value] :
         {std::pair{"normal.X", 0.f}, {"normal.Y", 0.f}, {"normal.Z", 1.f}, {"motion.X", motion.x}, {"motion.Y", motion.y}})
        image.planes.push_back(plane(name, image.size, [number = value](int, int) { return number; }));
}
inline Colours pass(io::ExrImage const& image, std::string const& layer) {
    auto const of = [&](char const* letter) -> auto const& { return image[layer.empty() ? letter : layer + "." + letter].values; };
    auto const &r = of("R"), &g = of("G"), &b = of("B");
    Colours result;
    for (std::size_t i = 0; i < r.size(); ++i) result.emplace_back(r[i], g[i], b[i]);
    return result;
}

/// All pixels of a picture, and the other way round.
inline Colours pixels_of(examples::LinearView const& picture) { return metrics::picture_of(picture).pixels; }
inline examples::LinearPicture picture_of(Extent size, Colours const& pixels) {
    examples::LinearPicture picture(size);
    for (std::size_t i = 0; i < pixels.size(); ++i) picture[i] = pixels[i];
    return picture;
}

inline std::vector<io::Source> three(std::vector<std::string> const& layers) {
    std::vector<io::Source> sources(3);
    for (std::size_t c = 0; c < 3; ++c)
        for (auto const& layer : layers) sources[c].sum.push_back(layer + "." + letters[c]);
    return sources;
}

/// Two lights, each times its colour, what is added, and the picture.
inline io::SequenceNames names_of_passes() {
    io::SequenceNames names{"a test", {{"diffuse"}, {"glossy"}}, three({"glow", "sky"}), three({"beauty"})};
    for (auto& signal : names.of_signals) {
        signal.channels.sources["radiance"] = three({signal.name});
        signal.channels.sources["albedo"] = std::vector<io::Source>(3, io::Source{{}, 1.f});
        signal.factor = three({signal.name + "_colour"});
    }
    return names;
}

inline double root_mean_square(Colours const& a, Colours const& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(glm::dot(a[i] - b[i], a[i] - b[i]));
    return std::sqrt(sum / static_cast<double>(3 * a.size()));
}

} // namespace quell::tests
