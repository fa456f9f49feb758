#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/executor.hpp>
#include <quell/image/extent.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace quell::io {

/// How a file stores one number.
enum class SampleType { half, float32, uint32 };

inline std::string to_string(SampleType type) {
    if (type == SampleType::half) return "half";
    return type == SampleType::float32 ? "float" : "uint";
}

/// One component of an image under the name that its file gives it, row by row from the top-left.
struct Plane {
    std::string name;
    SampleType type = SampleType::float32;
    std::vector<float> values;
    std::optional<Region> stored = {}; ///< the pixels that the file has, the others being 0; without it, all
    bool exact = true;                 ///< false where the file's numbers (of 32 bits without sign) have more digits than a float
};

/// A matrix is column-major and for column vectors, as everywhere in quell; OpenEXR's own are for row vectors, which in memory is the same.
using Attribute = std::variant<std::string, int, float, glm::vec2, glm::mat4>;

/// What lies in an EXR file: planes of one size, of any names and any number, and attributes.
struct ExrImage {
    std::string name = "image"; ///< what messages call it: the file's path
    Extent size;
    std::vector<Plane> planes = {};
    std::map<std::string, Attribute, std::less<>> attributes = {};

    [[nodiscard]] Plane const* find(std::string_view plane) const {
        for (auto const& p : planes)
            if (p.name == plane) return &p;
        return nullptr;
    }
    /// @throws Error, listing the planes that there are
    [[nodiscard]] Plane const& operator[](std::string_view plane) const;

    /// An attribute's value, or null where there is none of that name and type.
    template <class Value> [[nodiscard]] Value const* attribute(std::string_view key) const {
        auto const found = attributes.find(key);
        return found == attributes.end() ? nullptr : std::get_if<Value>(&found->second);
    }
    [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(size.pixels()); }
};

namespace detail {
/// "A, B and 3 more" of things that have a name.
inline std::string list_of_names(auto const& named) {
    constexpr std::size_t most = 60;
    std::string list;
    std::size_t count = 0;
    for (auto const& each : named)
        if (count++ < most) list += (count > 1 ? ", " : "") + each.name;
    if (count > most) list += " and " + std::to_string(count - most) + " more";
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

} // namespace quell::io
