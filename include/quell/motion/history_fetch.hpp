#pragma once

#include <quell/motion/first_valid.hpp>

namespace quell {

/// What was found of a pixel's past: the signal, what was kept there, and how far it can be trusted (0: there is no past).
template <class V, class Kept> struct Past {
    using Real = real_of<V>;
    V signal;
    Real validity;
    Real clamped; ///< how much a clamp has moved the signal, relative to itself (TRMV eq. 8)
    Kept kept;

    template <ChannelTag C> QUELL_KERNEL auto operator[](C c) const { return kept[c]; }
};

namespace detail {
template <class Px> using KeptRecord = Record<typename Px::Real, typename Px::Scope::kept_channels>;
template <class Px> using PastOf = Past<typename Px::Signal, KeptRecord<Px>>;

template <class Px> QUELL_KERNEL PastOf<Px> no_past() {
    using Real = typename Px::Real;
    return {zero<typename Px::Signal>(), Real(0.f), Real(0.f),
            make_record<Real>(
                typename Px::Scope::kept_channels{},
                [](auto c) __attribute__((always_inline)) { return zero<Value<decltype(c)::components, Real>>(); })};
}

/// A weighted sum of past pixels.
template <class Px> struct PastSum {
    using Real = typename Px::Real;
    PastOf<Px> sum = no_past<Px>();
    Real weight = Real(0.f);

    QUELL_KERNEL void add(auto const& then, Real w) {
        weight = weight + w;
        sum.signal = add_scaled(sum.signal, then.signal(), w);
        sum.kept = make_record<Real>(
            typename Px::Scope::kept_channels{}, [&](auto c)
                                                     __attribute__((always_inline)) { return add_scaled(sum.kept[c], then[c], w); });
    }
    QUELL_KERNEL PastOf<Px> mean(Real validity) const {
        auto const scale_by = select(weight > Real(0.f), 1.f / weight, Real(0.f));
        return {
            scale(sum.signal, scale_by), select(weight > Real(0.f), validity, Real(0.f)), Real(0.f),
            make_record<Real>(
                typename Px::Scope::kept_channels{}, [&](auto c) __attribute__((always_inline)) { return scale(sum.kept[c], scale_by); })};
    }
};

/// One past pixel near a reprojected position: its coordinates made safe to read, and whether it counts.
template <class Px, class FoundPlace>
QUELL_KERNEL auto past_tap(Px const& px, FoundPlace const& found, typename Px::Real column, typename Px::Real row) {
    using Real = typename Px::Real;
    Real const last_column(static_cast<float>(px.size().width - 1)), last_row(static_cast<float>(px.size().height - 1));
    auto const inside = (column >= Real(0.f)) & (column <= last_column) & (row >= Real(0.f)) & (row <= last_row);
    auto const then = px.past(truncate(clamp(column, Real(0.f), last_column)), truncate(clamp(row, Real(0.f), last_row)));
    auto const accepted = inside & accepts(found, then, column + 0.5f - found.where.x, row + 0.5f - found.where.y);
    struct Tap {
        decltype(px.past(truncate(column), truncate(row))) then;
        decltype(inside & accepts(found, then, column, row)) accepted;
    };
    return Tap{then, accepted};
}

/// A position that is not finite or not in the image becomes a harmless one with validity 0: what was outside was never seen.
template <class Px, class FoundPlace> QUELL_KERNEL auto sane(Px const& px, FoundPlace found) {
    using Real = typename Px::Real;
    Real const right(static_cast<float>(px.size().width)), bottom(static_cast<float>(px.size().height));
    auto const usable = is_finite(found.where.x) & is_finite(found.where.y) & is_finite(found.validity) & (found.validity > Real(0.f)) &
                        (found.where.x >= Real(0.f)) & (found.where.x <= right) & (found.where.y >= Real(0.f)) & (found.where.y <= bottom);
    found.where = vec2<Real>{select(usable, found.where.x, Real(0.f)), select(usable, found.where.y, Real(0.f))};
    found.validity = select(usable, found.validity, Real(0.f));
    return found;
}

/// Looks for any acceptable past pixel in the 3x3 around the position: for lanes where interpolation found none.
template <class Px, class FoundPlace> QUELL_KERNEL PastSum<Px> rescued(Px const& px, FoundPlace const& found, PastSum<Px> sum) {
    using Real = typename Px::Real;
    auto const wanted = (sum.weight <= Real(0.f)) & (found.validity > Real(0.f));
    if (!any(wanted)) return sum;
    auto const column = floor(found.where.x), row = floor(found.where.y);
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            auto const tap = past_tap(px, found, column + static_cast<float>(i), row + static_cast<float>(j));
            sum.add(tap.then, select(wanted & tap.accepted, Real(1.f), Real(0.f)));
        }
    return sum;
}
} // namespace detail

/// History at a position between pixels from the four nearest, each tested, weights renormalised over those that pass; where none does,
/// from whatever passes in the 3x3 around. (METHODS section 1)
struct Bilinear {
    bool rescue = true;

    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& unchecked) const {
        using Real = typename Px::Real;
        auto const found = detail::sane(px, unchecked);
        auto const column = floor(found.where.x - 0.5f), row = floor(found.where.y - 0.5f);
        auto const u = found.where.x - 0.5f - column, v = found.where.y - 0.5f - row;
        detail::PastSum<Px> sum;
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                auto const bilinear = (i == 0 ? 1.f - u : u) * (j == 0 ? 1.f - v : v);
                // Still pixels need one tap of the four.
                if (!any(bilinear > Real(0.f))) continue;
                auto const tap = detail::past_tap(px, found, column + static_cast<float>(i), row + static_cast<float>(j));
                sum.add(tap.then, select(tap.accepted, bilinear, Real(0.f)));
            }
        // A sliver of a tap is no interpolation: let the wider search decide.
        auto const enough = sum.weight > Real(0.01f);
        auto kept = sum;
        kept.weight = select(enough, sum.weight, Real(0.f));
        if (!rescue) return kept.mean(found.validity);
        if (!any(invert(enough) & (found.validity > Real(0.f)))) return kept.mean(found.validity);
        auto const wider = detail::rescued(px, found, clear(kept, enough));
        return wider.mean(found.validity);
    }

private:
    /// The sums of lanes that found too little start again from nothing.
    template <class Sum, class Mask> QUELL_KERNEL static Sum clear(Sum sum, Mask enough) {
        using Real = typename Sum::Real;
        sum.sum.signal = select(enough, sum.sum.signal, zero<decltype(sum.sum.signal)>());
        sum.sum.kept = make_record<Real>(
            typename decltype(sum.sum.kept)::channels{}, [&](auto c) __attribute__((always_inline)) {
                return select(enough, sum.sum.kept[c], zero<decltype(sum.sum.kept[c])>());
            });
        return sum;
    }
};

} // namespace quell
