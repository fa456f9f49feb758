#pragma once

#include <quell/core/channel.hpp>

namespace quell {

/// The policies that a policy is made of: `using parts = Parts<Inner>`. Declarations of the parts (`reads`, `keeps`, ...) count as
/// declarations of the whole, which lists only what it adds.
template <class... Ps> struct Parts {};

namespace detail {
template <class P> struct PartsOf { using type = Parts<>; };
template <class P>
    requires requires { typename P::parts; }
struct PartsOf<P> {
    using type = typename P::parts;
};

// One struct for each kind of declaration. `by<P>()` is what P itself declares, without its parts.
struct SaidToRead {
    template <class P>
        requires requires { typename P::reads; }
    static constexpr auto by() { return typename P::reads{}; }
};
struct SaidToRemember {
    template <class P>
        requires requires { typename P::remembers; }
    static constexpr auto by() { return typename P::remembers{}; }
};
struct SaidToKeep {
    template <class P>
        requires requires { typename P::keeps; }
    static constexpr auto by() { return typename P::keeps{}; }
};
struct SaidToReadKept {
    template <class P>
        requires requires { typename P::reads_kept; }
    static constexpr auto by() { return typename P::reads_kept{}; }
};
struct SaidToEmit {
    template <class P>
        requires requires { typename P::emits; }
    static constexpr auto by() { return typename P::emits{}; }
};

template <class Kind, class P> struct Declared;
template <class Kind, class Ps> struct DeclaredByParts;
template <class Kind, class... Ps> struct DeclaredByParts<Kind, Parts<Ps...>> {
    using type = union_of<typename Declared<Kind, Ps>::type...>;
};
/// The union of what a policy and its parts declare.
template <class Kind, class P> struct Declared { using type = typename DeclaredByParts<Kind, typename PartsOf<P>::type>::type; };
template <class Kind, class P>
    requires requires { Kind::template by<P>(); }
struct Declared<Kind, P> {
    using type = decltype(Kind::template by<P>() | typename DeclaredByParts<Kind, typename PartsOf<P>::type>::type{});
};

template <class P> constexpr bool needs_camera();
template <class... Ps> constexpr bool any_needs_camera(Parts<Ps...>) { return (needs_camera<Ps>() || ...); }
template <class P> constexpr bool needs_camera() {
    if constexpr (requires { P::needs_camera; })
        if (P::needs_camera) return true;
    return any_needs_camera(typename PartsOf<P>::type{});
}
} // namespace detail

/// The channels of the current frame that these policies and their parts read (`reads`).
template <class... Ps> using reads_of = union_of<typename detail::Declared<detail::SaidToRead, Ps>::type...>;

/// The channels of the previous frame that these policies read (`remembers`). History stores them.
template <class... Ps> using remembers_of = union_of<typename detail::Declared<detail::SaidToRemember, Ps>::type...>;

/// The channels that these policies make and keep from frame to frame (`keeps`), such as the history length.
template <class... Ps> using keeps_of = union_of<typename detail::Declared<detail::SaidToKeep, Ps>::type...>;

/// The channels kept by other policies that these policies read in the previous frame (`reads_kept`). A change detector in front of
/// Temporal needs that.
template <class... Ps> using reads_kept_of = union_of<typename detail::Declared<detail::SaidToReadKept, Ps>::type...>;

/// The channels that these policies make for later passes of the same frame (`emits`).
template <class... Ps> using emits_of = union_of<typename detail::Declared<detail::SaidToEmit, Ps>::type...>;

/// Whether a policy or a part of it has `static constexpr bool needs_camera = true`. Hosts must then set frame.camera.
template <class P> inline constexpr bool needs_camera_of = detail::needs_camera<P>();

/// The divisor of the frame's width and height at which a pass runs: its `static constexpr int fraction`, or 1.
template <class P> inline constexpr int fraction_of = 1;
/// @cond
template <class P>
    requires requires { P::fraction; }
inline constexpr int fraction_of<P> = P::fraction;
/// @endcond

} // namespace quell
