#pragma once

#include <quell/frame/frame.hpp>

#include <vector>

namespace quell::bench {

/// How many frames a sequence has.
inline constexpr int sequence_frames = 4;

/// What most presets read. Those that read more get frames that are traced.
using Input = Frame<Channels<Radiance, Depth, Normal, Motion, Albedo>>;

/// A few frames of a made-up scene, to be run round and round: planes and spheres with edges before them, texture, noise as of one sample
/// per pixel, misses, and a camera that moves by fractions of a pixel on a closed path, so that the last frame leads to the first. Made
/// once; only the last size asked for is kept.
std::vector<Input> const& sequence(Extent size);

} // namespace quell::bench
