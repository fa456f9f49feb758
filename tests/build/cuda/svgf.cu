// Success is compiling: every kernel of presets::svgf for the device, from the same headers that run on a CPU.
#include <quell/execute/cuda.cuh>
#include <quell/quell.hpp>

constexpr auto denoise = quell::presets::svgf(quell::radiance, quell::Demodulate{});

void denoise_on_device(quell::Extent size, cudaStream_t stream) {
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    quell::run(denoise, frame, history, quell::Cuda{stream});
}
