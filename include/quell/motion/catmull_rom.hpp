#pragma once

#include <quell/motion/history_fetch.hpp>

namespace quell {

/// History by the sharper Catmull-Rom spline over 4x4 pixels where every one of them is accepted, else Bilinear. What is kept beside the
/// signal (lengths, moments) stays bilinear: a spline's negative lobes mean nothing there.
struct CatmullRom {
    Bilinear elsewhere{};

    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& unchecked) const {
        using Real = typename Px::Real;
        auto past = elsewhere.fetch(px, unchecked);
        auto const spline = interpolated(
            px, unchecked, past.validity > Real(0.f), [](auto const& then) __attribute__((always_inline)) { return then.signal(); });
        past.signal = select(spline.accepted, spline.value, past.signal);
        return past;
    }

    /// Any value of past pixels, where all sixteen are accepted.
    template <class Px, class FoundPlace, class Mask, class ValueOf>
    QUELL_KERNEL static auto interpolated(Px const& px, FoundPlace const& unchecked, Mask accepted, ValueOf&& value_of) {
        using Real = typename Px::Real;
        auto const found = detail::sane(px, unchecked);
        auto const column = floor(found.where.x - 0.5f), row = floor(found.where.y - 0.5f);
        auto const across = weights(found.where.x - 0.5f - column), down = weights(found.where.y - 0.5f - row);
        PastPlace<Real> const place(column, row);
        using V = std::remove_cvref_t<decltype(value_of(px.past(place)))>;
        auto sum = zero<V>();
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                auto const then = px.past(place, i - 1, j - 1);
                accepted = both(accepted, detail::counts<Real>(then, found));
                sum = add_scaled(sum, value_of(then), across.at[i] * down.at[j]);
            }
        // The negative lobes overshoot at bright edges; light is never negative.
        auto const bounded = map(
            [](auto a) __attribute__((always_inline)) { return max(a, Real(0.f)); }, sum);
        return detail::Interpolated<V, Mask>{bounded, accepted};
    }

private:
    template <class Real> QUELL_KERNEL static Components<4, Real> weights(Real t) {
        auto const t2 = t * t, t3 = t2 * t;
        return {{-0.5f * t3 + t2 - 0.5f * t, 1.5f * t3 - 2.5f * t2 + 1.f, -1.5f * t3 + 2.f * t2 + 0.5f * t, 0.5f * t3 - 0.5f * t2}};
    }
};

} // namespace quell
