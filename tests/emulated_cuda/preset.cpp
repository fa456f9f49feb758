#include "run_steps.hpp"

// One of the presets that take long to compile, by Cuda: PRESET is its number.
template <> std::vector<emulated_cuda::Result> emulated_cuda::by_serial_of<PRESET>();
template <> emulated_cuda::Pictures emulated_cuda::rendered_by_serial_of<PRESET>();

TEST_CASE("Cuda gives the bits of Serial with presets that take long to compile") {
    auto const expected = emulated_cuda::by_serial_of<PRESET>();
    emulated_cuda::check_preset<PRESET>(expected, nullptr);
    quell::CudaGraphs graphs;
    emulated_cuda::check_preset<PRESET>(expected, &graphs);
}

TEST_CASE("frames that are traced and denoised on the device are those of the host, with presets that take long to compile") {
    quell::CudaGraphs graphs;
    emulated_cuda::check_rendered<PRESET>(emulated_cuda::rendered_by_serial_of<PRESET>(), &graphs);
}
