#pragma once

#include "device.hpp"

#include <random>

namespace emulated_cuda {

inline constexpr unsigned multiprocessors = 3;

/// A kernel with its arguments, which are copies.
struct Launch {
    Kernel const* kernel = nullptr;
    dim3 grid, block;
    std::vector<std::vector<std::byte>> arguments;
    bool cooperative = false;
};
/// Runs all threads of a grid.
void run_grid(Launch const& launch, std::mt19937& random);

} // namespace emulated_cuda
