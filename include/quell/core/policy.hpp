#pragma once

#include <quell/core/channel.hpp>

#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

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

// What a policy itself declares, without its parts.
template <class P> using OwnReads = typename P::reads;
template <class P> using OwnRemembers = typename P::remembers;
template <class P> using OwnKeeps = typename P::keeps;
template <class P> using OwnReadsKept = typename P::reads_kept;
template <class P> using OwnEmits = typename P::emits;

template <template <class> class Own, class P> struct Declared;
template <template <class> class Own, class Ps> struct DeclaredByParts;
template <template <class> class Own, class... Ps> struct DeclaredByParts<Own, Parts<Ps...>> {
    using type = union_of<typename Declared<Own, Ps>::type...>;
};
/// The union of what a policy and its parts declare.
template <template <class> class Own, class P> struct Declared {
    using type = typename DeclaredByParts<Own, typename PartsOf<P>::type>::type;
};
template <template <class> class Own, class P>
    requires requires { typename Own<P>; }
struct Declared<Own, P> {
    using type = union_of<Own<P>, typename DeclaredByParts<Own, typename PartsOf<P>::type>::type>;
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
template <class... Ps> using reads_of = union_of<typename detail::Declared<detail::OwnReads, Ps>::type...>;

/// The channels of the previous frame that these policies read (`remembers`). History stores them.
template <class... Ps> using remembers_of = union_of<typename detail::Declared<detail::OwnRemembers, Ps>::type...>;

/// The channels that these policies make and keep from frame to frame (`keeps`), such as the history length.
template <class... Ps> using keeps_of = union_of<typename detail::Declared<detail::OwnKeeps, Ps>::type...>;

/// The channels kept by other policies that these policies read in the previous frame (`reads_kept`). A change detector in front of
/// Temporal needs that.
template <class... Ps> using reads_kept_of = union_of<typename detail::Declared<detail::OwnReadsKept, Ps>::type...>;

/// The channels that these policies make for later passes of the same frame (`emits`).
template <class... Ps> using emits_of = union_of<typename detail::Declared<detail::OwnEmits, Ps>::type...>;

/// Whether a policy or a part of it has `static constexpr bool needs_camera = true`. Hosts must then set frame.camera.
template <class P> inline constexpr bool needs_camera_of = detail::needs_camera<P>();

/// The divisor of the frame's width and height at which a pass runs: its `static constexpr int fraction`, or 1.
template <class P> inline constexpr int fraction_of = 1;
/// @cond
// A data member of that name is something else.
template <class P>
    requires std::is_same_v<decltype(&P::fraction), int const*>
inline constexpr int fraction_of<P> = P::fraction;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
