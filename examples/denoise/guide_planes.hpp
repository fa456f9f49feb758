#pragma once

#include <quell/io/channel_names.hpp>
#include <quell/io/exr_image.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace quell::examples {

/// Whether a channel is read from planes alone, all of which an image has: then they can be changed.
[[nodiscard]] inline bool is_pass(io::ExrImage const& image, std::vector<io::Source> const& sources) {
    return std::ranges::none_of(sources, [](auto const& source) { return source.sum.empty() || source.scale == 0.f; }) &&
           image.has_all(io::planes_of(sources));
}

[[nodiscard]] inline io::Plane& plane_of(io::ExrImage& image, std::string const& name) {
    auto const& found = image[name];
    return image.planes[static_cast<std::size_t>(&found - image.planes.data())];
}

/// Makes a component what f(pixel) says at the pixels of a list.
/// @param source of a channel that is_pass()
void put_component(io::ExrImage& image, io::Source const& source, std::vector<std::size_t> const& pixels, auto const& f) {
    bool is_first = true;
    for (auto const& name : source.sum) {
        auto& values = plane_of(image, name).values;
        for (auto const pixel : pixels) values[pixel] = is_first ? (f(pixel) - source.offset) / source.scale : 0.f;
        is_first = false;
    }
}

} // namespace quell::examples
