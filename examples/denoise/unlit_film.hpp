#pragma once

#include <quell/io/exr_image.hpp>
#include <quell/io/sequence_names.hpp>

#include <vector>

namespace quell::examples {

/// Where no light says what a film's alpha belongs to, so that alpha is a signal of its own: the pixel has no light, and less than a
/// quarter of those of the same surface around it have some. Shadow catchers, holdouts and black things are such; pixels that happened to
/// get no light are not. Surfaces are told apart by depth and normal, as far as the frame has them.
/// @param has_light of each pixel: whether its light is of what alpha belongs to
/// @param names     of the frame's guides
[[nodiscard]] std::vector<bool> unlit_film(std::vector<bool> const& has_light, io::ExrImage const& image, io::ChannelNames const& names);

} // namespace quell::examples
