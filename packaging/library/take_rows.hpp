#pragma once

#include "preset_code.hpp"

namespace quell_library {

/// Copies rows y0 <= y < y1 of an image of the caller's to planes.
/// @param to the planes' first pixels, of which there are `components`
/// @param to_row the distance from a row of theirs to the next, in elements
void take_rows(Image const& from, int components, float* const* to, std::ptrdiff_t to_row, int width, int y0, int y1);

} // namespace quell_library
