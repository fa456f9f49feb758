#pragma once

#include <quell/shader/recorded_integer.hpp>

/// @file
/// The Real over which a kernel is recorded.

namespace quell::inline QUELL_INSTRUCTION_SET {

struct Recorded;
/// It does.
template <> inline constexpr bool records<Recorded> = true;

/// A number of a pixel, recorded: a handle of a node of a PassGraph. It computes nothing: what is done to it becomes further nodes.
struct Recorded {
    std::int32_t node; ///< its number in the graph

    Recorded() = default; ///< without meaning
    /// A constant.
    Recorded(float a) : Recorded(detail::recorded_leaf<Recorded>(Operation::constant, std::bit_cast<std::uint32_t>(a))) {}
    /// @cond
    template <class T>
        requires std::is_arithmetic_v<T>
    explicit operator T() const {
        static_assert(detail::never<T>, "a policy takes what it computes of a pixel for a number of the host, which cannot be recorded: "
                                        "write it over `typename decltype(px)::Real`, and use truncate(a) in place of a cast");
        return T();
    }
    [[nodiscard]] float constant() const { return std::bit_cast<float>(detail::node_at(node).payload); }
    using Integer = RecordedInteger;
    using Mask = RecordedMask;

private:
    template <class Result, class Compute, class... Of> static Result made(Operation operation, Compute compute, Of... of) {
        if (detail::are_constant(of...)) return Result(compute(of.constant()...));
        return detail::recorded<Result>(operation, of...);
    }

public:
    friend Recorded operator+(Recorded a, Recorded b) {
        return made<Recorded>(
            Operation::add, [](float x, float y) { return x + y; }, a, b);
    }
    friend Recorded operator-(Recorded a, Recorded b) {
        return made<Recorded>(
            Operation::subtract, [](float x, float y) { return x - y; }, a, b);
    }
    friend Recorded operator*(Recorded a, Recorded b) {
        return made<Recorded>(
            Operation::multiply, [](float x, float y) { return x * y; }, a, b);
    }
    friend Recorded operator/(Recorded a, Recorded b) {
        return made<Recorded>(
            Operation::divide, [](float x, float y) { return x / y; }, a, b);
    }
    friend Mask operator<(Recorded a, Recorded b) {
        return made<Mask>(
            Operation::less, [](float x, float y) { return x < y; }, a, b);
    }
    friend Mask operator<=(Recorded a, Recorded b) {
        return made<Mask>(
            Operation::less_equal, [](float x, float y) { return x <= y; }, a, b);
    }
    friend Mask operator>(Recorded a, Recorded b) {
        return made<Mask>(
            Operation::greater, [](float x, float y) { return x > y; }, a, b);
    }
    friend Mask operator>=(Recorded a, Recorded b) {
        return made<Mask>(
            Operation::greater_equal, [](float x, float y) { return x >= y; }, a, b);
    }
    friend Mask operator==(Recorded a, Recorded b) {
        return made<Mask>(
            Operation::equal, [](float x, float y) { return x == y; }, a, b);
    }
    friend Mask operator!=(Recorded a, Recorded b) {
        return made<Mask>(
            Operation::not_equal, [](float x, float y) { return x != y; }, a, b);
    }
    friend Recorded operator-(Recorded a) {
        return made<Recorded>(
            Operation::negate, [](float x) { return -x; }, a);
    }
    friend Recorded operator+(Recorded a) { return a; }
    friend Recorded& operator+=(Recorded& a, Recorded b) { return a = a + b; }
    friend Recorded& operator-=(Recorded& a, Recorded b) { return a = a - b; }
    friend Recorded& operator*=(Recorded& a, Recorded b) { return a = a * b; }
    friend Recorded& operator/=(Recorded& a, Recorded b) { return a = a / b; }
    friend Recorded min(Recorded a, Recorded b) {
        return made<Recorded>(
            Operation::minimum, [](float x, float y) { return quell::min(x, y); }, a, b);
    }
    friend Recorded max(Recorded a, Recorded b) {
        return made<Recorded>(
            Operation::maximum, [](float x, float y) { return quell::max(x, y); }, a, b);
    }
    friend Recorded abs(Recorded a) {
        return made<Recorded>(
            Operation::absolute, [](float x) { return quell::abs(x); }, a);
    }
    friend Recorded sqrt(Recorded a) {
        return made<Recorded>(
            Operation::square_root, [](float x) { return quell::sqrt(x); }, a);
    }
    friend Recorded floor(Recorded a) {
        return made<Recorded>(
            Operation::floor, [](float x) { return quell::floor(x); }, a);
    }
    friend Recorded fma(Recorded a, Recorded b, Recorded c) {
        return made<Recorded>(
            Operation::fused, [](float x, float y, float z) { return quell::fma(x, y, z); }, a, b, c);
    }
    friend Recorded clamp(Recorded a, Recorded low, Recorded high) { return min(max(a, low), high); }
    friend Recorded select(Mask m, Recorded a, Recorded b) {
        if (m.is_constant() || a.node == b.node) return m.is_constant() && !m.constant() ? b : a;
        return detail::recorded<Recorded>(Operation::select, m, a, b);
    }
    friend Recorded masked(Mask m, Recorded a) { return select(m, a, Recorded(0.f)); }
    friend Mask is_finite(Recorded a) {
        return made<Mask>(
            Operation::is_finite, [](float x) { return quell::is_finite(x); }, a);
    }
    friend Mask sign_bit(Recorded a) {
        return made<Mask>(
            Operation::sign_bit, [](float x) { return quell::sign_bit(x); }, a);
    }
    friend Integer bits(Recorded a) {
        return made<Integer>(
            Operation::to_bits, [](float x) { return quell::bits(x); }, a);
    }
    friend Integer truncate(Recorded a) {
        return made<Integer>(
            Operation::truncate, [](float x) { return quell::truncate(x); }, a);
    }
    /// @endcond
};

/// @cond
inline Recorded from_bits(RecordedInteger a) {
    return a.is_constant() ? Recorded(from_bits(a.constant())) : detail::recorded<Recorded>(Operation::from_bits, a);
}
inline Recorded to_real(RecordedInteger a) {
    return a.is_constant() ? Recorded(to_real(a.constant())) : detail::recorded<Recorded>(Operation::to_real, a);
}
inline Recorded select(RecordedMask mask, float a, float b) { return select(mask, Recorded(a), Recorded(b)); }
/// select() for values of several components.
template <class V>
    requires(components_of<V> > 1)
V select(RecordedMask mask, V const& a, V const& b) {
    return map([&](auto x, auto y) { return select(mask, x, y); }, a, b);
}
// A recorded number is of one pixel: its only lane.
inline Recorded lane(Recorded a, int) { return a; }
/// @endcond

namespace detail {
template <> struct IndexOf<Recorded> { using type = RecordedInteger; };
template <> struct CoordinateOf<Recorded> { using type = RecordedInteger; };
/// A word of the block of uniforms.
inline Recorded uniform(int word) { return recorded_leaf<Recorded>(Operation::uniform, static_cast<std::uint32_t>(word)); }
inline RecordedInteger uniform_integer(int word) {
    return recorded_leaf<RecordedInteger>(Operation::uniform_integer, static_cast<std::uint32_t>(word));
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

/// GLM needs this for vectors of recorded numbers.
template <> struct std::numeric_limits<quell::Recorded> : std::numeric_limits<float> {};
