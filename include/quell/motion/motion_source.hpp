#pragma once

#include <quell/frame/cursor/probe.hpp>

#include <concepts>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What a motion source found: a position in the previous frame, and how far it can be trusted.
/// A source may return a struct of its own that has these two members and also
///
///     auto accepts(auto then, Real dx, Real dy) const; // whether `then`, a past pixel (dx, dy) from `where`, shows the same thing
///
/// History is then interpolated over accepted taps only.
template <class Real> struct Reprojection {
    vec2<Real> where; ///< pixel coordinates; a pixel's centre is at .5
    Real validity;    ///< trust in [0, 1]; 0: nothing was found
};
template <class Real, class Validity> Reprojection(glm::vec<2, Real>, Validity) -> Reprojection<Real>;

namespace detail {
/// Whether what a source found accepts a past pixel. Without a test, all are accepted.
template <class FoundPlace, class Then, class Real> QUELL_KERNEL auto accepts(FoundPlace const& found, Then const& then, Real dx, Real dy) {
    if constexpr (requires { found.accepts(then, dx, dy); })
        return found.accepts(then, dx, dy);
    else {
        static_assert(!NamesAccepts<FoundPlace>,
                      "`accepts` of what previous(px) returns must be a function accepts(auto const& then, Real dx, Real dy) const that "
                      "gives a mask; any other member needs another name");
        return Real(0.f) == Real(0.f);
    }
}

template <class F>
concept Found = requires(F found) {
    { found.where } -> std::convertible_to<vec2<float>>;
    { found.validity } -> std::convertible_to<float>;
};
} // namespace detail

/// Finds where, in the previous frame, the thing seen in a pixel was:
///
///     auto previous(auto px) const; // a Reprojection, or a struct like it
template <class M>
concept MotionSource = std::is_trivially_copyable_v<M> && requires(M const m, detail::Probe<M> px, detail::PastProbe<M> then) {
    { m.previous(px) } -> detail::Found;
    detail::accepts(m.previous(px), then, 0.f, 0.f);
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
