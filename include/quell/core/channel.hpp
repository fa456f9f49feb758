#pragma once

#include <quell/core/kernel.hpp>

#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A named image of a frame. A channel is an empty type with a `name`, which messages and EXR layers use. Code indexes with a variable of
/// the type: `frame[quell::normal]`, `px[quell::normal]`.
/// @tparam Components floats per pixel
template <int Components> struct Channel {
    static constexpr int components = Components;     ///< floats per pixel
    static constexpr bool full_precision = false;     ///< true: never stored in half. Half has steps of 0.5 at 1000.
    static constexpr int fraction = 1;                ///< image size = frame size / fraction, rounded up. 2: half resolution.
    static constexpr bool finite_on_surfaces = false; ///< true: diagnose() says so where it is not finite on a surface
    static constexpr bool is_guide = false;           ///< true: every pixel must have it, also where a signal has fewer samples
    /// Names of the components in files, a letter for each: `normal.X`. Of a single component it is the whole name: `instance.ID`. More
    /// than four have numbers.
    static constexpr std::string_view component_names = Components == 1 ? "V" : "XYZW";
};

/// A channel that stages make and no host supplies. A pipeline that reads it without a stage that makes it does not compile. Memory may
/// hold another form of it than policies return, as of ConeLuminance: static functions `in_memory(value)` and `interpolated(in memory,
/// signal)`, which history fetches call, convert.
template <int Components> struct InternalChannel : Channel<Components> {
    static constexpr bool made_by_stages = true; ///< marks it for Pipeline
    static constexpr bool squared = false;       ///< true: a variance. Half stores its square root, since half ends at 65504.
    static constexpr bool always_half = false;   ///< true: always stored in half, for values of about 1
};

/// An InternalChannel that is never stored in half.
template <int Components> struct ExactChannel : InternalChannel<Components> {
    static constexpr bool full_precision = true; ///< never half
};

/// An empty type with `components` and `name`.
template <class C>
concept ChannelTag = std::is_empty_v<C> && requires {
    { C::components } -> std::convertible_to<int>;
    { C::name } -> std::convertible_to<std::string_view>;
};

namespace detail {
/// Whether the address of a member is that of a `static constexpr T`.
template <class Address, class T> inline constexpr bool is_constant = std::is_same_v<Address, T const*>;

/// Whether `component_names` has one for each component.
template <class C> constexpr bool names_components() {
    if constexpr (requires { std::string_view(C::component_names); }) {
        constexpr auto letters = std::string_view(C::component_names).size();
        return C::components == 1 ? letters > 0 : C::components > 4 || letters >= std::size_t{C::components};
    } else
        return false;
}

/// Whether what a channel says of itself, and what it has from Channel, is of the kind that quell reads.
template <class C>
concept SaysRightly = requires {
    requires is_constant<decltype(&C::components), int> && is_constant<decltype(&C::fraction), int>;
    requires is_constant<decltype(&C::full_precision), bool> && is_constant<decltype(&C::finite_on_surfaces), bool>;
    requires is_constant<decltype(&C::is_guide), bool>;
    requires names_components<C>();
}
&&(
    !requires { C::made_by_stages; } || requires { requires is_constant<decltype(&C::made_by_stages), bool>; }) &&
    (
        !requires { C::squared; } || requires { requires is_constant<decltype(&C::squared), bool>; }) &&
    (
        !requires { C::always_half; } || requires { requires is_constant<decltype(&C::always_half), bool>; });
} // namespace detail

/// A set of channels, in order of first mention. Sets are values: `a | b` is their union.
template <class... Cs> struct Channels {
    static_assert((ChannelTag<Cs> && ...), "Channels<...>: each must be a channel: an empty struct that derives from Channel<N> and has a "
                                           "`static constexpr auto name = \"text\"`");
    static_assert(
        ((!ChannelTag<Cs> || detail::SaysRightly<Cs>)&&...),
        "a channel must derive from Channel<N> or InternalChannel<N>; `components` and `fraction` must be `static constexpr int`, "
        "`full_precision`, `finite_on_surfaces`, `is_guide`, `made_by_stages`, `squared` and `always_half` `static constexpr bool`, and "
        "`component_names` a text with a letter for each component");
    /// Whether C is in the set.
    template <class C> static constexpr bool has = (std::is_same_v<C, Cs> || ...);
    /// The number of channels.
    static constexpr int size = sizeof...(Cs);
};

/// The set with one more channel, unless it has it already.
template <class... As, ChannelTag B> constexpr auto operator+(Channels<As...>, B) {
    if constexpr (Channels<As...>::template has<B>)
        return Channels<As...>{};
    else
        return Channels<As..., B>{};
}
/// The union of two sets.
template <class... As, class... Bs> constexpr auto operator|(Channels<As...> set, Channels<Bs...>) { return (set + ... + Bs{}); }

/// The union of several sets.
template <class... Sets> using union_of = decltype((Channels<>{} | ... | Sets{}));

namespace detail {
/// A message that compilers print with the template arguments of a deleted function.
template <std::size_t size> struct Sentence {
    char text[size]{};
    constexpr Sentence(char const (&from)[size]) {
        for (std::size_t i = 0; i < size; ++i) text[i] = from[i];
    }
};

template <bool wanted, class... As, class... Bs> constexpr auto filtered(Channels<As...>, Channels<Bs...>) {
    return union_of<std::conditional_t<Channels<Bs...>::template has<As> == wanted, Channels<As>, Channels<>>...>{};
}
} // namespace detail

/// The channels of A that are also in B.
template <class A, class B> using common_to = decltype(detail::filtered<true>(A{}, B{}));
/// The channels of A that are not in B.
template <class A, class B> using without = decltype(detail::filtered<false>(A{}, B{}));

/// Whether every channel of `Part` is in `Whole`.
template <class Part, class Whole> inline constexpr bool contained_in = std::is_same_v<decltype(Whole{} | Part{}), Whole>;

/// Calls `f(channel)` for every channel of the set, in order.
template <class... Cs, class F> constexpr void for_each_channel(Channels<Cs...>, F&& f) { (f(Cs{}), ...); }

} // namespace quell::inline QUELL_INSTRUCTION_SET
