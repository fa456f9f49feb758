#pragma once

#include "texture.hpp"

#include <cstdint>

namespace quell::tracer {

// Procedural textures for the built-in scenes. All of them tile. Colours are linear.

[[nodiscard]] Texture checker(glm::vec3 first, glm::vec3 second, int squares);
[[nodiscard]] Texture bricks(glm::vec3 brick, glm::vec3 mortar, int rows);
[[nodiscard]] Texture planks(glm::vec3 wood, int boards);
[[nodiscard]] Texture tiles(glm::vec3 tile, glm::vec3 joint, int count);
[[nodiscard]] Texture marble(glm::vec3 stone, glm::vec3 vein);
[[nodiscard]] Texture plaster(glm::vec3 colour);
[[nodiscard]] Texture stripes(glm::vec3 first, glm::vec3 second, int count);

/// Roughness in G and metallic in B for tiles that differ from each other: roughness from `least` to `most`, as in a metallic-roughness
/// texture.
[[nodiscard]] Texture tile_roughness(float least, float most, int count);

/// Smooth tiling noise around 0.5 in (0, 1); `period`: lattice cells along u and v in [0, 1].
[[nodiscard]] float noise(glm::vec2 uv, int period, std::uint32_t seed = 0);
/// Several octaves of it.
[[nodiscard]] float fractal_noise(glm::vec2 uv, int period, int octaves = 4, std::uint32_t seed = 0);

} // namespace quell::tracer
