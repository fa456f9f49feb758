#pragma once

#include <quell/motion/motion_source.hpp>

namespace quell {

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

/// Asks several sources in order and takes, for each pixel, the first with any validity. In a Temporal stage, the next one is asked also
/// where the history at the place that a source names turns out not to be valid.
template <class First, class... Rest> struct FirstValid {
    static_assert(MotionSource<First>, "FirstValid{sources...}: each must have previous(px), see quell/motion/motion_source.hpp");
    using parts = Parts<First, Rest...>;

    First first;
    FirstValid<Rest...> rest;

    constexpr FirstValid() = default;
    constexpr explicit FirstValid(First first_, Rest... rest_) : first(first_), rest(rest_...) {}

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const a = first.previous(px);
        auto const b = rest.previous(px);
        auto const valid = a.validity > Real(0.f);
        return detail::FirstFound<Real, decltype(first.previous(px)), decltype(rest.previous(px))>{
            {select(valid, a.where.x, b.where.x), select(valid, a.where.y, b.where.y)}, select(valid, a.validity, b.validity), a, b};
    }
};
template <class Last> struct FirstValid<Last> : Last {
    static_assert(MotionSource<Last>, "FirstValid{sources...}: each must have previous(px), see quell/motion/motion_source.hpp");
    constexpr FirstValid() = default;
    constexpr explicit FirstValid(Last last) : Last(last) {}
};
template <class... Sources> FirstValid(Sources...) -> FirstValid<Sources...>;

} // namespace quell
