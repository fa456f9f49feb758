#pragma once

#include <quell/core/instruction_set.hpp>

#if defined(min) || defined(max)
#error "quell and the standard library call min and max: define NOMINMAX before windows.h"
#endif
#if defined(_MSC_VER) && !defined(__clang__) && !defined(__CUDACC__)
#error "quell is written for g++ and clang++; on Windows, compile with clang-cl"
#endif

/// Marks a function that runs inside a kernel.
/// It forces inlining: one remaining call spills every SIMD register (5.5 times slower with clang). `constexpr` lets nvcc compile the same
/// function for the device (`--expt-relaxed-constexpr`). Large code that few pixels need is marked [[gnu::noinline]] constexpr instead, so
/// that it costs the common case nothing.
#if defined(__CUDACC__)
#define QUELL_KERNEL constexpr
#else
#define QUELL_KERNEL [[gnu::always_inline]] inline constexpr
#endif

/// The same for a lambda inside a kernel. It stands after the parameters: [&](auto a) QUELL_INLINED { ... }.
#define QUELL_INLINED __attribute__((always_inline))

/// Unrolls the loop that follows, of at most 8 turns. The addresses of its taps become constants.
#if defined(__CUDACC__)
#define QUELL_UNROLL _Pragma("unroll")
#else
#define QUELL_UNROLL _Pragma("GCC unroll 8")
#endif
