#pragma once

#include <quell/core/channel.hpp>

#include <concepts>
#include <limits>

// What a policy may say beside its one function: members that quell looks for by name. One of the right kind is read, whether or not other
// policies have it. One of another kind is refused with a sentence: a number that happens to have such a name changes nothing in silence.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// The policies that a policy is made of: `using parts = Parts<Inner>`. Declarations of the parts (`reads`, `keeps`, ...) count as
/// declarations of the whole, which lists only what it adds.
template <class... Ps> struct Parts {};

/// As the `farthest_tap` of a policy: it looks at pixels of this frame that no number bounds, as along a motion vector. Also what counts
/// for a policy that says nothing.
inline constexpr int anywhere = std::numeric_limits<int>::max();

namespace detail {
template <class T> inline constexpr bool is_channels = false;
template <class... Cs> inline constexpr bool is_channels<Channels<Cs...>> = true;
template <class T> inline constexpr bool is_parts = false;
template <class... Ps> inline constexpr bool is_parts<Parts<Ps...>> = true;

/// Whether it is that of a static text.
template <class Address> inline constexpr bool is_text = false;
template <class T> inline constexpr bool is_text<T const*> = std::is_convertible_v<T const&, std::string_view>;

/// Accepts any pass of a filter.
struct AnyPass {
    constexpr void operator()(auto const&) const {}
};
/// A filter of several passes. Its members are options, of which it makes its passes.
template <class P>
concept HasPasses = requires(P const& p) {
    p.for_each_pass(AnyPass{});
};

template <class P> struct PartsOf { using type = Parts<>; };
template <class P>
    requires is_parts<typename P::parts>
struct PartsOf<P> {
    using type = typename P::parts;
};

template <class P, class... Ps> constexpr bool is_among(Parts<Ps...>) { return (std::is_same_v<P, Ps> || ...); }
/// Whether the type of a member is one of a policy's parts.
template <class P, class Member> inline constexpr bool is_part = is_among<std::remove_cv_t<Member>>(typename PartsOf<P>::type{});

// False for a number, function or type of that name which is of another kind than the one that quell reads. A name that several bases have
// counts as none: what counts are the policy's parts.
#define QUELL_HOOK(hook, ...)                                                                                                              \
    static constexpr bool hook = !(                                                                                                        \
                                     requires(P const& p) { p.hook; } || requires { &P::hook; } || requires { typename P::hook; }) ||      \
                                 (__VA_ARGS__)
/// The list of what quell looks for in any policy.
template <class P> struct Hooks {
    QUELL_HOOK(
        reads, requires { requires is_channels<typename P::reads>; });
    QUELL_HOOK(
        remembers, requires { requires is_channels<typename P::remembers>; });
    QUELL_HOOK(
        keeps, requires { requires is_channels<typename P::keeps>; });
    QUELL_HOOK(
        reads_kept, requires { requires is_channels<typename P::reads_kept>; });
    QUELL_HOOK(
        emits, requires { requires is_channels<typename P::emits>; });
    QUELL_HOOK(
        parts, requires { requires is_parts<typename P::parts>; });
    QUELL_HOOK(
        Signal, requires { requires ChannelTag<typename P::Signal>; });
    QUELL_HOOK(
        name, requires { requires is_text<decltype(&P::name)>; });
    QUELL_HOOK(
        needs_camera, requires { requires is_constant<decltype(&P::needs_camera), bool>; });
    QUELL_HOOK(
        checks_jitter, requires { requires is_constant<decltype(&P::checks_jitter), bool>; });
    QUELL_HOOK(
        reads_past_signal, requires { requires is_constant<decltype(&P::reads_past_signal), bool>; });
    QUELL_HOOK(
        leaves_signal, requires { requires is_constant<decltype(&P::leaves_signal), bool>; });
    QUELL_HOOK(
        two_rows, requires { requires is_constant<decltype(&P::two_rows), bool>; });
    QUELL_HOOK(
        max_lanes, requires { requires is_constant<decltype(&P::max_lanes), int>; });
    QUELL_HOOK(
        fraction, requires { requires is_constant<decltype(&P::fraction), int>; });
    QUELL_HOOK(
        farthest_tap, requires { requires is_constant<decltype(&P::farthest_tap), int>; } ||
                          requires(P const& p) { requires std::is_same_v<decltype(p.farthest_tap()), int>; });
    QUELL_HOOK(
        feedback, HasPasses<P> || requires(P const& p) { requires std::is_same_v<decltype(p.feedback()), bool>; });
    QUELL_HOOK(
        memory, requires(P const& p) { requires std::is_class_v<decltype(p.memory())>; });
};
#undef QUELL_HOOK

/// Refuses a policy with a member that quell could take for something else, and a policy with such parts. Always true.
template <class P> constexpr bool check_hooks() {
    using Right = Hooks<P>;
    static_assert(Right::reads, "`reads` of a policy must be `using reads = Channels<...>`; any other member needs another name");
    static_assert(Right::remembers,
                  "`remembers` of a policy must be `using remembers = Channels<...>`; any other member needs another name");
    static_assert(Right::keeps, "`keeps` of a policy must be `using keeps = Channels<...>`; any other member needs another name");
    static_assert(Right::reads_kept,
                  "`reads_kept` of a policy must be `using reads_kept = Channels<...>`; any other member needs another name");
    static_assert(Right::emits, "`emits` of a policy must be `using emits = Channels<...>`; any other member needs another name");
    static_assert(Right::parts, "`parts` of a policy must be `using parts = Parts<...>`; any other member needs another name");
    static_assert(Right::Signal, "`Signal` of a policy must be `using Signal = ` a channel; any other member needs another name");
    static_assert(Right::name, "`name` of a policy must be `static constexpr auto name = \"text\"`; any other member needs another name");
    static_assert(Right::needs_camera, "`needs_camera` of a policy must be a `static constexpr bool`; any other member needs another name");
    static_assert(Right::checks_jitter,
                  "`checks_jitter` of a policy must be a `static constexpr bool`; any other member needs another name");
    static_assert(Right::reads_past_signal,
                  "`reads_past_signal` of a policy must be a `static constexpr bool`; any other member needs another name");
    static_assert(Right::leaves_signal,
                  "`leaves_signal` of a policy must be a `static constexpr bool`; any other member needs another name");
    static_assert(Right::two_rows, "`two_rows` of a policy must be a `static constexpr bool`; any other member needs another name");
    static_assert(Right::max_lanes, "`max_lanes` of a policy must be a `static constexpr int`; any other member needs another name");
    static_assert(Right::fraction, "`fraction` of a policy must be a `static constexpr int`; any other member needs another name");
    static_assert(Right::farthest_tap,
                  "`farthest_tap` of a policy must be a `static constexpr int` or `constexpr int farthest_tap() const`; "
                  "any other member needs another name");
    static_assert(Right::feedback, "`feedback` of a policy must be `constexpr bool feedback() const`; any other member needs another name");
    static_assert(Right::memory,
                  "`memory` of a policy must be `constexpr BlendMemory memory() const`; any other member needs another name");
    return []<class... Ps>(Parts<Ps...>) { return (check_hooks<Ps>() && ...); }(typename PartsOf<P>::type{});
}

/// Functions that quell calls where there are some: of what policies return, and of channels. They may be templates, whose address nobody
/// can take. But a name that a class has as well is ambiguous in what derives from both.
struct OptionalFunctions {
    int accepts, toward, offset, clip, in_memory, interpolated;
};
template <class T> struct WithOptionalFunctions : T, OptionalFunctions {};
template <class T> inline constexpr bool can_be_base = std::is_class_v<T> && !std::is_final_v<T>;
template <class T>
concept NamesAccepts = can_be_base<T> && !requires {
    &WithOptionalFunctions<T>::accepts;
};
template <class T>
concept NamesToward = can_be_base<T> && !requires {
    &WithOptionalFunctions<T>::toward;
};
template <class T>
concept NamesOffset = can_be_base<T> && !requires {
    &WithOptionalFunctions<T>::offset;
};
template <class T>
concept NamesClip = can_be_base<T> && !requires {
    &WithOptionalFunctions<T>::clip;
};
template <class T>
concept NamesInMemory = can_be_base<T> && !requires {
    &WithOptionalFunctions<T>::in_memory;
};
template <class T>
concept NamesInterpolated = can_be_base<T> && !requires {
    &WithOptionalFunctions<T>::interpolated;
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
