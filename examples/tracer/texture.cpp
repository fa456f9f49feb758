#include "texture.hpp"

#include <array>
#include <utility>

namespace quell::tracer {
namespace {

float linear_from_srgb(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }
float srgb_from_linear(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; }

std::array<float, 256> decoding_table(Encoding encoding) {
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < 256; ++code) {
        float const x = static_cast<float>(code) / 255.f;
        table[code] = encoding == Encoding::srgb ? linear_from_srgb(x) : x;
    }
    return table;
}

glm::vec4 decoded(glm::u8vec4 texel, Encoding encoding) {
    static auto const srgb = decoding_table(Encoding::srgb), linear = decoding_table(Encoding::linear);
    auto const& table = encoding == Encoding::srgb ? srgb : linear;
    return {table[texel.r], table[texel.g], table[texel.b], linear[texel.a]};
}

glm::u8vec4::value_type code(float x) { return static_cast<glm::u8vec4::value_type>(std::lround(glm::clamp(x, 0.f, 1.f) * 255.f)); }

glm::u8vec4 encoded(glm::vec4 colour, Encoding encoding) {
    if (encoding == Encoding::srgb)
        for (int i = 0; i < 3; ++i) colour[i] = srgb_from_linear(glm::clamp(colour[i], 0.f, 1.f));
    return {code(colour.r), code(colour.g), code(colour.b), code(colour.a)};
}

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return glm::clamp(i, 0, size - 1);
    int const period = wrap == Wrap::mirror ? 2 * size : size;
    int const folded = ((i % period) + period) % period;
    return folded < size ? folded : period - 1 - folded;
}

std::size_t texel_index(Texture::Level const& level, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x);
}

Texture::Level halved(Texture::Level const& fine, Encoding encoding) {
    Texture::Level coarse{glm::max(1, fine.width / 2), glm::max(1, fine.height / 2), {}};
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            int const x0 = glm::min(2 * x, fine.width - 1), x1 = glm::min(2 * x + 1, fine.width - 1);
            int const y0 = glm::min(2 * y, fine.height - 1), y1 = glm::min(2 * y + 1, fine.height - 1);
            glm::vec4 sum{0.f};
            for (auto [u, v] : {std::pair{x0, y0}, {x1, y0}, {x0, y1}, {x1, y1}})
                sum += decoded(fine.texels[texel_index(fine, u, v)], encoding);
            coarse.texels.push_back(encoded(sum * 0.25f, encoding));
        }
    return coarse;
}

} // namespace

Texture::Texture(int width, int height, std::vector<glm::u8vec4> texels, Encoding encoding_) : encoding(encoding_) {
    levels.push_back({width, height, std::move(texels)});
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back(), encoding));
}

glm::vec4 Texture::at(glm::vec2 uv, float footprint) const {
    float const texels = footprint * static_cast<float>(glm::max(levels[0].width, levels[0].height));
    int const wanted = texels > 1 ? static_cast<int>(std::lround(std::log2(texels))) : 0;
    auto const& level = levels[static_cast<std::size_t>(glm::clamp(wanted, 0, static_cast<int>(levels.size()) - 1))];
    // Kept within a range that int can hold, whatever a file's texture coordinates are.
    glm::vec2 const place = glm::clamp(uv, -1e4f, 1e4f) * glm::vec2(level.width, level.height) - 0.5f;
    glm::vec2 const corner = glm::floor(place), part = place - corner;
    int const x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    auto const texel = [&](int i, int j) {
        return decoded(level.texels[texel_index(level, wrapped(i, level.width, wrap_u), wrapped(j, level.height, wrap_v))], encoding);
    };
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), part.x), glm::mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
}

Texture painted(int width, int height, std::function<glm::vec3(glm::vec2)> const& colour) {
    std::vector<glm::u8vec4> texels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec2 const uv{(static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                               (static_cast<float>(y) + 0.5f) / static_cast<float>(height)};
            texels.push_back(encoded(glm::vec4(colour(uv), 1.f), Encoding::srgb));
        }
    return {width, height, std::move(texels)};
}

} // namespace quell::tracer
