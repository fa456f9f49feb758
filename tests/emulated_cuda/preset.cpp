#include "run_steps.hpp"

// One of the presets that take long to compile, by Cuda: PRESET is its number.
template <> std::vector<emulated_cuda::Result> emulated_cuda::by_serial_of<PRESET>();

TEST_CASE("Cuda gives the bits of Serial with presets that take long to compile") {
    auto const expected = emulated_cuda::by_serial_of<PRESET>();
    emulated_cuda::check_preset<PRESET>(expected, nullptr);
    quell::CudaGraphs graphs;
    emulated_cuda::check_preset<PRESET>(expected, &graphs);
}
