#pragma once

#include <quell/core/hooks.hpp>

#include <limits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
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
    requires is_channels<Own<P>>
struct Declared<Own, P> {
    using type = union_of<Own<P>, typename DeclaredByParts<Own, typename PartsOf<P>::type>::type>;
};

template <class P> inline constexpr bool own_needs_camera = false;
template <class P>
    requires is_constant<decltype(&P::needs_camera), bool>
inline constexpr bool own_needs_camera<P> = P::needs_camera;
template <class P> constexpr bool needs_camera();
template <class... Ps> constexpr bool any_needs_camera(Parts<Ps...>) { return (needs_camera<Ps>() || ...); }
template <class P> constexpr bool needs_camera() { return own_needs_camera<P> || any_needs_camera(typename PartsOf<P>::type{}); }

template <class P> inline constexpr bool own_checks_jitter = false;
template <class P>
    requires is_constant<decltype(&P::checks_jitter), bool>
inline constexpr bool own_checks_jitter<P> = P::checks_jitter;
template <class P> constexpr bool checks_jitter();
template <class... Ps> constexpr bool any_checks_jitter(Parts<Ps...>) { return (checks_jitter<Ps>() || ...); }
template <class P> constexpr bool checks_jitter() { return own_checks_jitter<P> || any_checks_jitter(typename PartsOf<P>::type{}); }

/// Whether a pass says that it looks at the signal of the last frame. Temporal does so unsaid.
template <class Pass> inline constexpr bool says_reads_past_signal = false;
template <class Pass>
    requires is_constant<decltype(&Pass::reads_past_signal), bool>
inline constexpr bool says_reads_past_signal<Pass> = Pass::reads_past_signal;

/// Largest useful SIMD width of a pass: any, unless it says so.
template <class Pass> inline constexpr int max_lanes_of = std::numeric_limits<int>::max();
template <class Pass>
    requires is_constant<decltype(&Pass::max_lanes), int>
inline constexpr int max_lanes_of<Pass> = Pass::max_lanes;

/// Whether a pass takes an even row and the next one at once, where its packs are half as wide as those of the instruction set.
template <class Pass> inline constexpr bool takes_two_rows = false;
template <class Pass>
    requires is_constant<decltype(&Pass::two_rows), bool>
inline constexpr bool takes_two_rows<Pass> = Pass::two_rows;

/// Whether a filter says that none of its passes makes a new signal.
template <class F> inline constexpr bool says_leaves_signal = false;
template <class F>
    requires is_constant<decltype(&F::leaves_signal), bool>
inline constexpr bool says_leaves_signal<F> = F::leaves_signal;

/// A pass's name for profilers and plans. Policies of the host may lack one.
template <class Pass> inline constexpr auto pass_name = "filter";
template <class Pass>
    requires is_text<decltype(&Pass::name)>
inline constexpr auto pass_name<Pass> = Pass::name;

/// Whether a policy derives from its parts and looks at nothing else. It cannot say so by a member that its bases have, too: nvcc takes
/// that for ambiguous.
template <class P> inline constexpr bool adds_no_tap = false;

/// Whether a policy says `static constexpr int farthest_tap`.
template <class P> inline constexpr bool says_farthest_tap = false;
template <class P>
    requires is_constant<decltype(&P::farthest_tap), int>
inline constexpr bool says_farthest_tap<P> = true;

/// The largest distance, in pixels along x or y, at which a policy without its parts looks at images of this frame.
template <class P> constexpr int own_farthest_tap(P const& policy) {
    if constexpr (adds_no_tap<P>)
        return 0;
    else if constexpr (says_farthest_tap<P>)
        return P::farthest_tap;
    else if constexpr (requires { policy.farthest_tap(); })
        return policy.farthest_tap();
    else
        return anywhere;
}
template <class... Ps> constexpr int farthest_tap_of_parts(Parts<Ps...>);
/// That of a part with its parts. A list of parts has types only, so a distance that depends on numbers counts as any.
template <class P> constexpr int farthest_tap_of_part() {
    int const of_parts = farthest_tap_of_parts(typename PartsOf<P>::type{});
    if constexpr (adds_no_tap<P>)
        return of_parts;
    else if constexpr (says_farthest_tap<P>)
        return P::farthest_tap > of_parts ? P::farthest_tap : of_parts;
    else
        return anywhere;
}
template <class... Ps> constexpr int farthest_tap_of_parts(Parts<Ps...>) {
    int farthest = 0;
    (static_cast<void>(farthest = farthest_tap_of_part<Ps>() > farthest ? farthest_tap_of_part<Ps>() : farthest), ...);
    return farthest;
}
/// That of a pass: of its policy and all parts.
template <class Pass> constexpr int farthest_tap_of(Pass const& pass) {
    int const own = own_farthest_tap(pass), of_parts = farthest_tap_of_parts(typename PartsOf<Pass>::type{});
    return own > of_parts ? own : of_parts;
}

/// Whether what a pass makes goes into the history.
template <class Pass> constexpr bool feeds_back(Pass const& pass) {
    if constexpr (requires { requires std::is_same_v<decltype(pass.feedback()), bool>; })
        return pass.feedback();
    else
        return false;
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

/// Whether a policy or a part of it has `static constexpr bool checks_jitter = true`: it makes no sense of a frame.camera.jitter that is
/// not finite or of more than 8 pixels, which is then an error.
template <class P> inline constexpr bool checks_jitter_of = detail::checks_jitter<P>();

/// The divisor of the frame's width and height at which a pass runs: its `static constexpr int fraction`, or 1.
template <class P> inline constexpr int fraction_of = 1;
/// @cond
template <class P>
    requires detail::is_constant<decltype(&P::fraction), int>
inline constexpr int fraction_of<P> = P::fraction;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
