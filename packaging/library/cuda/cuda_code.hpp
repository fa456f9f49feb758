#pragma once

#include "../preset_code.hpp"

// Presets compiled for a GPU by CUDA: libquell's code for a device, which programs use too. It is there where QUELL_CUDA_CODE is defined.
extern "C" quell_library::CodesOf quell_code_cuda;

namespace quell_library {

/// What to do where there is no code for a device.
inline constexpr auto build_with_cuda = "build it with -D QUELL_CUDA=ON where nvcc is, or leave the device out";

/// The presets and stages for CUDA; null where none were compiled.
inline Codes const* cuda_codes() {
#if defined(QUELL_CUDA_CODE)
    return quell_code_cuda();
#else
    return nullptr;
#endif
}

} // namespace quell_library
