#pragma once

/// The two macros of quell. QUELL_KERNEL marks every function that runs inside a kernel.
/// Kernels are made of many tiny functions, and a single one left as a call spills every SIMD register (clang was 5.5 times slower), so
/// inlining is forced. `constexpr` lets nvcc take the same function for the device (`--expt-relaxed-constexpr`).
/// QUELL_RARE marks what few pixels need and what is large: left as a call, it is compiled once and costs the common path nothing.
#if defined(__CUDACC__)
#define QUELL_KERNEL constexpr
#define QUELL_RARE constexpr
#elif defined(__GNUC__)
#define QUELL_KERNEL [[gnu::always_inline]] inline constexpr
#define QUELL_RARE [[gnu::noinline]] inline
#else
#define QUELL_KERNEL inline constexpr
#define QUELL_RARE inline
#endif
