#include "emulated.hpp"

#include "sequence.hpp"

#include <library/cuda/cuda_code.hpp>
#include <library/cuda/cuda_instance.cuh>

// libquell's code for a device, compiled for the emulated one. What is compiled for the CPU is left out.
std::vector<quell_library::PresetCode> const* quell_code_cuda() {
    using namespace quell_library;
    static std::vector<PresetCode> const all{cuda_code<emulated_cuda::Emulated>("svgf", [] { return emulated_cuda::preset<2>(); })};
    return &all;
}
extern "C" quell_library::PresetCodes quell_code_none;
std::vector<quell_library::PresetCode> const* quell_code_none() {
    static std::vector<quell_library::PresetCode> const none;
    return &none;
}
