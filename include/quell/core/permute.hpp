#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Whether permuted() is faster than loads lane by lane.
template <class Real> inline constexpr bool permutes = false;

#if defined(__AVX2__) && !defined(__CUDACC__)
template <class A> inline constexpr bool permutes<xsimd::batch<float, A>> = width_of<xsimd::batch<float, A>> >= 8;

/// Lane i is lane at[i] of `low`, or lane at[i] - width_of<Real> of `high`. No more than xsimd 8 lacks.
template <class A>
QUELL_KERNEL xsimd::batch<float, A> permuted(xsimd::batch<float, A> low, xsimd::batch<float, A> high, xsimd::batch<std::int32_t, A> at) {
    constexpr int width = width_of<xsimd::batch<float, A>>;
#if defined(__AVX512F__)
    if constexpr (width == 16) return _mm512_permutex2var_ps(low, at, high);
#endif
#if defined(__AVX512VL__)
    if constexpr (width == 8) return _mm256_permutex2var_ps(low, at, high);
#else
    if constexpr (width == 8) {
        // The permutation takes the index's last three bits; the blend takes the sign, to which the next bit is moved.
        auto const in_high = _mm256_castsi256_ps(_mm256_slli_epi32(at, 28));
        return _mm256_blendv_ps(_mm256_permutevar8x32_ps(low, at), _mm256_permutevar8x32_ps(high, at), in_high);
    }
#endif
}
#endif

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
