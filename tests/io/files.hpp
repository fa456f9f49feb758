#pragma once

#include <doctest/doctest.h>
#include <quell/io/exr.hpp>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>

// Files and images to test with.
namespace quell::tests {

/// A folder of the test's own, removed with all that it holds.
struct Folder {
    std::filesystem::path path = make();

    Folder() = default;
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    ~Folder() { std::filesystem::remove_all(path); }

    [[nodiscard]] std::filesystem::path operator/(std::string const& name) const { return path / name; }
    [[nodiscard]] int files() const { return static_cast<int>(std::distance(std::filesystem::directory_iterator(path), {})); }

    static std::filesystem::path make() {
        std::string name = (std::filesystem::temp_directory_path() / "quell_io_XXXXXX").string();
        return mkdtemp(name.data());
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

/// A plane whose value at (x, y) is f(x, y).
inline io::Plane plane(std::string name, Extent size, std::function<float(int, int)> const& f,
                       io::SampleType type = io::SampleType::float32) {
    io::Plane result{.name = std::move(name), .type = type, .values = {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) result.values.push_back(f(x, y));
    return result;
}

/// The message of the Error that f throws; empty where it throws none.
inline std::string message_of(std::function<void()> const& f) {
    try {
        f();
    } catch (Error const& error) {
        return error.what();
    }
    return {};
}
inline bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

/// Checks that f throws an Error that says all of these.
inline void check_error(std::function<void()> const& f, std::initializer_list<std::string> parts) {
    auto const message = message_of(f);
    INFO("message: ", message);
    CHECK_FALSE(message.empty());
    CHECK_FALSE(contains(message, "\n"));
    for (auto const& part : parts) {
        INFO("part: ", part);
        CHECK(contains(message, part));
    }
}

/// Data that lies beside the repository; empty, with a line that says so, where it doesn't.
inline std::filesystem::path shared(std::string const& name) {
    auto const* const folder = std::getenv("QUELL_SHARED");
    auto const path = std::filesystem::path(folder ? folder : "../shared") / name;
    if (std::filesystem::exists(path)) return path;
    MESSAGE("skipped: there is no ", path.string(), " (QUELL_SHARED names the folder)");
    return {};
}

} // namespace quell::tests
