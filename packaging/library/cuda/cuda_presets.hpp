#pragma once

#include "../compiled_preset.hpp"

namespace quell_library {

/// The presets that are compiled for a GPU, of those that are compiled at all, in real time and for programs: images lie in the host's
/// memory, from which they are copied and to which the output is. Effects, whose part of a picture a composite makes, and presets that
/// accumulate guides are not among them. Where the device has too little memory, they move images to and from it. What they make
/// throws quell::Error where there is no GPU, or one that cannot do so.
/// @throws quell::Error where the program was built without CUDA
[[nodiscard]] std::vector<CompiledPreset> const& cuda_presets();

} // namespace quell_library
