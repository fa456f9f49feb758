#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace quell::tracer {

/// A struct whose tie() refers to all of its members, in order. It binds them by name, so that a member which it doesn't know of yet
/// doesn't compile.
template <class Value>
concept Tied = requires(Value const& value) {
    value.tie();
};

namespace detail {

struct Anything {
    std::size_t place; ///< so that there can be one for each of many
    template <class Value> operator Value() const;
};

template <class Value, std::size_t... places> constexpr bool takes(std::index_sequence<places...>) {
    return requires { Value{Anything{places}...}; };
}

/// How many members an aggregate has: as many initialisers as it takes.
template <class Value, std::size_t count = 0> constexpr std::size_t members_of() {
    if constexpr (takes<Value>(std::make_index_sequence<count + 1>{}))
        return members_of<Value, count + 1>();
    else
        return count;
}

} // namespace detail

/// Whether tie() leaves out none of those that it binds. Of what has constructors nobody can count the members.
template <Tied Value> [[nodiscard]] constexpr bool ties_all_members() {
    if constexpr (std::is_aggregate_v<Value>)
        return std::tuple_size_v<decltype(std::declval<Value const&>().tie())> == detail::members_of<Value>();
    else
        return true;
}

} // namespace quell::tracer
