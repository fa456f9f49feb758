#pragma once

#include <quell/core/value.hpp>
#include <quell/frame/channels.hpp>

#include <string_view>

/// Guides that no scene has, and what stands in for them. Every frame's guides are looked at in the first pass. Where one is impossible,
/// passes see a copy of the channel in which it is repaired: no policy sees the host's value.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The guides that are looked at.
using CheckedGuides = Channels<Albedo, Normal, Depth, Motion>;
/// Those of which copies are made. A motion that is not finite leads nowhere, so that the pixel has no history.
using CopiedGuides = Channels<Albedo, Normal, Depth>;

/// Tells an impossible value of a guide, in words too, and what is used in its place.
template <ChannelTag C> struct Repair;

/// 0 to 1. More is 1. Where a component is negative or not finite there is no albedo: 0, which counts as black.
template <> struct Repair<Albedo> {
    static constexpr std::string_view impossible = "outside [0, 1]";
    template <class V> QUELL_KERNEL static auto possible(V const& a) {
        // Rounding may leave a little more than 1.
        return both(is_albedo(a), max(a.x, max(a.y, a.z)) <= real_of<V>(1.002f));
    }
    template <class V> QUELL_KERNEL static V repaired(V const& a) {
        using Real = real_of<V>;
        auto const at_most_one = map([](auto c) QUELL_INLINED { return min(c, decltype(c)(1.f)); }, a);
        return select(possible(a), a, select(is_albedo(a), at_most_one, splat<V>(Real(0.f))));
    }

private:
    template <class V> QUELL_KERNEL static auto is_albedo(V const& a) {
        return both(all_finite(a), min(a.x, min(a.y, a.z)) >= real_of<V>(0.f));
    }
};

/// Of length 1, or 0 where there is none. Others are brought to length 1; what is not finite is none.
template <> struct Repair<Normal> {
    static constexpr std::string_view impossible = "not of length 1";
    template <class V> QUELL_KERNEL static auto possible(V const& n) {
        using Real = real_of<V>;
        auto const squared = dot(n, n);
        // Halves are off by up to 0.001.
        return both(is_finite(squared), either(abs(squared - Real(1.f)) <= Real(0.002f), squared <= Real(0.f)));
    }
    template <class V> QUELL_KERNEL static V repaired(V const& n) {
        using Real = real_of<V>;
        auto const longest = max(abs(n.x), max(abs(n.y), abs(n.z)));
        auto const points = both(all_finite(n), longest > Real(1e-30f));
        // Divided by its longest component first: squares of others may be too large for a float.
        auto const shorter = scale(n, 1.f / select(points, longest, Real(1.f)));
        auto const unit = scale(shorter, 1.f / sqrt(max(dot(shorter, shorter), Real(1.f))));
        return select(possible(n), n, select(points, unit, splat<V>(Real(0.f))));
    }
};

/// Above 0; infinite where nothing is seen. Others count as that.
template <> struct Repair<Depth> {
    static constexpr std::string_view impossible = "0, negative or NaN";
    template <class Real> QUELL_KERNEL static auto possible(Real z) {
        auto const all = bits(z);
        return both(less_index(Index<Real>(0), all), less_index(all, Index<Real>(0x7f800001)));
    }
    template <class Real> QUELL_KERNEL static Real repaired(Real z) {
        return from_bits(select_index(possible(z), bits(z), Index<Real>(0x7f800000)));
    }
};

template <> struct Repair<Motion> {
    static constexpr std::string_view impossible = "not finite";
    template <class V> QUELL_KERNEL static auto possible(V const& m) { return all_finite(m); }
};

/// The place of a guide among CheckedGuides.
template <ChannelTag C> constexpr int number_of_guide() {
    int number = 0, found = 0;
    for_each_channel(CheckedGuides{}, [&]<class D>(D) {
        if (std::is_same_v<C, D>) found = number;
        ++number;
    });
    return found;
}

/// Which guides of a pixel are impossible: the sum of 1 << i over those numbers i of CheckedGuides. Only counted, never stored.
struct ImpossibleGuides : Channel<1> {
    static constexpr auto name = "impossible guides";
};
/// Whether something is seen at the pixel of a cursor, as far as the pass reads the depth.
template <class Guides, class Px> QUELL_KERNEL auto shows_surface(Px const& px) {
    using Real = typename Px::Real;
    if constexpr (Guides::template has<Depth>)
        return is_finite(px[Depth{}]);
    else
        return Real(0.f) == Real(0.f);
}
/// ImpossibleGuides of the pixel at a cursor. Nothing needs a normal where nothing is seen.
/// @tparam Guides of CheckedGuides, those that the pass reads
template <class Guides, class Px> QUELL_KERNEL auto impossible_guides(Px const& px) {
    using Real = typename Px::Real;
    Real sum(0.f);
    float number = 1.f;
    for_each_channel(CheckedGuides{}, [&]<class C>(C) QUELL_INLINED {
        if constexpr (Guides::template has<C>) {
            auto bad = invert(Repair<C>::possible(px[C{}]));
            if constexpr (std::is_same_v<C, Normal>) bad = both(bad, shows_surface<Guides>(px));
            sum = sum + masked(bad, Real(number));
        }
        number = number * 2.f;
    });
    return sum;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
