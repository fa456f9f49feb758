#pragma once

#include <quell/core/error.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// Replaces a file atomically: writes the bytes beside it, under a name that no other process takes, and renames. At every moment the file
/// is the old one or the new one.
/// @throws Failure naming the file
inline void replace_file(std::filesystem::path const& path, std::string_view bytes) {
    auto partial = path;
    partial.concat(".").concat(std::to_string(std::random_device{}())).concat(".partial");
    std::error_code why;
    {
        errno = 0;
        std::ofstream file(partial, std::ios::binary);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) why.assign(errno != 0 ? errno : EIO, std::generic_category());
    }
    if (!why) std::filesystem::rename(partial, path, why);
    if (!why) return;
    std::error_code none;
    std::filesystem::remove(partial, none);
    throw Failure(path.string(), "it can't be written: " + why.message(), "check that its folder exists, may be written to, and has room");
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
