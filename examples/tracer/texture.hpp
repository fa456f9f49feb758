#pragma once

#include "math.hpp"

#include <functional>
#include <vector>

namespace quell::tracer {

enum class Wrap { repeat, mirror, clamp };
enum class Encoding { srgb, linear };

/// An image with its mip levels. Texels are kept as they were encoded, 8 bits a component, and decoded when they are fetched.
class Texture {
public:
    struct Level {
        int width = 0, height = 0;
        std::vector<glm::u8vec4> texels;
    };

    Texture() = default;
    Texture(int width, int height, std::vector<glm::u8vec4> texels, Encoding encoding = Encoding::srgb);

    /// Bilinear in the level whose texels are nearest in size to `footprint` (in units of u and v). Row 0 is v = 0, as in glTF.
    [[nodiscard]] glm::vec4 at(glm::vec2 uv, float footprint) const;
    [[nodiscard]] bool empty() const { return levels.empty(); }

    std::vector<Level> levels;
    Encoding encoding = Encoding::srgb;
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

/// A texture computed from a function of u and v in [0, 1] that gives a linear colour.
[[nodiscard]] Texture painted(int width, int height, std::function<glm::vec3(glm::vec2)> const& colour);

} // namespace quell::tracer
