#pragma once

#include <quell/core/real.hpp>

#if defined(__F16C__) && !defined(__CUDACC__)
#include <immintrin.h>
#endif
#if defined(__aarch64__) && !defined(__CUDACC__)
#include <arm_neon.h>
#include <cstring>
#include <type_traits>
#endif

namespace quell::inline QUELL_INSTRUCTION_SET {

#if defined(__aarch64__) && !defined(__CUDACC__)
namespace detail {
/// By one instruction, which neither flushes subnormal halves nor asks for the modes in which others do.
inline float float_by_instruction(std::uint16_t half) {
    __fp16 native;
    std::memcpy(&native, &half, sizeof native);
    return native;
}
/// The same; |a| is at most 65504.
inline std::uint16_t half_by_instruction(float a) {
    auto const native = static_cast<__fp16>(a);
    std::uint16_t half;
    std::memcpy(&half, &native, sizeof half);
    return half;
}
} // namespace detail
#endif

/// Converts IEEE 754 binary16 bits to float, exactly. Infinity and NaN keep their meaning.
QUELL_KERNEL float float_from_half(std::uint16_t half) {
#if defined(__aarch64__) && !defined(__CUDACC__)
    if (!std::is_constant_evaluated()) return detail::float_by_instruction(half);
#endif
    auto const sign = static_cast<std::uint32_t>(half & 0x8000u) << 16;
    auto const rest = static_cast<std::uint32_t>(half & 0x7fffu) << 13;
    // The shifted exponent is 112 too low. No float operand here is subnormal: hosts may flush those to zero.
    auto const exponent = half & 0x7c00u;
    auto const subnormal = std::bit_cast<std::uint32_t>(std::bit_cast<float>(rest | 0x38800000u) - 0x1p-14f);
    return std::bit_cast<float>(sign | (exponent == 0x7c00u ? 0x7f800000u | rest : exponent == 0 ? subnormal : rest + 0x38000000u));
}

/// Converts float to binary16 bits, rounding to nearest even. Values beyond the range become +-65504, the largest finite half: an infinity
/// would stay in the history. NaN becomes 0x7e00.
QUELL_KERNEL std::uint16_t half_from_float(float a) {
    auto const all = std::bit_cast<std::uint32_t>(a);
    auto const sign = static_cast<std::uint16_t>((all >> 16) & 0x8000u);
    auto const magnitude = all & 0x7fffffffu;
    if (magnitude > 0x7f800000u) return 0x7e00;
    if (magnitude >= 0x477ff000u) return static_cast<std::uint16_t>(sign | 0x7bffu); // 65520 and above would round to infinity
#if defined(__aarch64__) && !defined(__CUDACC__)
    if (!std::is_constant_evaluated()) return detail::half_by_instruction(a);
#endif
    if (magnitude < 0x38800000u) { // subnormal half: the float adder rounds at the right bit
        auto const rounded = std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - 0x3f000000u;
        return static_cast<std::uint16_t>(sign | rounded);
    }
    auto const odd = (magnitude >> 13) & 1u;
    return static_cast<std::uint16_t>(sign | ((magnitude - 0x38000000u + 0xfffu + odd) >> 13));
}

#if defined(__F16C__) && !defined(__CUDACC__)
namespace detail {
/// Makes clang++ compare floats and not halves after a conversion. clang++ 14 swaps the operands of the AVX-512 FP16 comparison: 0 < a
/// becomes a < 0.
template <class Register> QUELL_KERNEL Register as_floats(Register converted) {
#if defined(__clang__) && defined(__AVX512FP16__)
    asm("" : "+v"(converted));
#endif
    return converted;
}
} // namespace detail
#endif

/// Loads `width_of<Real>` adjacent halves. `p` needs no alignment.
template <class Real> QUELL_KERNEL Real load_half(std::uint16_t const* p) {
    if constexpr (width_of<Real> == 1) return float_from_half(*p);
#if defined(__AVX512F__) && !defined(__CUDACC__)
    else if constexpr (width_of<Real> == 16)
        return Real(detail::as_floats(_mm512_cvtph_ps(_mm256_loadu_si256(reinterpret_cast<__m256i const*>(p)))));
#endif
#if defined(__F16C__) && !defined(__CUDACC__)
    else if constexpr (width_of<Real> == 8)
        return Real(detail::as_floats(_mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<__m128i const*>(p)))));
#endif
#if defined(__aarch64__) && !defined(__CUDACC__)
    else if constexpr (width_of<Real> == 4)
        return Real(vcvt_f32_f16(vreinterpret_f16_u16(vld1_u16(p))));
#endif
    else {
        float lane[width_of<Real>];
        for (int i = 0; i < width_of<Real>; ++i) lane[i] = float_from_half(p[i]);
        return Real::load_unaligned(lane);
    }
}

/// Stores `width_of<Real>` adjacent halves. Values beyond the range become +-65504. NaN must not occur: its result depends on the machine.
template <class Real> QUELL_KERNEL void store_half(std::uint16_t* p, Real a) {
    if constexpr (width_of<Real> == 1)
        *p = half_from_float(a);
    else {
        [[maybe_unused]] auto const bounded = max(min(a, Real(65504.f)), Real(-65504.f));
#if defined(__AVX512F__) && !defined(__CUDACC__)
        if constexpr (width_of<Real> == 16) {
            // Not _mm512_cvtps_ph: without optimisation g++ has a macro in its place that converts -1 to a mask, of which hosts' warnings
            // tell.
            constexpr __mmask16 all = 0xffff;
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(p),
                                _mm512_maskz_cvtps_ph(all, bounded, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
            return;
        }
#endif
#if defined(__F16C__) && !defined(__CUDACC__)
        if constexpr (width_of<Real> == 8) {
            _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm256_cvtps_ph(bounded, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
            return;
        }
#endif
#if defined(__aarch64__) && !defined(__CUDACC__)
        if constexpr (width_of<Real> == 4) {
            vst1_u16(p, vreinterpret_u16_f16(vcvt_f16_f32(bounded)));
            return;
        }
#endif
        for (int i = 0; i < width_of<Real>; ++i) p[i] = half_from_float(lane(a, i));
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
