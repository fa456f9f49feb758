#pragma once

#include <quell/io/exr_image.hpp>
#include <quell/io/sequence_names.hpp>

namespace quell::examples {

/// The number of samples per pixel that a file says it has, as Cycles' files do for each view layer: that of the layer whose light is read.
/// 0: it says none, or several and not which.
[[nodiscard]] int samples_in(io::ExrListing const& file, io::SequenceNames const& names);

/// How many samples per pixel a frame seems to have, whatever its file says. The file's number is that which was asked for: a render that
/// ran out of time has fewer, and so has one that sampled adaptively. It is believed where the noise of indirect light says at least a
/// seventh or at most 16 times as many, and not at all from a nineteenth or 64 times on; more have to be seen in four fifths of the
/// picture, since some light has no noise. Relative to the light of a pixel, that noise has a standard deviation of about 1.6 over the
/// square root of the samples, from 0.8 to 5 in scenes of Cycles. A frame without passes of indirect light is believed.
/// @param names by which the image is read
/// @param said  what samples_in() said; 0, not known, stays
[[nodiscard]] int believed_samples(io::ExrImage const& image, io::SequenceNames const& names, int said);

} // namespace quell::examples
