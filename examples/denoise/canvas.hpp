#pragma once

#include <quell/io/exr_image.hpp>
#include <quell/io/exr_listing.hpp>
#include <quell/io/sequence_names.hpp>

namespace quell::examples {

// Files may hold pixels around their display window. What is denoised is the canvas, which has them too; vectors in parts of the image,
// cameras and fields of view are of the display window.

/// The names by which images of the canvas are read: vectors in parts of the display window are other parts of a canvas that is larger.
/// @param size of the display window
[[nodiscard]] io::SequenceNames names_on_canvas(io::SequenceNames names, Extent size, Region const& canvas);

/// @throws Error where a canvas that is larger would need a field of view, and only the map has that: it is the display window's
void check_field_of_view(io::ExrListing const& file, io::SequenceNames const& map, Region const& canvas);

/// Changes projections in the attributes so that the canvas is what they show.
/// @param image of the canvas
/// @param size  of the display window
void put_cameras_on_canvas(io::ExrImage& image, Extent size, Region const& canvas);

} // namespace quell::examples
