#pragma once

#include <quell/core/instruction_set.hpp>

#if defined(min) || defined(max)
#error "quell and the standard library call min and max: define NOMINMAX before windows.h"
#endif
#if defined(_MSC_VER) && !defined(__clang__) && !defined(__CUDACC__)
#error "quell is written for g++ and clang++; on Windows, compile with clang-cl"
#endif

// All that is written differently for each compiler. docs/packaging.md lists what cl.exe would have in these places.

/// Marks a function that runs inside a kernel.
/// It is always inlined where an executor runs a job: one remaining call spills every SIMD register (5.5 times slower with clang).
/// `constexpr` lets nvcc compile the same function for the device (`--expt-relaxed-constexpr`).
///
/// g++ inlines by QUELL_FLATTENED instead. It would optimise a function that is always inlined anew in each function that it is inlined
/// into, and policies call each other ten deep. That doubled the time to compile a pipeline.
///
/// Nothing is inlined by force without optimisation (-O0), where it makes nothing faster, nor with sanitizers: what they add to code is
/// compiled faster in small functions.
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define QUELL_IN_SMALL_FUNCTIONS
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define QUELL_IN_SMALL_FUNCTIONS
#endif
#endif
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) && !defined(QUELL_IN_SMALL_FUNCTIONS)
#define QUELL_BY_FLATTENING
#endif
#if defined(__CUDACC__)
#define QUELL_KERNEL constexpr
#elif defined(QUELL_BY_FLATTENING) || defined(QUELL_IN_SMALL_FUNCTIONS)
#define QUELL_KERNEL inline constexpr
#else
#define QUELL_KERNEL [[gnu::always_inline]] inline constexpr
#endif

/// The same for a lambda inside a kernel. It stands after the parameters: [&](auto a) QUELL_INLINED { ... }.
#if defined(QUELL_BY_FLATTENING) || defined(QUELL_IN_SMALL_FUNCTIONS)
#define QUELL_INLINED
#else
#define QUELL_INLINED __attribute__((always_inline))
#endif

/// Marks the outermost function of a kernel: everything that it calls is inlined, and what that calls in turn. A pass's job has it, and
/// `for_each_pixel` of an executor that calls jobs itself. Both are needed: without the job's, svgf takes a tenth longer.
#if defined(QUELL_BY_FLATTENING)
#define QUELL_FLATTENED [[gnu::flatten]]
#else
#define QUELL_FLATTENED
#endif

/// Marks large code that few pixels need, in place of QUELL_KERNEL: `QUELL_OUTLINED constexpr`. It is never inlined, so that it costs the
/// common case nothing. On a device a call costs more: arguments behind references, such as all that a pass reads, are looked up in memory.
#if defined(__CUDACC__)
#define QUELL_OUTLINED
#else
#define QUELL_OUTLINED QUELL_NOINLINE QUELL_FLATTENED
#endif
/// Marks other functions that are never inlined.
#define QUELL_NOINLINE [[gnu::noinline]]

/// Before a data member: one without data takes no space. In the ABI of cl.exe and clang-cl the standard attribute means nothing. nvcc lays
/// such members out in one way for the device and in another for the host, so that what a kernel is given would arrive shifted.
#if defined(__CUDACC__)
#define QUELL_NO_UNIQUE_ADDRESS
#elif defined(_MSC_VER)
#if __has_cpp_attribute(msvc::no_unique_address)
#define QUELL_NO_UNIQUE_ADDRESS [[msvc::no_unique_address]]
#else
#define QUELL_NO_UNIQUE_ADDRESS
#endif
#else
#define QUELL_NO_UNIQUE_ADDRESS [[no_unique_address]]
#endif

/// Unrolls the loop that follows, of at most 8 turns. The addresses of its taps become constants. QUELL_UNROLL_ON_DEVICE does so only on a
/// device, where arrays that loops index are then registers.
#if defined(__CUDACC__)
#define QUELL_UNROLL _Pragma("unroll")
#define QUELL_UNROLL_ON_DEVICE _Pragma("unroll")
#else
#define QUELL_UNROLL _Pragma("GCC unroll 8")
#define QUELL_UNROLL_ON_DEVICE
#endif

namespace quell::inline QUELL_INSTRUCTION_SET::detail {
/// Whether this is compiled for a device. A thread there has registers for what a CPU's kernel keeps in arrays, and little local memory.
#if defined(__CUDA_ARCH__)
inline constexpr bool on_device = true;
#else
inline constexpr bool on_device = false;
#endif
} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

/// Before a kernel's argument: threads read it where it lies. Without it, each would make a copy in its local memory. Devices before
/// compute capability 7.0 do not have it.
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ < 700
#define QUELL_GRID_CONSTANT
#elif defined(__CUDACC__)
#define QUELL_GRID_CONSTANT __grid_constant__
#endif
