#pragma once

#include <quell/frame/cursor/probe.hpp>

#include <concepts>

namespace quell {

/// A place in the previous frame (pixels; a pixel's centre is at .5), and how far it can be trusted: 0 not at all, 1 fully.
/// A source may return a struct of its own with these two members and, beside them,
///
///     auto accepts(auto then, Real dx, Real dy) const      whether the past pixel `then`, dx and dy away from `where`, shows the same
///     thing
///
/// History is then interpolated over the accepted taps only.
template <class Real> struct Reprojection {
    vec2<Real> where;
    Real validity;
};
template <class Real, class Validity> Reprojection(glm::vec<2, Real>, Validity) -> Reprojection<Real>;

namespace detail {
/// Whether a source's finding accepts a past pixel; one without a test accepts all.
template <class FoundPlace, class Then, class Real> QUELL_KERNEL auto accepts(FoundPlace const& found, Then const& then, Real dx, Real dy) {
    if constexpr (requires { found.accepts(then, dx, dy); })
        return found.accepts(then, dx, dy);
    else
        return Real(0.f) == Real(0.f);
}

template <class F>
concept Found = requires(F found) {
    { found.where } -> std::convertible_to<vec2<float>>;
    { found.validity } -> std::convertible_to<float>;
};
} // namespace detail

/// Says where, in the previous frame, the thing seen in a pixel was:
///
///     auto previous(auto px) const -> Reprojection
template <class M>
concept MotionSource = std::is_trivially_copyable_v<M> && requires(M const m, detail::Probe<M> px, detail::PastProbe<M> then) {
    { m.previous(px) } -> detail::Found;
    detail::accepts(m.previous(px), then, 0.f, 0.f);
};

} // namespace quell
