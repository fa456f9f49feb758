#pragma once

#include <quell/motion/history_fetch.hpp>

namespace quell {

/// Joins a pixel's present with its past:
///     auto blend(auto px, auto past) const -> the new value, or Result{value, alpha}.with(channel it `keeps`, value)...
/// `px.signal()` is the present; `past` is a Past: signal, validity (0: none), clamped, and past[channel] for what the policy `keeps`,
/// which is 0 where validity is. Missing samples never reach a policy's result: the stage keeps the past instead.
template <class B>
concept BlendPolicy = std::is_trivially_copyable_v<B> && requires(B const b, detail::Probe<B> px, detail::PastOf<detail::Probe<B>> past) {
    { detail::as_result(b.blend(px, past)).value } -> std::convertible_to<typename detail::Probe<B>::Signal>;
};

/// past + alpha (now - past): what most blend policies come down to, once they know alpha.
template <class Px, class P> QUELL_KERNEL auto accumulate(Px const& px, P const& past, typename Px::Real alpha) {
    auto const now = px.signal();
    // alpha 1 must give `now` to the last bit, also where the past is much larger.
    auto const fresh = alpha >= typename Px::Real(1.f);
    return Result<typename Px::Signal>{select(fresh, now, mix(past.signal, now, alpha)), alpha, {}};
}

} // namespace quell
