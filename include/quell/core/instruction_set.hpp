#pragma once

// All of quell is in an inline namespace named for the instruction set that a file is compiled for: quell::x86_64_v3::Frame. Users write
// quell::Frame. The linker keeps one version of each inline function; by these names, files that are compiled for different instruction
// sets can be linked in one program. Other flags than those below that change code are not told apart: -march=native and -march=x86-64-v4
// on a newer machine, -ffp-contract. Such a file says -D QUELL_INSTRUCTION_SET=name.
#if !defined(QUELL_INSTRUCTION_SET)
#if defined(__CUDACC__)
#define QUELL_INSTRUCTION_SET cuda // nvcc's host code runs one pixel at a time
#else
#define QUELL_INSTRUCTION_SET QUELL_JOINED_AS(QUELL_SIMD_NAME, QUELL_FMA_NAME, QUELL_HALF_NAME, QUELL_MATH_NAME)
#define QUELL_JOINED_AS(simd, fma, half, math) QUELL_JOINED(simd, fma, half, math)
#define QUELL_JOINED(simd, fma, half, math) simd##fma##half##math

#if defined(__FMA__) && defined(__F16C__) && defined(__AVX2__) && !defined(__FMA4__)
#define QUELL_HAS_V3
#endif
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512CD__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define QUELL_HAS_AVX512
#endif

#if defined(QUELL_HAS_V3) && defined(QUELL_HAS_AVX512)
#define QUELL_SIMD_NAME x86_64_v4
#define QUELL_IS_LEVEL
#elif defined(QUELL_HAS_V3) && !defined(__AVX512F__)
#define QUELL_SIMD_NAME x86_64_v3
#define QUELL_IS_LEVEL
#elif defined(QUELL_HAS_AVX512)
#define QUELL_SIMD_NAME avx512
#elif defined(__AVX512F__)
#define QUELL_SIMD_NAME avx512f
#elif defined(__AVX2__)
#define QUELL_SIMD_NAME avx2
#elif defined(__AVX__)
#define QUELL_SIMD_NAME avx
#elif defined(__SSE4_2__)
#define QUELL_SIMD_NAME sse4_2
#elif defined(__SSE4_1__)
#define QUELL_SIMD_NAME sse4_1
#elif defined(__SSSE3__)
#define QUELL_SIMD_NAME ssse3
#elif defined(__SSE3__)
#define QUELL_SIMD_NAME sse3
#elif defined(__SSE2__)
#define QUELL_SIMD_NAME sse2
#elif defined(__ARM_FEATURE_SVE)
#define QUELL_SIMD_NAME sve
#elif defined(__aarch64__)
#define QUELL_SIMD_NAME neon64
#elif defined(__ARM_NEON)
#define QUELL_SIMD_NAME neon
#elif defined(__riscv_vector)
#define QUELL_SIMD_NAME rvv
#elif defined(__wasm_simd128__)
#define QUELL_SIMD_NAME wasm
#else
#define QUELL_SIMD_NAME scalar
#endif

// What the names of levels do not say already.
#if defined(__FMA4__)
#define QUELL_FMA_NAME _fma4
#elif defined(__FMA__) && !defined(QUELL_IS_LEVEL)
#define QUELL_FMA_NAME _fma
#else
#define QUELL_FMA_NAME
#endif
#if defined(__AVX512FP16__)
#define QUELL_HALF_NAME _fp16
#elif defined(__F16C__) && !defined(QUELL_IS_LEVEL)
#define QUELL_HALF_NAME _f16c
#else
#define QUELL_HALF_NAME
#endif
#if defined(__FAST_MATH__)
#define QUELL_MATH_NAME _fast_math
#else
#define QUELL_MATH_NAME
#endif
#endif
#endif
