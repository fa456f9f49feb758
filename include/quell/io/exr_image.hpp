#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/executor.hpp>
#include <quell/image/extent.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// Number format in a file: 16-bit float, 32-bit float, or 32-bit unsigned integer.
enum class SampleType { half, float32, uint32 };

inline std::string to_string(SampleType type) {
    if (type == SampleType::half) return "half";
    return type == SampleType::float32 ? "float" : "uint";
}

/// One component of an image, row by row from the top-left.
struct Plane {
    std::string name;                      ///< in the file, such as "albedo.R"
    SampleType type = SampleType::float32; ///< in the file
    std::vector<float> values;             ///< one per pixel of the image
    std::optional<Region> stored = {};     ///< pixels that the file holds, the others being 0; empty: all
    bool exact = true;                     ///< false if 32-bit integers of the file lost digits as floats
    std::string with_part = {};            ///< another name for it: that of its part before the one that it has there
};

/// Value of an attribute. Matrices are column-major for column vectors, as everywhere in quell. OpenEXR's are for row vectors, which is the
/// same in memory.
using Attribute = std::variant<std::string, int, float, glm::vec2, glm::mat4>;

/// Contents of an EXR file: planes of one size, and attributes.
struct ExrImage {
    std::string name = "image";                                    ///< for messages: the file's path
    Extent size;                                                   ///< of all planes, in pixels
    std::vector<Plane> planes = {};                                ///< in the file's order
    std::map<std::string, Attribute, std::less<>> attributes = {}; ///< by name

    /// The plane of that name, with or without its part's name; null if there is none.
    [[nodiscard]] Plane const* find(std::string_view plane) const {
        for (auto const& p : planes)
            if (p.name == plane) return &p;
        for (auto const& p : planes)
            if (!p.with_part.empty() && p.with_part == plane) return &p;
        return nullptr;
    }
    /// Whether there are planes of all these names.
    [[nodiscard]] bool has_all(std::vector<std::string> const& names) const {
        return std::ranges::all_of(names, [this](auto const& plane) { return find(plane) != nullptr; });
    }
    /// The plane of that name.
    /// @throws Error listing the planes if there is none
    [[nodiscard]] Plane const& operator[](std::string_view plane) const;

    /// Value of an attribute; null if there is none of that name and type.
    template <class Value> [[nodiscard]] Value const* attribute(std::string_view key) const {
        auto const found = attributes.find(key);
        return found == attributes.end() ? nullptr : std::get_if<Value>(&found->second);
    }
    /// Number of pixels.
    [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(size.pixels()); }
};

namespace detail {
/// "A, B and 3 more", from objects with a name.
inline std::string list_of_names(auto const& named) {
    constexpr std::size_t max_listed = 60;
    std::string list;
    std::size_t count = 0;
    for (auto const& each : named)
        if (count++ < max_listed) list += (count > 1 ? ", " : "") + each.name;
    if (count > max_listed) list += " and " + std::to_string(count - max_listed) + " more";
    return count > 0 ? list : "none";
}
[[noreturn]] inline void throw_missing(std::string const& file, std::string_view channel, auto const& named) {
    throw Error(file, "it has no channel '" + std::string(channel) + "'",
                "render that channel, or name another with a channel map; it has: " + list_of_names(named));
}
} // namespace detail

inline Plane const& ExrImage::operator[](std::string_view plane) const {
    if (auto const* const found = find(plane)) return *found;
    detail::throw_missing(name, plane, planes);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
