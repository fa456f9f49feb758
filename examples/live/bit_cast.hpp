#pragma once

// What the standard library of Debian's emscripten lacks of C++20, and quell uses. The compiler has it.
#include <bit>

#if !defined(__cpp_lib_bit_cast)
namespace std {
template <class To, class From> constexpr To bit_cast(From const& from) noexcept { return __builtin_bit_cast(To, from); }
} // namespace std
#endif
