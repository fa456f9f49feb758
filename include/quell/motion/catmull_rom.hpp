#pragma once

#include <quell/frame/hull.hpp>
#include <quell/motion/history_fetch.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Weights of a Catmull-Rom spline for the taps -1 to +2, at t between 0 and 1.
template <class Real> QUELL_KERNEL Components<4, Real> catmull_rom_weights(Real t) {
    auto const t2 = t * t, t3 = t2 * t;
    return {{-0.5f * t3 + t2 - 0.5f * t, 1.5f * t3 - 2.5f * t2 + 1.f, -1.5f * t3 + 2.f * t2 + 0.5f * t, 0.5f * t3 - 0.5f * t2}};
}
} // namespace detail

/// History fetch by a Catmull-Rom spline over 4x4 pixels, sharper than Bilinear. Taps that are not accepted are replaced by the bilinear
/// mean, so outlines stay sharp too. The result is limited to what the taps hold, since a spline overshoots at bright edges. Kept channels
/// (history length, moments) are interpolated bilinearly: negative lobes have no meaning for them.
struct CatmullRom {
    static constexpr int farthest_tap = 0;
    Bilinear elsewhere{}; ///< fetches kept channels, and the replacement of rejected taps

    /// The HistorySample at the position that a motion source found.
    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& unchecked) const {
        auto past = elsewhere.fetch(px, unchecked);
        auto const known = past.validity > typename Px::Real(0.f);
        if (any(known)) {
            auto const spline = interpolated(px, unchecked, past.signal, [](auto const& then) QUELL_INLINED { return then.signal(); });
            past.signal = select(known, spline, past.signal);
        }
        return past;
    }

    /// Interpolates any value of past pixels.
    /// @tparam Limits    of the taps: Hull, or the like
    /// @param px        the pixel
    /// @param unchecked what a motion source found
    /// @param smooth    the bilinear mean, which replaces rejected taps
    /// @param value_of  value_of(past pixel): the value to interpolate
    template <template <class> class Limits = detail::Hull, class Px, class FoundPlace, class V, class ValueOf>
    QUELL_KERNEL static V interpolated(Px const& px, FoundPlace const& unchecked, V const& smooth, ValueOf&& value_of) {
        using Real = typename Px::Real;
        auto const found = detail::sane(px, unchecked);
        auto const column = floor(found.where.x - 0.5f), row = floor(found.where.y - 0.5f);
        auto const across = detail::catmull_rom_weights(found.where.x - 0.5f - column),
                   down = detail::catmull_rom_weights(found.where.y - 0.5f - row);
        PixelCoordinates<Real> const place(column, row);
        auto sum = zero<V>();
        Limits<V> limits(smooth);
        Real known(0.f);
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                auto const then = px.past(place, i - 1, j - 1);
                auto const value = value_of(then);
                auto const counts = detail::counts<Real>(then, found);
                auto const weight = masked(counts, across.at[i] * down.at[j]);
                sum = add_scaled(sum, value, weight);
                known = known + weight;
                limits.add(value, counts);
            }
        return limits.limited(add_scaled(sum, smooth, 1.f - known));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
