#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdlib.h>
#include <string>
#include <system_error>

namespace quell::tests {

/// A folder of the test's own, removed with all that it holds. Tests that run at the same time get different ones.
struct Folder {
    std::filesystem::path path = make();

    Folder() = default;
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    ~Folder() {
        std::error_code ignored; // a destructor has nobody to tell
        std::filesystem::remove_all(path, ignored);
    }

    [[nodiscard]] std::filesystem::path operator/(std::string const& name) const { return path / name; }
    [[nodiscard]] int files() const { return static_cast<int>(std::distance(std::filesystem::directory_iterator(path), {})); }

    static std::filesystem::path make() {
        // mkdtemp makes six letters X at the end into a name that nobody has.
        std::string name = (std::filesystem::temp_directory_path() / ("quell_test_" + std::string(6, 'X'))).string();
        if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
        return name;
    }
};

inline std::string bytes_of(std::filesystem::path const& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}
inline void write_bytes(std::filesystem::path const& file, std::string const& bytes) {
    std::ofstream out(file, std::ios::binary);
    out << bytes;
}

} // namespace quell::tests
