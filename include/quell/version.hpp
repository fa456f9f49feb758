#pragma once

#include <quell/core/instruction_set.hpp>

#include <string_view>

// CMakeLists.txt reads the version from here.
#define QUELL_VERSION_MAJOR 0 ///< first number of quell's version
#define QUELL_VERSION_MINOR 1 ///< second number of quell's version
#define QUELL_VERSION_PATCH 0 ///< third number of quell's version

#define QUELL_TEXT_OF(a) #a
#define QUELL_TEXT(a) QUELL_TEXT_OF(a)

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The version of quell as text, such as "1.2.3".
inline constexpr std::string_view version =
    QUELL_TEXT(QUELL_VERSION_MAJOR) "." QUELL_TEXT(QUELL_VERSION_MINOR) "." QUELL_TEXT(QUELL_VERSION_PATCH);

} // namespace quell::inline QUELL_INSTRUCTION_SET
#undef QUELL_TEXT
#undef QUELL_TEXT_OF
