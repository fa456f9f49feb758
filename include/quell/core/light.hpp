#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Largest component that counts as light: sums of its square stay finite.
inline constexpr float brightest_sample = 1e16f;
/// Whether all components are finite and at most brightest_sample, and the luminance is not negative. A negative component is a colour
/// outside the gamut.
template <class V> QUELL_KERNEL auto is_light(V const& v) {
    using Real = real_of<V>;
    return fold([](auto sofar, auto a) QUELL_INLINED { return both(sofar, is_finite(a), abs(a) <= Real(brightest_sample)); },
                luminance(v) >= Real(0.f), v);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
