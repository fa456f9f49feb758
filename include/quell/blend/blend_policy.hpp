#pragma once

#include <quell/blend/blend_memory.hpp>
#include <quell/motion/history_fetch.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Blends a pixel's new sample with its history. A policy has one function:
///
///     auto blend(auto px, auto past) const      // the new value, or Result{value, alpha}.with(channel it `keeps`, value)...
///
/// `px.signal()` is the new sample. `past` is a HistorySample: its signal, its validity (0: no history), and `past[channel]` for what the
/// policy `keeps`, which is 0 without history. A missing sample changes nothing: Temporal then keeps the history, whatever the policy
/// returns. A decorator adds a channel to what another policy returns, a value or a Result, by `Result{inner.blend(px, past)}.with(channel,
/// value)`. A policy may declare how far back it remembers, by `constexpr BlendMemory memory() const`: see quell/blend/blend_memory.hpp.
template <class B>
concept BlendPolicy = std::is_trivially_copyable_v<B> &&
    requires(B const b, detail::Probe<B> px, detail::HistorySampleOf<detail::Probe<B>> past) {
    { detail::as_result(b.blend(px, past)).value } -> std::convertible_to<typename detail::Probe<B>::Signal>;
};

/// past + alpha (now - past), the exponential blend that most policies end in. `alpha` is the weight of the new sample, from
/// 0 to 1.
template <class Px, class P> QUELL_KERNEL auto accumulate(Px const& px, P const& past, typename Px::Real alpha) {
    auto const now = px.signal();
    // mix() would round: alpha 1 must return `now` exactly, even beside a much larger past.
    auto const fresh = alpha >= typename Px::Real(1.f);
    return Result<typename Px::Signal>{select(fresh, now, mix(past.signal, now, alpha)), alpha, {}};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
