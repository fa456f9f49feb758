#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

namespace quell {

/// A named image of a frame with `Components` floats a pixel. A channel is an empty type; its variable (`quell::normal`) is what code
/// writes: `frame[quell::normal]`, `px[quell::normal]`. It also carries the `name` that messages use.
template <int Components> struct Channel {
    static constexpr int components = Components;
    static constexpr bool full_precision = false; ///< true: never stored in half (positions, ids, anything whose ulp at 1000 matters)
    static constexpr int fraction = 1;            ///< its image is as wide and high as the frame divided by this, rounded up: 2 for a half
};

/// A channel that stages make themselves: no host supplies it, and a pipeline in which nothing makes it does not compile.
template <int Components> struct MadeChannel : Channel<Components> {
    static constexpr bool made_by_stages = true;
    static constexpr bool squared =
        false; ///< true: a variance or the like; in half its root is stored, as a half's own range ends at 65504
};

template <class C>
concept ChannelTag = std::is_empty_v<C> && requires {
    { C::components } -> std::convertible_to<int>;
    { C::name } -> std::convertible_to<std::string_view>;
};

/// A set of channels. Sets are values: `a | b` is their union.
template <ChannelTag... Cs> struct Channels {
    template <class C> static constexpr bool has = (std::is_same_v<C, Cs> || ...);
    static constexpr int size = sizeof...(Cs);
};

template <class... As, ChannelTag B> constexpr auto operator+(Channels<As...>, B) {
    if constexpr (Channels<As...>::template has<B>)
        return Channels<As...>{};
    else
        return Channels<As..., B>{};
}
template <class... As, class... Bs> constexpr auto operator|(Channels<As...> set, Channels<Bs...>) { return (set + ... + Bs{}); }

/// The union of several sets.
template <class... Sets> using union_of = decltype((Channels<>{} | ... | Sets{}));

namespace detail {
template <bool wanted, class... As, class... Bs> constexpr auto filtered(Channels<As...>, Channels<Bs...>) {
    return union_of<std::conditional_t<Channels<Bs...>::template has<As> == wanted, Channels<As>, Channels<>>...>{};
}
} // namespace detail

/// The channels of A that are in B as well, and those that are not.
template <class A, class B> using common_to = decltype(detail::filtered<true>(A{}, B{}));
template <class A, class B> using without = decltype(detail::filtered<false>(A{}, B{}));

/// Whether every channel of `Part` is in `Whole`.
template <class Part, class Whole> inline constexpr bool contained_in = std::is_same_v<decltype(Whole{} | Part{}), Whole>;

/// Calls `f(channel)` for every channel of a set, in order.
template <class... Cs, class F> constexpr void for_each_channel(Channels<Cs...>, F&& f) { (f(Cs{}), ...); }

} // namespace quell
