#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace quell::tracer {

/// A struct whose tie() refers to all of its members, in order. It binds them by name, so that a member which it doesn't know of yet
/// doesn't compile.
template <class Value>
concept Tied = requires(Value const& value) {
    value.tie();
};

namespace detail {

/// Bytes of a struct with these members, padding included.
template <class... Members> constexpr std::size_t size_of_struct_with() {
    std::size_t end = 0, alignment = 1;
    auto const align = [&](std::size_t to) { end = (end + to - 1) / to * to; };
    ((align(alignof(Members)), end += sizeof(Members), alignment = std::max(alignment, alignof(Members))), ...);
    align(alignment);
    return end;
}

template <class Tie> struct TiedSize;
template <class... Members> struct TiedSize<std::tuple<Members const&...>> {
    static constexpr std::size_t value = size_of_struct_with<Members...>();
};

} // namespace detail

/// Whether tie() leaves out none of those that it binds: what it refers to takes as many bytes as the struct.
template <Tied Value>
inline constexpr bool ties_all_members = detail::TiedSize<decltype(std::declval<Value const&>().tie())>::value == sizeof(Value);

} // namespace quell::tracer
