#pragma once

#if defined(min) || defined(max)
#error "quell and the standard library call min and max: define NOMINMAX before windows.h"
#endif
#if defined(_MSC_VER) && !defined(__clang__) && !defined(__CUDACC__)
#error "quell is written for g++ and clang++; on Windows, compile with clang-cl"
#endif

/// Marks every function that runs inside a kernel.
/// Kernels are made of many tiny functions, and a single one left as a call spills every SIMD register (clang was 5.5 times slower), so
/// inlining is forced. `constexpr` lets nvcc take the same function for the device (`--expt-relaxed-constexpr`).
/// What few pixels need and what is large is marked [[gnu::noinline]] constexpr instead: as a call it is compiled once, and costs the
/// common path nothing.
#if defined(__CUDACC__)
#define QUELL_KERNEL constexpr
#else
#define QUELL_KERNEL [[gnu::always_inline]] inline constexpr
#endif

/// Marks a lambda inside a kernel, behind its parameters: [&](auto a) QUELL_INLINED { ... }. It is inlined by force, for the same reason.
#define QUELL_INLINED __attribute__((always_inline))
