#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The pack of half the width, and whether packs can be put together from two of it. Only AVX-512 needs that: elsewhere no pass has packs
/// that are narrower than those of the instruction set.
template <class Real> struct HalfPack {
    using type = Real;
    static constexpr bool joins = false;
};

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && !defined(__CUDACC__)
template <class A>
    requires(width_of<xsimd::batch<float, A>> == 16)
struct HalfPack<xsimd::batch<float, A>> {
    using type = xsimd::make_sized_batch_t<float, std::size_t{8}>;
    static constexpr bool joins = width_of<type> == 8;
};

/// A pack of the lanes of two: those of `first`, then those of `second`.
template <class Real> QUELL_KERNEL Real joined_halves(typename HalfPack<Real>::type first, typename HalfPack<Real>::type second) {
    return Real(_mm512_insertf32x8(_mm512_castps256_ps512(first), second, 1));
}
/// The lanes of the first half.
template <class Real> QUELL_KERNEL typename HalfPack<Real>::type first_half(Real both) { return {_mm512_castps512_ps256(both)}; }
/// The lanes of the second half.
template <class Real> QUELL_KERNEL typename HalfPack<Real>::type second_half(Real both) { return {_mm512_extractf32x8_ps(both, 1)}; }
#else
// Never called: HalfPack<Real>::joins is false.
template <class Real> Real joined_halves(typename HalfPack<Real>::type, typename HalfPack<Real>::type);
template <class Real> typename HalfPack<Real>::type first_half(Real);
template <class Real> typename HalfPack<Real>::type second_half(Real);
#endif

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
