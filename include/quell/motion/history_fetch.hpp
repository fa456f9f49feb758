#pragma once

#include <quell/motion/first_valid.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The history of a pixel, as a fetch returns it. A history fetch has `fetch(px, found)` with what a motion source found. Models: Bilinear,
/// CatmullRom, Nearest.
/// @tparam V    a value of the signal
/// @tparam Kept the Record of the kept channels
template <class V, class Kept> struct HistorySample {
    using Real = real_of<V>;      ///< float or a pack
    V signal;                     ///< interpolated
    vec2<Real> where;             ///< pixel coordinates in the previous frame
    Real validity;                ///< trust in [0, 1]; 0: there is no history
    Real clamped;                 ///< relative change of the signal by clamps so far (TRMV eq. 8)
    Kept kept;                    ///< interpolated kept channels
    Real from_around = Real(0.f); ///< 1 where nothing was at the place itself, so that the pixels around it stand in

    /// The value of a kept channel.
    template <ChannelTag C> QUELL_KERNEL auto operator[](C c) const { return kept[c]; }

    /// Replaces all members in some lanes.
    QUELL_KERNEL void replace(auto lanes, HistorySample const& other) {
        signal = select(lanes, other.signal, signal);
        where = select(lanes, other.where, where);
        validity = select(lanes, other.validity, validity);
        clamped = select(lanes, other.clamped, clamped);
        from_around = select(lanes, other.from_around, from_around);
        kept = make_record<Real>(typename Kept::channels{}, [&](auto c) QUELL_INLINED { return select(lanes, other.kept[c], kept[c]); });
    }
};

namespace detail {
template <class Px> using KeptRecord = Record<typename Px::Real, typename Px::Scope::kept_channels>;
template <class Px> using HistorySampleOf = HistorySample<typename Px::Signal, KeptRecord<Px>>;

template <class Px> QUELL_KERNEL HistorySampleOf<Px> no_past() {
    using Real = typename Px::Real;
    return {zero<typename Px::Signal>(), vec2<Real>{Real(0.f), Real(0.f)}, Real(0.f), Real(0.f),
            make_record<Real>(typename Px::Scope::kept_channels{},
                              [](auto c) QUELL_INLINED { return zero<Value<decltype(c)::components, Real>>(); })};
}

/// A weighted sum of past pixels.
template <class Px> struct PastSum {
    using Real = typename Px::Real;
    HistorySampleOf<Px> sum = no_past<Px>();
    Real weight = Real(0.f);

    /// A kept channel's value, or what it says that has to be interpolated.
    QUELL_KERNEL static auto interpolated(auto c, auto const& then) {
        if constexpr (requires { c.interpolated(then[c], then.signal()); })
            return c.interpolated(then[c], then.signal());
        else {
            static_assert(!NamesInterpolated<decltype(c)>,
                          "`interpolated` of a channel must be `static auto interpolated(auto const& stored, auto const& signal)`");
            return then[c];
        }
    }
    QUELL_KERNEL void add(auto const& then, Real w) {
        weight = weight + w;
        sum.signal = add_scaled(sum.signal, then.signal(), w);
        sum.kept = make_record<Real>(typename Px::Scope::kept_channels{},
                                     [&](auto c) QUELL_INLINED { return add_scaled(sum.kept[c], interpolated(c, then), w); });
    }
    /// Resets the other lanes to an empty sum.
    QUELL_KERNEL void keep_only(auto enough) {
        weight = masked(enough, weight);
        sum.signal = select(enough, sum.signal, zero<typename Px::Signal>());
        sum.kept = make_record<Real>(typename Px::Scope::kept_channels{}, [&](auto c) QUELL_INLINED {
            return select(enough, sum.kept[c], zero<Value<decltype(c)::components, Real>>());
        });
    }
    QUELL_KERNEL HistorySampleOf<Px> mean(auto const& found) const {
        auto const scale_by = masked(weight > Real(0.f), 1.f / weight);
        return {scale(sum.signal, scale_by), found.where, masked(weight > Real(0.f), found.validity), Real(0.f),
                make_record<Real>(typename Px::Scope::kept_channels{}, [&](auto c) QUELL_INLINED { return scale(sum.kept[c], scale_by); })};
    }
};

/// Whether a past pixel has ever had a usable sample; true where its history length is not kept.
template <class Real, class Scope> QUELL_KERNEL auto ever_sampled(PastPixel<Real, Scope> const& then) {
    if constexpr (Scope::kept_channels::template has<HistoryLength>)
        return then[history_length] > Real(0.f);
    else
        return Real(0.f) == Real(0.f);
}
/// Whether a past pixel counts: it lies inside the image, has had a sample, and is accepted.
template <class Real, class Then, class FoundPlace> QUELL_KERNEL auto counts(Then const& then, FoundPlace const& found) {
    auto const dx = then.place.column - found.where.x + (static_cast<float>(then.dx) + 0.5f);
    auto const dy = then.place.row - found.where.y + (static_cast<float>(then.dy) + 0.5f);
    return both(found.validity > Real(0.f), then.inside(), ever_sampled(then), accepts(found, then, dx, dy));
}

/// Gives validity 0 and a harmless position to what is not finite or lies outside the image, where nothing was seen.
template <class Px, class FoundPlace> QUELL_KERNEL auto sane(Px const& px, FoundPlace found) {
    using Real = typename Px::Real;
    static_assert(std::is_same_v<decltype(found.where), vec2<Real>> && std::is_same_v<decltype(found.validity), Real>,
                  "what previous(px) returns must have `vec2<Real> where` and `Real validity`, where Real is the cursor's: "
                  "`typename decltype(px)::Real`");
    Real const right(to_real(px.size().width)), bottom(to_real(px.size().height));
    auto const usable = both(is_finite(found.where.x), is_finite(found.where.y), is_finite(found.validity), found.validity > Real(0.f),
                             found.where.x >= Real(0.f), found.where.x <= right, found.where.y >= Real(0.f), found.where.y <= bottom);
    found.where = vec2<Real>{masked(usable, found.where.x), masked(usable, found.where.y)};
    found.validity = masked(usable, found.validity);
    return found;
}

/// For lanes without enough accepted weight: the mean of the accepted pixels in the 3x3 around the position.
template <class Px, class FoundPlace, class Mask>
QUELL_OUTLINED constexpr PastSum<Px> rescued(Px const& px, FoundPlace const& found, PastSum<Px> const& sum, Mask enough) {
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

/// An interpolated value, and the lanes in which enough taps were accepted.
template <class V, class Mask> struct Interpolated {
    V value;
    Mask accepted;
};
template <class V, class Mask> Interpolated(V, Mask) -> Interpolated<V, Mask>; // clang 14 has no deduction for aggregates
} // namespace detail

/// Bilinear history fetch. Rejected taps are left out and the weights renormalised. Where less than 1 % of the weight is accepted, the mean
/// of the accepted pixels in the 3x3 around the position is used.
struct Bilinear {
    static constexpr int farthest_tap = 0;
    bool use_3x3 = true; ///< whether the 3x3 is used

    /// The HistorySample at the position that a motion source found.
    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& unchecked) const {
        auto const found = detail::sane(px, unchecked);
        detail::PastSum<Px> sum;
        each_tap(px, found, [&](auto const& then, auto w) QUELL_INLINED { sum.add(then, w); });
        auto const enough = sum.weight > min_weight;
        if (use_3x3 && any(both(invert(enough), found.validity > real_of<decltype(sum.weight)>(0.f)))) {
            // A copy: the original then stays in registers.
            auto const narrow = sum;
            auto wider = detail::rescued(px, found, narrow, enough).mean(found);
            using Real = typename Px::Real;
            wider.from_around = select(enough, Real(0.f), Real(1.f));
            return wider;
        }
        sum.weight = masked(enough, sum.weight);
        return sum.mean(found);
    }

    /// Interpolates any value of past pixels over the accepted taps of the four; 0 where none is. value_of(past pixel) is the value.
    template <class Px, class FoundPlace, class ValueOf>
    QUELL_KERNEL static auto interpolated(Px const& px, FoundPlace const& unchecked, ValueOf&& value_of) {
        using Real = typename Px::Real;
        auto const found = detail::sane(px, unchecked);
        auto sum = zero<std::remove_cvref_t<decltype(value_of(px.past(std::declval<PixelCoordinates<Real> const&>())))>>();
        Real weight(0.f);
        each_tap(px, found, [&](auto const& then, Real w) QUELL_INLINED {
            sum = add_scaled(sum, value_of(then), w);
            weight = weight + w;
        });
        auto const enough = weight > Real(min_weight);
        return detail::Interpolated{scale(sum, masked(enough, 1.f / weight)), enough};
    }

private:
    static constexpr float min_weight = 0.01f; ///< least accepted weight

    /// Calls `visit(past pixel, weight)` for each tap; the weight is 0 where it is not accepted.
    template <class Px, class FoundPlace, class Visit>
    QUELL_KERNEL static void each_tap(Px const& px, FoundPlace const& found, Visit&& visit) {
        using Real = typename Px::Real;
        auto const column = floor(found.where.x - 0.5f), row = floor(found.where.y - 0.5f);
        auto const u = found.where.x - 0.5f - column, v = found.where.y - 0.5f - row;
        PixelCoordinates<Real> const place(column, row);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                auto const bilinear = (i == 0 ? 1.f - u : u) * (j == 0 ? 1.f - v : v);
                // Pixels that do not move need one tap only.
                if (!any(bilinear > Real(0.f))) continue;
                auto const then = px.past(place, i, j);
                visit(then, masked(detail::counts<Real>(then, found), bilinear));
            }
    }
};

/// History fetch from the one pixel that contains the position, if it is accepted. The cheapest; positions are off by up to half a pixel.
struct Nearest {
    static constexpr int farthest_tap = 0;
    /// The HistorySample at the position that a motion source found.
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

} // namespace quell::inline QUELL_INSTRUCTION_SET
