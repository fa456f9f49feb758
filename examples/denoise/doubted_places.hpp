#pragma once

#include <denoise/surface_links.hpp>

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace quell::examples {

/// Places of pixels that are reached from some of them, on their surfaces, over others.
/// @param fewest  pixels of a place: smaller ones don't count
/// @param begins  whether a pixel is one to begin from
/// @param goes_on whether a pixel is one to go on over
[[nodiscard]] std::vector<bool> places(SurfaceLinks const& surfaces, std::size_t pixels, std::size_t fewest,
                                       std::function<bool(std::size_t)> const& begins, std::function<bool(std::size_t)> const& goes_on);

/// Adds pixels that have more of a mask than of the rest around them, on their surface in 27x27 pixels.
void close_gaps(SurfaceLinks const& surfaces, std::vector<bool>& mask);

/// Puts one constant into each place of a mask, which is a part of one surface: 1, or where the place ends on its surface, the geometric
/// mean of the colours around it. What is divided by them has no edge there then.
void flatten(SurfaceLinks const& surfaces, std::vector<bool> const& mask, std::vector<glm::vec3>& colours);

} // namespace quell::examples
