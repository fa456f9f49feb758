#pragma once

#include <span>
#include <string>

namespace quell::examples {

/// The bytes in base64 (RFC 4648, padded), the form in which a data URI carries them.
std::string encode_base64(std::span<unsigned char const> bytes);

} // namespace quell::examples
