#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The least and the greatest of several values, per component. What is computed from the values is limited to it, so that nothing is
/// brighter or darker than all that was looked at.
template <class V> struct Hull {
    V low, high;

    QUELL_KERNEL explicit Hull(V const& first) : low(first), high(first) {}
    QUELL_KERNEL Hull(V const& least, V const& greatest) : low(least), high(greatest) {}
    QUELL_KERNEL void add(V const& v) {
        low = map([](auto a, auto b) QUELL_INLINED { return min(a, b); }, low, v);
        high = map([](auto a, auto b) QUELL_INLINED { return max(a, b); }, high, v);
    }
    /// Adds a value in those lanes of a pack that count.
    QUELL_KERNEL void add(V const& v, auto counts) {
        low = map([&](auto a, auto b) QUELL_INLINED { return select(counts, min(a, b), a); }, low, v);
        high = map([&](auto a, auto b) QUELL_INLINED { return select(counts, max(a, b), a); }, high, v);
    }
    [[nodiscard]] QUELL_KERNEL V limited(V const& v) const {
        return map([](auto a, auto least, auto greatest) QUELL_INLINED { return clamp(a, least, greatest); }, v, low, high);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
