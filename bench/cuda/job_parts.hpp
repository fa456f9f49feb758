#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/pipeline/composite.hpp>

// Goes through all members of a job, of their members and so on: how a compiler lays a class out, without a list of its members. Only
// addresses are taken, so the object need not be alive. It runs on a device as on the host.
namespace quell::bench {

/// Stands for any member in T{...}.
template <class T> struct AnyMember {
    template <class M>
        requires(!std::is_same_v<M, T> && !std::is_base_of_v<M, T>)
    operator M() const;
};
template <class T, std::size_t> using AnyOf = AnyMember<T>;
/// Stands for any base class in T{...}.
template <class T> struct AnyBase {
    template <class B>
        requires(!std::is_same_v<B, T> && std::is_base_of_v<B, T>)
    operator B() const;
};
template <class T>
concept HasBases = requires {
    T{AnyBase<T>{}};
};

template <class T, std::size_t... before, std::size_t... inner, std::size_t... behind>
constexpr bool takes(std::index_sequence<before...>, std::index_sequence<inner...>, std::index_sequence<behind...>) {
    if constexpr (sizeof...(inner) == 0) return requires {
            T{AnyOf<T, before>{}..., AnyOf<T, behind>{}...};
        };
    else
        return requires { T{AnyOf<T, before>{}..., {AnyOf<T, inner>{}...}, AnyOf<T, behind>{}...}; };
}
/// Whether T can be made of `before` members, then braces around `inner` ones, if any, then `behind` members.
template <class T, std::size_t before, std::size_t inner = 0, std::size_t behind = 0>
inline constexpr bool can_be_made_of = takes<T>(std::make_index_sequence<before>{}, std::make_index_sequence<inner>{},
                                                std::make_index_sequence<behind>{});

/// How many values T can be made of, an array's elements counted one by one.
template <class T, std::size_t n = 0> constexpr std::size_t value_count() {
    if constexpr (can_be_made_of<T, n + 1>)
        return value_count<T, n + 1>();
    else
        return n;
}
/// How many values braces take in place of a member.
template <class T, std::size_t at, std::size_t n = 1> constexpr std::size_t values_in_braces() {
    if constexpr (can_be_made_of<T, at, n + 1>)
        return values_in_braces<T, at, n + 1>();
    else
        return n;
}
/// How many of the values the member at place `at` takes: more than 1 for an array, which leaves fewer for those behind it.
template <class T, std::size_t at, std::size_t count> constexpr std::size_t values_of_member() {
    constexpr std::size_t n = values_in_braces<T, at>();
    if constexpr (n > 1 && at + n <= count)
        return can_be_made_of<T, at, n, count - at - n + 1> ? 1 : n;
    else
        return 1;
}
template <class T, std::size_t at = 0, std::size_t count = value_count<T>()> constexpr std::size_t count_members() {
    if constexpr (at >= count)
        return 0;
    else
        return 1 + count_members<T, at + values_of_member<T, at, count>(), count>();
}
/// How many members an aggregate without base classes has.
template <class T> inline constexpr std::size_t member_count = count_members<T>();
// The same, for what jobs are made of, without counting, which takes long to compile. Where a number is wrong, with_members() does not
// compile.
template <class P, class S, class V, class M, class F, class R, bool marks>
inline constexpr std::size_t member_count<detail::PassJob<P, S, V, M, F, R, marks>> = 10;
template <class F, class S, class O, class R> inline constexpr std::size_t member_count<detail::Finish<F, S, O, R>> = 4;
template <class F, class M, class S, class P, class K, class T, PassTraits traits, class V>
inline constexpr std::size_t member_count<Scope<F, M, S, P, K, T, traits, V>> = 19;
template <class F, int N, class M> inline constexpr std::size_t member_count<detail::PlanarView<F, N, M>> = 2;
template <class C, class T> inline constexpr std::size_t member_count<detail::Slot<C, T>> = 1;
template <class Job> inline constexpr std::size_t member_count<detail::LateJob<Job>> = 3;
/// Calls each(members...) with all members of an aggregate without base classes.
template <class T> constexpr void with_members(T const& of, auto&& each) {
    constexpr std::size_t n = member_count<T>;
    static_assert(n <= 24, "a class in a job has more members than with_members() goes through: write more of its lines");
// C++20 has no list of names of a length that a template chooses.
#define QUELL_MEMBERS(count, ...)                                                                                                          \
    if constexpr (n == count) {                                                                                                            \
        auto const& [__VA_ARGS__] = of;                                                                                                    \
        each(__VA_ARGS__);                                                                                                                 \
    }
    QUELL_MEMBERS(1, m0)
    QUELL_MEMBERS(2, m0, m1)
    QUELL_MEMBERS(3, m0, m1, m2)
    QUELL_MEMBERS(4, m0, m1, m2, m3)
    QUELL_MEMBERS(5, m0, m1, m2, m3, m4)
    QUELL_MEMBERS(6, m0, m1, m2, m3, m4, m5)
    QUELL_MEMBERS(7, m0, m1, m2, m3, m4, m5, m6)
    QUELL_MEMBERS(8, m0, m1, m2, m3, m4, m5, m6, m7)
    QUELL_MEMBERS(9, m0, m1, m2, m3, m4, m5, m6, m7, m8)
    QUELL_MEMBERS(10, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9)
    QUELL_MEMBERS(11, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10)
    QUELL_MEMBERS(12, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11)
    QUELL_MEMBERS(13, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12)
    QUELL_MEMBERS(14, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13)
    QUELL_MEMBERS(15, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14)
    QUELL_MEMBERS(16, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15)
    QUELL_MEMBERS(17, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16)
    QUELL_MEMBERS(18, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17)
    QUELL_MEMBERS(19, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18)
    QUELL_MEMBERS(20, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19)
    QUELL_MEMBERS(21, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20)
    QUELL_MEMBERS(22, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21)
    QUELL_MEMBERS(23, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21, m22)
    QUELL_MEMBERS(24, m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21, m22, m23)
#undef QUELL_MEMBERS
}

/// The base classes of classes that consist of them.
template <class T> struct BasesOf { using type = Parts<>; };
template <class... Edges> struct BasesOf<Product<Edges...>> { using type = Parts<Edges...>; };
template <class S, class... Cs> struct BasesOf<Views<S, Channels<Cs...>>> { using type = Parts<detail::Slot<Cs, ViewOf<S, Cs>>...>; };
template <std::size_t... i, class... Ps> struct BasesOf<detail::NumberedSignals<std::index_sequence<i...>, Ps...>> {
    using type = Parts<detail::Slot<std::integral_constant<std::size_t, i>, Ps>...>;
};

/// Calls visit(part) for each class, array, pointer and number in an object: for the whole first, then for its parts. A class that is no
/// aggregate, or that has other base classes than those above, counts as a number.
template <class T> constexpr void visit_parts(T const& of, auto&& visit) {
    visit(of);
    if constexpr (std::is_array_v<T>)
        for (auto const& element : of) visit_parts(element, visit);
    else if constexpr (!std::is_same_v<typename BasesOf<T>::type, Parts<>>)
        [&]<class... Bases>(Parts<Bases...>) { (visit_parts<Bases>(of, visit), ...); }(typename BasesOf<T>::type{});
    else if constexpr (std::is_class_v<T> && std::is_aggregate_v<T> && !HasBases<T>)
        with_members(of, [&](auto const&... members) { (visit_parts(members, visit), ...); });
}

} // namespace quell::bench
