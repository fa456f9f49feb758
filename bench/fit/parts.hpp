#pragma once

#include <array>
#include <bitset>
#include <string>

namespace quell::bench {

/// What a picture is made of: an effect that may have a pipeline of its own, or the rest of the picture as one colour.
enum class Part { shadow, glossy, indirect, rest };

inline constexpr std::array effects{Part::shadow, Part::glossy, Part::indirect};

[[nodiscard]] inline char const* name_of(Part part) {
    constexpr std::array names{"shadow", "glossy", "indirect", "rest"};
    return names[static_cast<std::size_t>(part)];
}

/// Some of the effects.
using Effects = std::bitset<effects.size()>;

[[nodiscard]] inline bool has(Effects const& some, Part effect) { return some[static_cast<std::size_t>(effect)]; }
[[nodiscard]] inline Effects with(Effects some, Part effect) { return some.set(static_cast<std::size_t>(effect)); }

} // namespace quell::bench
