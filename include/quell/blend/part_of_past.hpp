#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Blends with `part` of the history's usual weight: alpha becomes 1 - part (1 - alpha).
/// @param part 0 to 1
template <class Inner, class Px, class P>
QUELL_KERNEL auto blend_part_of_past(Inner const& inner, Px const& px, P past, typename Px::Real part) {
    using Real = typename Px::Real;
    if constexpr (keeps_of<Inner>::template has<HistoryLength>) {
        // A running mean scales its history length by validity, and alpha is 1 / (frames + 1). This solves for the validity.
        auto const whole = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const frames = 1.f / (1.f - part * (1.f - whole.alpha)) - 1.f;
        past.validity = select(part < Real(1.f), frames / max(past[history_length], Real(1e-6f)), past.validity);
    } else
        past.validity = past.validity * part;
    return inner.blend(px, past);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
