#pragma once

#include "cuda/scene.hpp"

namespace quell::bench {

/// How many frames a sequence has.
inline constexpr int sequence_frames = 2;

using Input = Frame<Sample::channels>;

/// Frames of the world that GPUs are measured by, to be run round and round. Made once; only the last size asked for is kept.
std::vector<Input> const& sequence(Extent size);

} // namespace quell::bench
