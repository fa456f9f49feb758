#pragma once

#include <gauntlet/render.hpp>

#include <quell/io/exr_image.hpp>

#include <string>

namespace quell::gauntlet {

/// What a renderer writes of a frame, with what is broken of it.
[[nodiscard]] io::ExrImage file_of(Shot const& shot, Making const& making, int frame);

/// The layer of the picture: a name with a dot behind it, or nothing.
[[nodiscard]] std::string picture_layer(Shot const& shot);

} // namespace quell::gauntlet
