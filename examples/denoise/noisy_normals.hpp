#pragma once

#include <denoise/linear_picture.hpp>
#include <denoise/surface_links.hpp>

#include <quell/image/extent.hpp>

namespace quell::examples {

/// Whether normals of neighbours differ by more than 8 degrees nearly everywhere on surfaces that are plane by their depth: of bumps, or of
/// noise.
/// @param guides with depth and normals; without one, nothing is rough
[[nodiscard]] bool are_normals_rough(Extent size, SurfaceGuides const& guides);

/// Whether light goes with rough normals. That of bumps does, and that of noise does not.
///
/// Of neighbours on one plane, let n be the difference of normals and l that of light over its sum. In each block of 16x16 pixels, l is
/// explained by n in least squares: l = s n, with three unknowns s. Of m pairs, three in m of the squares of l are explained by chance:
/// normals explain light where it is three hundredths more.
/// @param guides with depth and normals
/// @param light  of each pixel, linear
[[nodiscard]] bool do_normals_explain(Extent size, SurfaceGuides const& guides, LinearView const& light);

} // namespace quell::examples
