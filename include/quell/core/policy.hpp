#pragma once

#include <quell/core/channel.hpp>

namespace quell {

/// What a policy is made of. A combinator says `using parts = Parts<Inner>`; what its parts declare then counts as declared by it, and it
/// lists only what it adds.
template <class... Ps> struct Parts {};

namespace detail {
template <class P> struct PartsOf { using type = Parts<>; };
template <class P>
    requires requires { typename P::parts; }
struct PartsOf<P> {
    using type = typename P::parts;
};

// One for each kind of declaration: what a policy itself says.
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
/// What a policy and its parts declare together.
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

/// The channels of the current frame that these policies look at, as they or their parts say by `reads`.
template <class... Ps> using reads_of = union_of<typename detail::Declared<detail::SaidToRead, Ps>::type...>;

/// The channels of the previous frame that these policies look at (`remembers`).
template <class... Ps> using remembers_of = union_of<typename detail::Declared<detail::SaidToRemember, Ps>::type...>;

/// What these policies make themselves and keep from frame to frame (`keeps`): history lengths, moments.
template <class... Ps> using keeps_of = union_of<typename detail::Declared<detail::SaidToKeep, Ps>::type...>;

/// What of the things that other policies keep these look at in the previous frame, before it is made anew (`reads_kept`): a detector in
/// front of Temporal does.
template <class... Ps> using reads_kept_of = union_of<typename detail::Declared<detail::SaidToReadKept, Ps>::type...>;

/// What these policies make for the passes after them (`emits`).
template <class... Ps> using emits_of = union_of<typename detail::Declared<detail::SaidToEmit, Ps>::type...>;

/// Whether a policy, or a part of it, says `static constexpr bool needs_camera = true`: then hosts must set frame.camera.
template <class P> inline constexpr bool needs_camera_of = detail::needs_camera<P>();

/// At which fraction of the frame's width and height a pass runs, as it says by `static constexpr int fraction`: 1 where it doesn't.
template <class P> inline constexpr int fraction_of = 1;
template <class P>
    requires requires { P::fraction; }
inline constexpr int fraction_of<P> = P::fraction;

} // namespace quell
