#pragma once

#include "../shared_data.hpp"
#include "../temporary_folder.hpp"

#include <doctest/doctest.h>
#include <quell/io/exr.hpp>

#include <functional>

// Files and images to test with.
namespace quell::tests {

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

} // namespace quell::tests
