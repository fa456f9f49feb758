#pragma once

#include <quell/core/kernel.hpp>

#include <cstdint>
#include <limits>

#if !defined(__CUDACC__)
// g++ 12 warns of uninitialized values in its own AVX-512 headers wherever a kernel is inlined (https://gcc.gnu.org/PR105593). Hosts may
// compile with -Werror.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <xsimd/xsimd.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

/// GLM needs this for vectors of packs: glm::vec<3, Pack> then has arithmetic and dot.
template <class A> struct std::numeric_limits<xsimd::batch<float, A>> : std::numeric_limits<float> {};
#if defined(__aarch64__) // xsimd 8 divides by an estimate, off in the last bits: a pack would decide otherwise than a float
template <> inline auto xsimd::batch<float, xsimd::neon64>::operator/=(batch const& b) noexcept -> batch& {
    return *this = batch(vdivq_f32(*this, b));
}
#endif

namespace quell::inline QUELL_INSTRUCTION_SET {

// Of the functions in real.hpp, those that instruction sets have differently, for packs.
/// @cond
#if defined(__wasm_simd128__) && defined(__SSE2__)
// emscripten makes comparisons and selections of x86's min and max, and truncates number by number.
template <class A> QUELL_KERNEL v128_t wasm_of(xsimd::batch<float, A> a) { return v128_t(__m128(a)); }
template <class A> QUELL_KERNEL auto min(xsimd::batch<float, A> a, xsimd::batch<float, A> b) {
    return xsimd::batch<float, A>(__m128(wasm_f32x4_pmin(wasm_of(b), wasm_of(a))));
}
template <class A> QUELL_KERNEL auto max(xsimd::batch<float, A> a, xsimd::batch<float, A> b) {
    return xsimd::batch<float, A>(__m128(wasm_f32x4_pmax(wasm_of(b), wasm_of(a))));
}
template <class A> QUELL_KERNEL auto sqrt(xsimd::batch<float, A> a) { return xsimd::sqrt(a); }
template <class A> QUELL_KERNEL auto floor(xsimd::batch<float, A> a) {
    return xsimd::batch<float, A>(__m128(wasm_f32x4_floor(wasm_of(a))));
}
template <class A> QUELL_KERNEL auto truncate(xsimd::batch<float, A> a) {
    return xsimd::batch<std::int32_t, A>(__m128i(wasm_i32x4_trunc_sat_f32x4(wasm_of(a))));
}
#else
#if defined(__SSE2__)
template <class A> QUELL_KERNEL auto min(xsimd::batch<float, A> a, xsimd::batch<float, A> b) { return xsimd::min(a, b); }
template <class A> QUELL_KERNEL auto max(xsimd::batch<float, A> a, xsimd::batch<float, A> b) { return xsimd::max(a, b); }
#else // Arm's instructions give NaN if either is
template <class A> QUELL_KERNEL auto min(xsimd::batch<float, A> a, xsimd::batch<float, A> b) { return xsimd::select(a < b, a, b); }
template <class A> QUELL_KERNEL auto max(xsimd::batch<float, A> a, xsimd::batch<float, A> b) { return xsimd::select(a > b, a, b); }
#endif
#if defined(__aarch64__) // xsimd 8 estimates roots, and floors by way of integers
template <class A> QUELL_KERNEL auto sqrt(xsimd::batch<float, A> a) { return xsimd::batch<float, A>(vsqrtq_f32(a)); }
template <class A> QUELL_KERNEL auto floor(xsimd::batch<float, A> a) { return xsimd::batch<float, A>(vrndmq_f32(a)); }
#else
template <class A> QUELL_KERNEL auto sqrt(xsimd::batch<float, A> a) { return xsimd::sqrt(a); }
template <class A> QUELL_KERNEL auto floor(xsimd::batch<float, A> a) { return xsimd::floor(a); }
#endif
template <class A> QUELL_KERNEL auto truncate(xsimd::batch<float, A> a) { return xsimd::to_int(a); }
#endif
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
#endif
