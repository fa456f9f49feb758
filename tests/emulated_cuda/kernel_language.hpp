#pragma once

// Lets a file be compiled as nvcc compiles it for the device, by a compiler for the host. It stands before all headers of quell.
// Headers of others come first, so that they don't take the compiler for nvcc.
#include "device.hpp"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <compare>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#define __CUDACC__ 1
#define __CUDA_ARCH__ 800
#define __global__
#define __device__
#define __host__
#define __grid_constant__
#define __launch_bounds__(threads)

// Of the running thread.
extern thread_local uint3 threadIdx, blockIdx;
extern thread_local dim3 blockDim, gridDim;

void __syncthreads();
inline void __threadfence() { std::atomic_thread_fence(std::memory_order_seq_cst); }
template <class Whole> Whole atomicAdd(Whole* sum, Whole more) { return std::atomic_ref<Whole>(*sum).fetch_add(more); }
