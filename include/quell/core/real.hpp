#pragma once

#include <quell/core/pack.hpp>
#include <quell/core/recording.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <math.h>
#include <type_traits>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

// A Real is a float (Serial, a GPU thread) or a pack of floats (neighbouring pixels of a row). Kernels are written once for both. Here is
// what GLM cannot do on packs. Comparisons give a Mask: a bool, or one bit per lane.

template <class Real> inline constexpr int width_of = 1; ///< pixels per Real: 1 for float

namespace detail {
template <class Real> struct IndexOf { using type = std::int32_t; };
} // namespace detail

/// The 32-bit integer of the same width as a Real: pixel coordinates, bit patterns.
template <class Real> using Index = typename detail::IndexOf<Real>::type;

/// The smaller one; b if either is NaN.
QUELL_KERNEL float min(float a, float b) { return a < b ? a : b; }
/// The larger one; b if either is NaN.
QUELL_KERNEL float max(float a, float b) { return a > b ? a : b; }
/// a with its sign bit cleared.
QUELL_KERNEL float abs(float a) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(a) & 0x7fffffffu); }
/// a where the mask is true, else b.
QUELL_KERNEL float select(bool condition, float a, float b) { return condition ? a : b; }
/// a where the mask is true, else 0. One instruction on packs.
QUELL_KERNEL float masked(bool condition, float a) { return condition ? a : 0.f; }
/// select() for an Index.
QUELL_KERNEL std::int32_t select_index(bool condition, std::int32_t a, std::int32_t b) { return condition ? a : b; }
QUELL_KERNEL bool any(bool mask) { return mask; }     ///< true in at least one lane
QUELL_KERNEL bool all(bool mask) { return mask; }     ///< true in every lane
QUELL_KERNEL bool invert(bool mask) { return !mask; } ///< not
/// And of all masks. A function, since compilers warn of & between bools.
template <class Mask, class... Masks> QUELL_KERNEL Mask both(Mask first, Masks... more) { return (first & ... & more); }
/// Or of all masks.
template <class Mask, class... Masks> QUELL_KERNEL Mask either(Mask first, Masks... more) { return (first | ... | more); }
QUELL_KERNEL std::int32_t bits(float a) { return std::bit_cast<std::int32_t>(a); } ///< the bit pattern of a float
QUELL_KERNEL float from_bits(std::int32_t a) { return std::bit_cast<float>(a); }   ///< the float of a bit pattern
/// Rounds toward zero. Out of range and NaN: INT32_MIN for float, machine-dependent for packs.
QUELL_KERNEL std::int32_t truncate(float a) {
    return abs(a) < 0x1p31f ? static_cast<std::int32_t>(a) : std::numeric_limits<std::int32_t>::min();
}
QUELL_KERNEL float to_real(std::int32_t a) { return static_cast<float>(a); } ///< converts an Index to Real
// Templates, since clang 14 refuses a plain constexpr function that it cannot evaluate at compile time.
template <std::same_as<float> F> QUELL_KERNEL float sqrt(F a) { return ::sqrtf(a); }   ///< square root
template <std::same_as<float> F> QUELL_KERNEL float floor(F a) { return ::floorf(a); } ///< rounds toward minus infinity

/// a * b + c, rounded once where the instruction set has FMA. Kernels call it explicitly: compilers contract a * b + c differently in each
/// inlined copy, so results would depend on where a kernel is used.
template <std::same_as<float> F> QUELL_KERNEL float fma(F a, F b, F c) {
#if (defined(__FMA__) || defined(__ARM_FEATURE_FMA)) && !defined(__CUDACC__)
    return __builtin_fmaf(a, b, c);
#else
    return a * b + c;
#endif
}

#if !defined(__CUDACC__)
/// The widest pack of floats of the instruction set that the translation unit is compiled for.
using Pack = xsimd::batch<float>;

/// Pixels per pack.
template <class A> inline constexpr int width_of<xsimd::batch<float, A>> = static_cast<int>(xsimd::batch<float, A>::size);

namespace detail {
template <class A> struct IndexOf<xsimd::batch<float, A>> { using type = xsimd::batch<std::int32_t, A>; };
template <class A> using PackOf = xsimd::batch<float, A>;
template <class A> using LanesOf = xsimd::batch<std::int32_t, A>;
template <class A> using MaskOf = xsimd::batch_bool<float, A>;
// The template argument of bitwise_cast: the resulting pack up to xsimd 10, its element type since xsimd 11.
#if XSIMD_VERSION_MAJOR < 11
template <class T, class A> using CastTo = xsimd::batch<T, A>;
#else
template <class T, class A> using CastTo = T;
#endif
} // namespace detail

// The same functions for packs.
/// @cond
template <class A> QUELL_KERNEL auto min(xsimd::batch<float, A> a, float b) { return min(a, detail::PackOf<A>(b)); }
template <class A> QUELL_KERNEL auto max(xsimd::batch<float, A> a, float b) { return max(a, detail::PackOf<A>(b)); }
template <class A> QUELL_KERNEL auto abs(xsimd::batch<float, A> a) { return xsimd::abs(a); }
template <class A> QUELL_KERNEL auto select(xsimd::batch_bool<float, A> m, xsimd::batch<float, A> a, xsimd::batch<float, A> b) {
    return xsimd::select(m, a, b);
}
template <class A> QUELL_KERNEL auto select(xsimd::batch_bool<float, A> m, float a, float b) {
    return xsimd::select(m, detail::PackOf<A>(a), detail::PackOf<A>(b));
}
template <class A> QUELL_KERNEL auto select(xsimd::batch_bool<float, A> m, xsimd::batch<float, A> a, float b) {
    return xsimd::select(m, a, detail::PackOf<A>(b));
}
template <class A> QUELL_KERNEL auto select(xsimd::batch_bool<float, A> m, float a, xsimd::batch<float, A> b) {
    return xsimd::select(m, detail::PackOf<A>(a), b);
}
template <class A> QUELL_KERNEL auto masked(xsimd::batch_bool<float, A> m, xsimd::batch<float, A> a) {
    using Batch = detail::PackOf<A>;
    if constexpr (sizeof(m) == sizeof(a)) // the mask is as wide as the pack: all bits of a lane are equal
        return a & std::bit_cast<Batch>(m);
    else
        return xsimd::select(m, a, Batch(0.f));
}
template <class A> QUELL_KERNEL bool any(xsimd::batch_bool<float, A> m) { return xsimd::any(m); }
template <class A> QUELL_KERNEL bool all(xsimd::batch_bool<float, A> m) { return xsimd::all(m); }
template <class A> QUELL_KERNEL auto fma(xsimd::batch<float, A> a, xsimd::batch<float, A> b, xsimd::batch<float, A> c) {
#if defined(__AVX512F__)
    // xsimd 8 uses two instructions for AVX-512.
    if constexpr (width_of<xsimd::batch<float, A>> == 16)
        return xsimd::batch<float, A>(_mm512_fmadd_ps(a, b, c));
    else
#endif
        return xsimd::fma(a, b, c);
}
// Not `!`: xsimd 8 splits AVX masks for it.
template <class A> QUELL_KERNEL auto invert(xsimd::batch_bool<float, A> m) { return ~m; }
template <class A> QUELL_KERNEL auto bits(xsimd::batch<float, A> a) { return xsimd::bitwise_cast<detail::CastTo<std::int32_t, A>>(a); }
template <class A> QUELL_KERNEL auto from_bits(xsimd::batch<std::int32_t, A> a) { return xsimd::bitwise_cast<detail::CastTo<float, A>>(a); }
template <class A> QUELL_KERNEL auto to_real(xsimd::batch<std::int32_t, A> a) { return xsimd::to_float(a); }
template <class A>
QUELL_KERNEL auto select_index(xsimd::batch_bool<float, A> m, xsimd::batch<std::int32_t, A> a, xsimd::batch<std::int32_t, A> b) {
    return bits(xsimd::select(m, from_bits(a), from_bits(b)));
}
/// @endcond
#endif

/// Clamps to [low, high]. NaN becomes low.
template <class Real> QUELL_KERNEL Real clamp(Real a, Real low, Real high) { return min(max(a, low), high); }

namespace detail {
alignas(64) inline constexpr float counting[] = {0.f, 1.f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f, 8.f, 9.f, 10.f, 11.f, 12.f, 13.f, 14.f, 15.f};
}

/// The index of each lane: (0, 1, 2, ...).
template <class Real> QUELL_KERNEL Real lanes() {
    if constexpr (width_of<Real> == 1)
        return 0.f;
    else
        return Real::load_aligned(detail::counting);
}

/// Lane i of a Real or Index.
QUELL_KERNEL float lane(float a, int) { return a; }
/// @cond
QUELL_KERNEL std::int32_t lane(std::int32_t a, int) { return a; }
#if !defined(__CUDACC__)
template <class T, class A> QUELL_KERNEL T lane(xsimd::batch<T, A> const& a, int i) { return a.get(static_cast<std::size_t>(i)); }
#endif
/// @endcond

namespace detail {
/// a < b for Indices, as a mask of Reals.
QUELL_KERNEL bool less_index(std::int32_t a, std::int32_t b) { return a < b; }
/// @cond
#if !defined(__CUDACC__)
template <class A> QUELL_KERNEL auto less_index(xsimd::batch<std::int32_t, A> a, xsimd::batch<std::int32_t, A> b) {
    return std::bit_cast<xsimd::batch_bool<float, A>>(a < b);
}
#endif
/// @endcond
} // namespace detail

/// True where a is neither NaN nor infinite. It compares bits: -ffast-math deletes tests on values.
template <class Real> QUELL_KERNEL auto is_finite(Real a) {
    return detail::less_index(bits(a) & Index<Real>(0x7fffffff), Index<Real>(0x7f800000));
}

/// True where the sign bit is set, -0 included.
template <class Real> QUELL_KERNEL auto sign_bit(Real a) { return detail::less_index(bits(a), Index<Real>(0)); }
/// a with its sign bit set.
template <class Real> QUELL_KERNEL Real with_sign_bit(Real a) {
    return from_bits(bits(a) | Index<Real>(std::numeric_limits<std::int32_t>::min()));
}
/// a with its sign bit cleared.
template <class Real> QUELL_KERNEL Real without_sign_bit(Real a) { return from_bits(bits(a) & Index<Real>(0x7fffffff)); }

// What a call with quell:: before it finds for a Real that records. Such a Real has functions of its own, which are found by its type
// alone; as they are no templates, these call them.
/// @cond
template <RecordingReal R> QUELL_KERNEL auto min(R a, std::type_identity_t<R> b) { return min(a, b); }
template <RecordingReal R> QUELL_KERNEL auto max(R a, std::type_identity_t<R> b) { return max(a, b); }
template <RecordingReal R> QUELL_KERNEL auto abs(R a) { return abs(a); }
template <RecordingReal R> QUELL_KERNEL auto sqrt(R a) { return sqrt(a); }
template <RecordingReal R> QUELL_KERNEL auto floor(R a) { return floor(a); }
template <RecordingReal R> QUELL_KERNEL auto fma(R a, std::type_identity_t<R> b, std::type_identity_t<R> c) { return fma(a, b, c); }
template <class Mask, RecordingReal R> QUELL_KERNEL auto select(Mask m, R a, std::type_identity_t<R> b) { return select(m, a, b); }
template <class Mask, RecordingReal R> QUELL_KERNEL auto masked(Mask m, R a) { return masked(m, a); }
template <RecordingReal R> QUELL_KERNEL auto is_finite(R a) { return is_finite(a); }
/// @endcond

/// e^a with a relative error under 3e-7. `a` is clamped to [-87, 88]. float and pack use the same instructions, without libm.
/// Cody-Waite reduction to [-ln2/2, ln2/2], then a Taylor polynomial of degree 6.
template <class Real> QUELL_KERNEL Real exp(Real a) {
    auto const x = clamp(a, Real(-87.f), Real(88.f));
    auto const n = floor(x * 1.44269504f + 0.5f);
    auto const r = fma(n, Real(2.12194440e-4f), fma(n, Real(-0.693359375f), x));
    auto p = fma(r, Real(0.00138888889f), Real(0.00833333333f));
    p = fma(r, p, Real(0.0416666667f));
    p = fma(r, p, Real(0.166666667f));
    p = fma(r, p, Real(0.5f));
    p = fma(r, p, Real(1.f));
    p = fma(r, p, Real(1.f));
    return p * from_bits((truncate(n) + Index<Real>(127)) << 23);
}

/// 1 / a with a relative error under 0.2 %, for positive normal a. Filters use it for weights, where a division would cost most of a tap.
/// An integer subtraction negates the exponent, then one tuned Newton step follows. Unlike the processor's own estimate it has the same
/// bits on every machine.
template <class Real> QUELL_KERNEL Real approximate_reciprocal(Real a) {
    auto const guess = from_bits(Index<Real>(0x7ef33000) - bits(a));
    return guess * fma(-a, guess, Real(2.001f));
}

/// 1 / sqrt(a) with a relative error under 3.5 %, for positive normal a; a large finite number at 0. Filters use it for weights, where a
/// square root and a division would cost most of a tap. Halving the bits halves the exponent, and the subtraction negates it. It has the
/// same bits on every machine.
template <class Real> QUELL_KERNEL Real approximate_inverse_sqrt(Real a) { return from_bits(Index<Real>(0x5f37642f) - (bits(a) >> 1)); }

} // namespace quell::inline QUELL_INSTRUCTION_SET
