#pragma once

#include <quell/motion/motion_source.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
template <class Real, class A, class B> struct FirstFound {
    vec2<Real> where;
    Real validity;
    A a;
    B b;
    QUELL_KERNEL auto accepts(auto const& then, Real dx, Real dy) const {
        auto const first = a.validity > Real(0.f);
        return either(both(first, detail::accepts(a, then, dx, dy)), both(invert(first), detail::accepts(b, then, dx, dy)));
    }
};
} // namespace detail

/// Takes, for each pixel, the first of several motion sources with a validity above 0. In a Temporal stage the next source is also used
/// where the history at the first one's position is rejected.
/// @tparam First the preferred source
/// @tparam Rest  the other sources, in order
template <class First, class... Rest> struct FirstValid {
    static_assert(MotionSource<First>, "FirstValid{sources...}: each must have previous(px), see quell/motion/motion_source.hpp");
    using parts = Parts<First, Rest...>; ///< what it is made of
    static constexpr int farthest_tap = 0;

    First first;              ///< the preferred source
    FirstValid<Rest...> rest; ///< the other sources, in order

    constexpr FirstValid() = default; ///< every source with its defaults
    /// The sources in order of preference.
    constexpr explicit FirstValid(First first_, Rest... rest_) : first(first_), rest(rest_...) {}

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const a = first.previous(px);
        auto const b = rest.previous(px);
        auto const valid = a.validity > Real(0.f);
        return detail::FirstFound<Real, decltype(first.previous(px)), decltype(rest.previous(px))>{
            {select(valid, a.where.x, b.where.x), select(valid, a.where.y, b.where.y)}, select(valid, a.validity, b.validity), a, b};
    }
};
/// @cond
template <class Last> struct FirstValid<Last> : Last {
    static_assert(MotionSource<Last>, "FirstValid{sources...}: each must have previous(px), see quell/motion/motion_source.hpp");
    constexpr FirstValid() = default;
    constexpr explicit FirstValid(Last last) : Last(last) {}
};
namespace detail {
template <class First, class Second, class... Rest> std::true_type chain_of(FirstValid<First, Second, Rest...> const&);
std::false_type chain_of(...);
/// Whether a source is a FirstValid of several, with `first` and `rest`.
template <class Source> inline constexpr bool is_chain = decltype(chain_of(std::declval<Source>()))::value;
} // namespace detail
/// @endcond
template <class... Sources> FirstValid(Sources...) -> FirstValid<Sources...>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
