#include "patterns.hpp"
#include "sampler.hpp"

namespace quell::tracer {
namespace {

constexpr int resolution = 512;

/// A fixed random number in [0, 1) for a cell.
float random_of(int x, int y, std::uint32_t seed = 0) {
    auto const cell = static_cast<std::uint32_t>(x) * 0x9e3779b1u + static_cast<std::uint32_t>(y) * 0x85ebca77u;
    return detail::unit_interval(detail::mix_bits(cell + seed * 0xc2b2ae3du));
}

struct Cell {
    int x, y;
    glm::vec2 inside; ///< place within the cell, 0..1
    [[nodiscard]] float edge() const { return glm::min(glm::min(inside.x, 1 - inside.x), glm::min(inside.y, 1 - inside.y)); }
};

Cell cell_of(glm::vec2 uv, glm::vec2 count) {
    auto const place = uv * count, corner = glm::floor(place);
    return {static_cast<int>(corner.x), static_cast<int>(corner.y), place - corner};
}

/// Rows of cells, every other one shifted by half a cell.
Cell brick_of(glm::vec2 uv, int rows) {
    float const row = std::floor(uv.y * static_cast<float>(rows));
    float const shift = std::fmod(row, 2.f) * 0.5f / (static_cast<float>(rows) * 0.5f);
    return cell_of({glm::fract(uv.x + shift), uv.y}, {static_cast<float>(rows) * 0.5f, static_cast<float>(rows)});
}

} // namespace

float noise(glm::vec2 uv, int period, std::uint32_t seed) {
    auto const place = uv * static_cast<float>(period), corner = glm::floor(place), part = place - corner;
    auto const smooth = part * part * (3.f - 2.f * part);
    auto const at = [&](int dx, int dy) {
        int const x = (static_cast<int>(corner.x) + dx) % period, y = (static_cast<int>(corner.y) + dy) % period;
        return random_of(x, y, seed + static_cast<std::uint32_t>(period));
    };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), smooth.x), glm::mix(at(0, 1), at(1, 1), smooth.x), smooth.y);
}

float fractal_noise(glm::vec2 uv, int period, int octaves, std::uint32_t seed) {
    float sum = 0, weight = 0.5f;
    for (int i = 0; i < octaves; ++i, period *= 2, weight *= 0.5f) sum += weight * noise(uv, period, seed);
    return sum / (1 - 2 * weight);
}

Texture checker(glm::vec3 first, glm::vec3 second, int squares) {
    return painted(resolution, resolution, [=](glm::vec2 uv) {
        auto const cell = cell_of(uv, glm::vec2{static_cast<float>(squares)});
        return (cell.x + cell.y) % 2 == 0 ? first : second;
    });
}

Texture bricks(glm::vec3 brick, glm::vec3 mortar, int rows) {
    return painted(resolution, resolution, [=](glm::vec2 uv) {
        auto const cell = brick_of(uv, rows);
        float const tone = 0.7f + 0.45f * random_of(cell.x, cell.y) + 0.3f * (fractal_noise(uv, 32) - 0.5f);
        bool const joint = cell.inside.x < 0.04f || cell.inside.y < 0.09f;
        return joint ? mortar * (0.8f + 0.3f * fractal_noise(uv, 64)) : brick * tone;
    });
}

Texture planks(glm::vec3 wood, int boards) {
    return painted(resolution, resolution, [=](glm::vec2 uv) {
        int const board = static_cast<int>(uv.y * static_cast<float>(boards));
        float const shift = random_of(board, 7);
        auto const cell = cell_of({glm::fract(uv.x + shift), uv.y}, {2.f, static_cast<float>(boards)});
        float const grain = fractal_noise({glm::fract(uv.x + shift), glm::fract(uv.y * 9)}, 6, 5, static_cast<std::uint32_t>(board));
        float const tone = (0.65f + 0.5f * random_of(cell.x, cell.y)) * (0.7f + 0.6f * grain);
        bool const joint = cell.inside.y < 0.03f || cell.inside.x < 0.006f;
        return wood * (joint ? 0.25f : tone);
    });
}

Texture tiles(glm::vec3 tile, glm::vec3 joint, int count) {
    return painted(resolution, resolution, [=](glm::vec2 uv) {
        auto const cell = cell_of(uv, glm::vec2{static_cast<float>(count)});
        float const tone = 0.75f + 0.3f * random_of(cell.x, cell.y) + 0.35f * (fractal_noise(uv, 8, 5) - 0.5f);
        return cell.edge() < 0.02f ? joint : tile * tone;
    });
}

Texture marble(glm::vec3 stone, glm::vec3 vein) {
    return painted(resolution, resolution, [=](glm::vec2 uv) {
        float const bend = 4 * (fractal_noise(uv, 4, 6) - 0.5f);
        float const wave = std::abs(std::sin(pi * (2 * uv.x + 2 * uv.y + bend)));
        return glm::mix(vein, stone, std::pow(wave, 0.35f)) * (0.85f + 0.3f * fractal_noise(uv, 16, 4, 3));
    });
}

Texture plaster(glm::vec3 colour) {
    return painted(resolution, resolution, [=](glm::vec2 uv) { return colour * (0.85f + 0.3f * fractal_noise(uv, 8, 6)); });
}

Texture stripes(glm::vec3 first, glm::vec3 second, int count) {
    return painted(resolution, 4, [=](glm::vec2 uv) { return glm::fract(uv.x * static_cast<float>(count)) < 0.5f ? first : second; });
}

Texture tile_roughness(float least, float most, int count) {
    std::vector<glm::u8vec4> texels;
    for (int y = 0; y < resolution; ++y)
        for (int x = 0; x < resolution; ++x) {
            float const roughness = glm::mix(least, most, random_of(x * count / resolution, y * count / resolution, 5));
            texels.emplace_back(255, static_cast<glm::u8vec4::value_type>(std::lround(255 * roughness)), 255, 255);
        }
    return {resolution, resolution, std::move(texels), Encoding::linear};
}

} // namespace quell::tracer
