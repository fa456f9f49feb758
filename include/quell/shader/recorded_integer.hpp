#pragma once

#include <quell/core/random.hpp>
#include <quell/core/recording.hpp>
#include <quell/core/value.hpp>
#include <quell/shader/pass_graph.hpp>

#include <concepts>
#include <limits>
#include <type_traits>

/// @file
/// The numbers over which a kernel is recorded: handles of the nodes of a PassGraph. What branches on one does not compile.

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Of the pass that this thread records.
inline thread_local GraphBuilder* graph_builder = nullptr;
template <class> inline constexpr bool never = false;

inline Node const& node_at(std::int32_t number) { return (*graph_builder)[number]; }
/// A handle of a new node, or of an equal one.
template <class Handle, class... Operands> Handle recorded(Operation operation, Operands... of) {
    Handle made;
    made.node = graph_builder->add({operation, {of.node...}});
    return made;
}
template <class Handle> Handle recorded_leaf(Operation operation, std::uint32_t payload) {
    Handle made;
    made.node = graph_builder->add({operation, {}, payload});
    return made;
}
template <class... Handles> bool are_constant(Handles... handles) { return (node_at(handles.node).is_constant() && ...); }
} // namespace detail

/// A truth value of a pixel, recorded.
struct RecordedMask {
    std::int32_t node; ///< its number in the graph

    RecordedMask() = default; ///< without meaning
    /// A constant.
    RecordedMask(bool a) : RecordedMask(detail::recorded_leaf<RecordedMask>(Operation::constant_mask, a)) {}
    /// @cond
    template <std::same_as<bool> B> explicit operator B() const {
        static_assert(detail::never<B>, "a policy branches on what it computes of a pixel, which cannot be recorded: use select(mask, a, "
                                        "b) or masked(mask, a); and if (any(mask)) around what few pixels need");
        return false;
    }
    [[nodiscard]] bool is_constant() const { return detail::are_constant(*this); }
    [[nodiscard]] bool constant() const { return detail::node_at(node).payload != 0; }
    friend RecordedMask operator&(RecordedMask a, RecordedMask b) {
        if (a.is_constant()) return a.constant() ? b : a;
        if (b.is_constant()) return b.constant() ? a : b;
        return a.node == b.node ? a : detail::recorded<RecordedMask>(Operation::both, a, b);
    }
    friend RecordedMask operator|(RecordedMask a, RecordedMask b) {
        if (a.is_constant()) return a.constant() ? a : b;
        if (b.is_constant()) return b.constant() ? b : a;
        return a.node == b.node ? a : detail::recorded<RecordedMask>(Operation::either, a, b);
    }
    friend RecordedMask invert(RecordedMask a) {
        return a.is_constant() ? RecordedMask(!a.constant()) : detail::recorded<RecordedMask>(Operation::invert, a);
    }
    friend RecordedMask operator~(RecordedMask a) { return invert(a); }
    friend RecordedMask operator!(RecordedMask a) { return invert(a); }
    // Some pixel wants the rest, and not every pixel does.
    friend bool any(RecordedMask a) { return !a.is_constant() || a.constant(); }
    friend bool all(RecordedMask a) { return a.is_constant() && a.constant(); }
    /// @endcond
};

/// A 32-bit integer of a pixel, recorded: a column or row, or bits of a number.
struct RecordedInteger {
    std::int32_t node; ///< its number in the graph

    RecordedInteger() = default; ///< without meaning
    /// A constant.
    RecordedInteger(std::int32_t a)
        : RecordedInteger(detail::recorded_leaf<RecordedInteger>(Operation::constant_integer, static_cast<std::uint32_t>(a))) {}
    /// @cond
    template <class T>
        requires std::is_arithmetic_v<T>
    explicit operator T() const {
        static_assert(detail::never<T>,
                      "a policy takes a column, a row, a size or bits for a number of the host, which cannot be recorded: "
                      "use to_real(integer) in place of a cast, and select_index(mask, a, b) in place of a branch");
        return T();
    }
    [[nodiscard]] bool is_constant() const { return detail::are_constant(*this); }
    [[nodiscard]] std::int32_t constant() const { return static_cast<std::int32_t>(detail::node_at(node).payload); }

private:
    template <class Compute> static RecordedInteger made(Operation operation, Compute compute, RecordedInteger a, RecordedInteger b) {
        if (!detail::are_constant(a, b)) return detail::recorded<RecordedInteger>(operation, a, b);
        auto const bits = [](RecordedInteger i) { return static_cast<std::uint32_t>(i.constant()); };
        return {static_cast<std::int32_t>(compute(bits(a), bits(b)))};
    }
    using Bits = std::uint32_t;

public:
    friend RecordedInteger operator+(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::add_integer, [](Bits i, Bits j) { return i + j; }, a, b);
    }
    friend RecordedInteger operator-(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::subtract_integer, [](Bits i, Bits j) { return i - j; }, a, b);
    }
    friend RecordedInteger operator-(RecordedInteger a) { return 0 - a; }
    friend RecordedInteger operator*(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::multiply_integer, [](Bits i, Bits j) { return i * j; }, a, b);
    }
    friend RecordedInteger operator&(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::and_integer, [](Bits i, Bits j) { return i & j; }, a, b);
    }
    friend RecordedInteger operator|(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::or_integer, [](Bits i, Bits j) { return i | j; }, a, b);
    }
    friend RecordedInteger operator^(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::xor_integer, [](Bits i, Bits j) { return i ^ j; }, a, b);
    }
    friend RecordedInteger operator<<(RecordedInteger a, RecordedInteger b) {
        return made(
            Operation::shift_left, [](Bits i, Bits j) { return i << j; }, a, b);
    }
    friend RecordedInteger operator>>(RecordedInteger a, RecordedInteger b) { // with the sign
        return made(
            Operation::shift_right, [](Bits i, Bits j) { return static_cast<Bits>(static_cast<std::int32_t>(i) >> j); }, a, b);
    }
    friend RecordedInteger wrapping_product(RecordedInteger a, std::int32_t b) { return a * b; }
    friend RecordedMask less_index(RecordedInteger a, RecordedInteger b) {
        if (detail::are_constant(a, b)) return {a.constant() < b.constant()};
        return detail::recorded<RecordedMask>(Operation::less_integer, a, b);
    }
    friend RecordedMask operator<(RecordedInteger a, RecordedInteger b) { return less_index(a, b); }
    friend RecordedMask operator>(RecordedInteger a, RecordedInteger b) { return less_index(b, a); }
    friend RecordedMask operator<=(RecordedInteger a, RecordedInteger b) { return invert(less_index(b, a)); }
    friend RecordedMask operator>=(RecordedInteger a, RecordedInteger b) { return invert(less_index(a, b)); }
    friend RecordedMask operator==(RecordedInteger a, RecordedInteger b) {
        return detail::are_constant(a, b) ? RecordedMask(a.constant() == b.constant())
                                          : detail::recorded<RecordedMask>(Operation::equal_integer, a, b);
    }
    friend RecordedMask operator!=(RecordedInteger a, RecordedInteger b) { return invert(a == b); }
    friend RecordedInteger select_index(RecordedMask m, RecordedInteger a, RecordedInteger b) {
        if (m.is_constant() || a.node == b.node) return m.is_constant() && !m.constant() ? b : a;
        return detail::recorded<RecordedInteger>(Operation::select_integer, m, a, b);
    }
    /// a in [low, high].
    friend RecordedInteger clamped(RecordedInteger a, RecordedInteger low, RecordedInteger high) {
        return detail::recorded<RecordedInteger>(Operation::clamp_integer, a, low, high);
    }
    friend RecordedInteger lane(RecordedInteger a, int) { return a; }
    /// @endcond
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
