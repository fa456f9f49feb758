#pragma once

#include <quell/motion/first_valid.hpp>

namespace quell {

/// What was found of a pixel's past: the signal, what was kept there, and how far it can be trusted (0: there is no past).
template <class V, class Kept> struct Past {
    using Real = real_of<V>;
    V signal;
    vec2<Real> where; ///< in the previous frame, in pixels
    Real validity;
    Real clamped; ///< how much a clamp has moved the signal, relative to itself (TRMV eq. 8)
    Kept kept;

    template <ChannelTag C> QUELL_KERNEL auto operator[](C c) const { return kept[c]; }

    /// Takes another past in some lanes.
    QUELL_KERNEL void replace(auto lanes, Past const& other) {
        signal = select(lanes, other.signal, signal);
        where = select(lanes, other.where, where);
        validity = select(lanes, other.validity, validity);
        clamped = select(lanes, other.clamped, clamped);
        kept = make_record<Real>(typename Kept::channels{}, [&](auto c) QUELL_INLINED { return select(lanes, other.kept[c], kept[c]); });
    }
};

namespace detail {
template <class Px> using KeptRecord = Record<typename Px::Real, typename Px::Scope::kept_channels>;
template <class Px> using PastOf = Past<typename Px::Signal, KeptRecord<Px>>;

template <class Px> QUELL_KERNEL PastOf<Px> no_past() {
    using Real = typename Px::Real;
    return {zero<typename Px::Signal>(), vec2<Real>{Real(0.f), Real(0.f)}, Real(0.f), Real(0.f),
            make_record<Real>(typename Px::Scope::kept_channels{},
                              [](auto c) QUELL_INLINED { return zero<Value<decltype(c)::components, Real>>(); })};
}

/// A weighted sum of past pixels.
template <class Px> struct PastSum {
    using Real = typename Px::Real;
    PastOf<Px> sum = no_past<Px>();
    Real weight = Real(0.f);

    QUELL_KERNEL void add(auto const& then, Real w) {
        weight = weight + w;
        sum.signal = add_scaled(sum.signal, then.signal(), w);
        sum.kept = make_record<Real>(typename Px::Scope::kept_channels{},
                                     [&](auto c) QUELL_INLINED { return add_scaled(sum.kept[c], then[c], w); });
    }
    /// Starts again from nothing in the other lanes.
    QUELL_KERNEL void keep_only(auto enough) {
        weight = masked(enough, weight);
        sum.signal = select(enough, sum.signal, zero<typename Px::Signal>());
        sum.kept = make_record<Real>(typename Px::Scope::kept_channels{}, [&](auto c) QUELL_INLINED {
            return select(enough, sum.kept[c], zero<Value<decltype(c)::components, Real>>());
        });
    }
    QUELL_KERNEL PastOf<Px> mean(auto const& found) const {
        auto const scale_by = masked(weight > Real(0.f), 1.f / weight);
        return {scale(sum.signal, scale_by), found.where, masked(weight > Real(0.f), found.validity), Real(0.f),
                make_record<Real>(typename Px::Scope::kept_channels{}, [&](auto c) QUELL_INLINED { return scale(sum.kept[c], scale_by); })};
    }
};

/// Whether a past pixel has ever had a sample, as far as its length is kept.
template <class Real, class Scope> QUELL_KERNEL auto ever_sampled(PastPixel<Real, Scope> const& then) {
    if constexpr (Scope::kept_channels::template has<HistoryLength>)
        return then[history_length] > Real(0.f);
    else
        return Real(0.f) == Real(0.f);
}
/// Whether a past pixel is in the image, has a value and shows what was looked for, where a place to look was found at all.
template <class Real, class Then, class FoundPlace> QUELL_KERNEL auto counts(Then const& then, FoundPlace const& found) {
    auto const dx = then.place.column - found.where.x + (static_cast<float>(then.dx) + 0.5f);
    auto const dy = then.place.row - found.where.y + (static_cast<float>(then.dy) + 0.5f);
    return both(found.validity > Real(0.f), then.inside(), ever_sampled(then), accepts(found, then, dx, dy));
}

/// A position that is not finite or not in the image becomes a harmless one with validity 0: what was outside was never seen.
template <class Px, class FoundPlace> QUELL_KERNEL auto sane(Px const& px, FoundPlace found) {
    using Real = typename Px::Real;
    Real const right(static_cast<float>(px.size().width)), bottom(static_cast<float>(px.size().height));
    auto const usable = both(is_finite(found.where.x), is_finite(found.where.y), is_finite(found.validity), found.validity > Real(0.f),
                             found.where.x >= Real(0.f), found.where.x <= right, found.where.y >= Real(0.f), found.where.y <= bottom);
    found.where = vec2<Real>{masked(usable, found.where.x), masked(usable, found.where.y)};
    found.validity = masked(usable, found.validity);
    return found;
}

/// For lanes where interpolation did not find enough: the mean of what is acceptable in the 3x3 around the position.
template <class Px, class FoundPlace, class Mask>
[[gnu::noinline]] constexpr PastSum<Px> rescued(Px const& px, FoundPlace const& found, PastSum<Px> const& sum, Mask enough) {
    using Real = typename Px::Real;
    auto wider = sum;
    wider.keep_only(enough);
    auto const nearest = nearest_place(px, found.where);
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            auto const then = px.past(nearest, i, j);
            wider.add(then, masked(both(invert(enough), counts<Real>(then, found)), Real(1.f)));
        }
    return wider;
}

/// Any value of past pixels, interpolated, and where that could be done.
template <class V, class Mask> struct Interpolated {
    V value;
    Mask accepted;
};
template <class V, class Mask> Interpolated(V, Mask) -> Interpolated<V, Mask>; // clang 14 has no deduction for aggregates
} // namespace detail

/// History at a position between pixels from the four nearest, each tested, weights renormalised over those that pass; where none does,
/// from whatever passes in the 3x3 around.
struct Bilinear {
    bool rescue = true;

    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& unchecked) const {
        auto const found = detail::sane(px, unchecked);
        detail::PastSum<Px> sum;
        each_tap(px, found, [&](auto const& then, auto w) QUELL_INLINED { sum.add(then, w); });
        // With a total weight under 1 % the 3x3 around is used.
        auto const enough = sum.weight > sliver;
        if (rescue && any(both(invert(enough), found.validity > real_of<decltype(sum.weight)>(0.f)))) {
            // A copy, since what is handed to a function lives in memory.
            auto const narrow = sum;
            return detail::rescued(px, found, narrow, enough).mean(found);
        }
        sum.weight = masked(enough, sum.weight);
        return sum.mean(found);
    }

    /// Any value of past pixels, from those of the four that are accepted; 0 where none is.
    template <class Px, class FoundPlace, class ValueOf>
    QUELL_KERNEL static auto interpolated(Px const& px, FoundPlace const& unchecked, ValueOf&& value_of) {
        using Real = typename Px::Real;
        auto const found = detail::sane(px, unchecked);
        auto sum = zero<std::remove_cvref_t<decltype(value_of(px.past(std::declval<PastPlace<Real> const&>())))>>();
        Real weight(0.f);
        each_tap(px, found, [&](auto const& then, Real w) QUELL_INLINED {
            sum = add_scaled(sum, value_of(then), w);
            weight = weight + w;
        });
        auto const enough = weight > Real(sliver);
        return detail::Interpolated{scale(sum, masked(enough, 1.f / weight)), enough};
    }

private:
    static constexpr float sliver = 0.01f;

    /// Calls `visit(past pixel, weight)`, with a weight of 0 where it is not accepted.
    template <class Px, class FoundPlace, class Visit>
    QUELL_KERNEL static void each_tap(Px const& px, FoundPlace const& found, Visit&& visit) {
        using Real = typename Px::Real;
        auto const column = floor(found.where.x - 0.5f), row = floor(found.where.y - 0.5f);
        auto const u = found.where.x - 0.5f - column, v = found.where.y - 0.5f - row;
        PastPlace<Real> const place(column, row);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                auto const bilinear = (i == 0 ? 1.f - u : u) * (j == 0 ? 1.f - v : v);
                // Still pixels need one tap of the four.
                if (!any(bilinear > Real(0.f))) continue;
                auto const then = px.past(place, i, j);
                visit(then, masked(detail::counts<Real>(then, found), bilinear));
            }
    }
};

/// History from the one pixel that a position lies in, tested: the cheapest, where half a pixel does no harm.
struct Nearest {
    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& unchecked) const {
        using Real = typename Px::Real;
        auto const found = detail::sane(px, unchecked);
        auto const place = nearest_place(px, found.where);
        detail::PastSum<Px> sum;
        auto const then = px.past(place);
        sum.add(then, masked(detail::counts<Real>(then, found), Real(1.f)));
        return sum.mean(found);
    }
};

} // namespace quell
