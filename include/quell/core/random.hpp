#pragma once

#include <quell/core/real.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// a * b modulo 2^32.
QUELL_KERNEL std::int32_t wrapping_product(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
}
#if !defined(__CUDACC__)
template <class A> QUELL_KERNEL auto wrapping_product(xsimd::batch<std::int32_t, A> const& a, std::int32_t b) {
    return a * xsimd::batch<std::int32_t, A>(b);
}
#endif
/// a >> n with zeros shifted in.
template <int n, class Integer> QUELL_KERNEL Integer logical_shift(Integer const& a) { return (a >> n) & Integer((1 << (32 - n)) - 1); }

/// A 32-bit hash: each bit of the result depends on each bit of `a`. Multipliers: Wellons (hash prospector, 2018).
template <class Integer> QUELL_KERNEL Integer scrambled(Integer a) {
    a = a ^ logical_shift<16>(a);
    a = wrapping_product(a, 0x7feb352d);
    a = a ^ logical_shift<15>(a);
    a = wrapping_product(a, static_cast<std::int32_t>(0x846ca68bu));
    return a ^ logical_shift<16>(a);
}

/// An approximately normal number, mean 0 and standard deviation 1, in [-3.46, 3.46]: the sum of the four bytes of random bits.
template <class Real> QUELL_KERNEL Real normal_from_bits(Index<Real> const& bits) {
    auto const byte = Index<Real>(255);
    auto const sum = (bits & byte) + ((bits >> 8) & byte) + ((bits >> 16) & byte) + ((bits >> 24) & byte);
    return (to_real(sum) - 510.f) * (1.f / 147.8022f);
}
/// Two independent words of 32 random bits: a function of three whole numbers.
template <class Real> QUELL_KERNEL auto random_bits(Real column, Real row, std::int32_t frame) {
    auto const seed = scrambled(truncate(row) + Index<Real>(wrapping_product(frame, 0x51ed270b)));
    auto const first = scrambled(truncate(column) ^ seed);
    return std::pair{first, scrambled(first + Index<Real>(1))};
}
/// A uniform number in [0, 1) from the upper 23 bits.
template <class Real> QUELL_KERNEL Real uniform_from_bits(Index<Real> const& bits) {
    return from_bits(logical_shift<9>(bits) | Index<Real>(0x3f800000)) - 1.f;
}
} // namespace detail

/// Two independent, approximately normal numbers of mean 0 and standard deviation 1, in [-3.46, 3.46]. They are a function of the
/// arguments.
/// @param column pixel column, a whole number
/// @param row    pixel row, a whole number
/// @param frame  the frame's number, or any other seed
template <class Real> QUELL_KERNEL std::pair<Real, Real> normal_pair(Real column, Real row, std::int32_t frame) {
    auto const [first, second] = detail::random_bits(column, row, frame);
    return {detail::normal_from_bits<Real>(first), detail::normal_from_bits<Real>(second)};
}
/// As normal_pair, but uniform in [0, 1).
template <class Real> QUELL_KERNEL std::pair<Real, Real> uniform_pair(Real column, Real row, std::int32_t frame) {
    auto const [first, second] = detail::random_bits(column, row, frame);
    return {detail::uniform_from_bits<Real>(first), detail::uniform_from_bits<Real>(second)};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
