#pragma once

#include <string_view>

/// The version of quell. CMakeLists.txt reads it from here.
#define QUELL_VERSION_MAJOR 0
#define QUELL_VERSION_MINOR 1
#define QUELL_VERSION_PATCH 0

#define QUELL_TEXT_OF(a) #a
#define QUELL_TEXT(a) QUELL_TEXT_OF(a)

namespace quell {

/// The same as text, such as "1.2.3".
inline constexpr std::string_view version =
    QUELL_TEXT(QUELL_VERSION_MAJOR) "." QUELL_TEXT(QUELL_VERSION_MINOR) "." QUELL_TEXT(QUELL_VERSION_PATCH);

} // namespace quell
#undef QUELL_TEXT
#undef QUELL_TEXT_OF
