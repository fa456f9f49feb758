#pragma once

#include <quell/core/real.hpp>

namespace quell {

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
/// a >> n with zeros coming in.
template <int n, class Integer> QUELL_KERNEL Integer logical_shift(Integer const& a) { return (a >> n) & Integer((1 << (32 - n)) - 1); }

/// Scrambles the bits of a number: each bit of the result depends on each bit of it. The multipliers are Wellons' (hash prospector, 2018).
template <class Integer> QUELL_KERNEL Integer scrambled(Integer a) {
    a = a ^ logical_shift<16>(a);
    a = wrapping_product(a, 0x7feb352d);
    a = a ^ logical_shift<15>(a);
    a = wrapping_product(a, static_cast<std::int32_t>(0x846ca68bu));
    return a ^ logical_shift<16>(a);
}

/// A normally distributed number of mean 0 and deviation 1 from random bits: the sum of their four bytes. It never leaves [-3.46, 3.46].
template <class Real> QUELL_KERNEL Real normal_from_bits(Index<Real> const& bits) {
    auto const byte = Index<Real>(255);
    auto const sum = (bits & byte) + ((bits >> 8) & byte) + ((bits >> 16) & byte) + ((bits >> 24) & byte);
    return (to_real(sum) - 510.f) * (1.f / 147.8022f);
}
/// Two independent sets of 32 random bits, always the same for the same three whole numbers.
template <class Real> QUELL_KERNEL auto random_bits(Real column, Real row, std::int32_t frame) {
    auto const seed = scrambled(truncate(row) + Index<Real>(wrapping_product(frame, 0x51ed270b)));
    auto const first = scrambled(truncate(column) ^ seed);
    return std::pair{first, scrambled(first + Index<Real>(1))};
}
/// A uniformly distributed number in [0, 1) from the upper 23 of random bits.
template <class Real> QUELL_KERNEL Real uniform_from_bits(Index<Real> const& bits) {
    return from_bits(logical_shift<9>(bits) | Index<Real>(0x3f800000)) - 1.f;
}
} // namespace detail

/// Two independent, normally distributed numbers of mean 0 and deviation 1, always the same for the same three whole numbers.
/// @param column, row whole numbers
template <class Real> QUELL_KERNEL std::pair<Real, Real> normal_pair(Real column, Real row, std::int32_t frame) {
    auto const [first, second] = detail::random_bits(column, row, frame);
    return {detail::normal_from_bits<Real>(first), detail::normal_from_bits<Real>(second)};
}
/// The same, uniformly distributed in [0, 1).
template <class Real> QUELL_KERNEL std::pair<Real, Real> uniform_pair(Real column, Real row, std::int32_t frame) {
    auto const [first, second] = detail::random_bits(column, row, frame);
    return {detail::uniform_from_bits<Real>(first), detail::uniform_from_bits<Real>(second)};
}

} // namespace quell
