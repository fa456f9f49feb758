#include "take_rows.hpp"

#include <quell/image/format.hpp>
#include <quell/image/subsampled.hpp>

#include <algorithm>
#include <type_traits>

namespace quell_library {

namespace {
template <std::ptrdiff_t floats> inline constexpr std::integral_constant<std::ptrdiff_t, floats> apart;

/// One row of floats. Compilers vectorise distances that they know.
void take_floats(float const* from, auto distance, float* to, int width) {
    for (int x = 0; x < width; ++x) to[x] = from[x * distance];
}
void take_floats(std::byte const* at, std::ptrdiff_t bytes, float* to, int width) {
    auto const* const from = reinterpret_cast<float const*>(at);
    constexpr std::ptrdiff_t element = sizeof(float);
    if (bytes == element) return take_floats(from, apart<1>, to, width);
    if (bytes == 2 * element) return take_floats(from, apart<2>, to, width);
    if (bytes == 3 * element) return take_floats(from, apart<3>, to, width);
    if (bytes == 4 * element) return take_floats(from, apart<4>, to, width);
    for (int x = 0; x < width; ++x, at += bytes) to[x] = *reinterpret_cast<float const*>(at);
}

float component_at(Image const& from, int c, int x, int y) {
    auto const* const at = from.data + (c * from.component_stride + x * from.pixel_stride + y * from.row_stride);
    return from.is_half ? quell::Float16::get(reinterpret_cast<std::uint16_t const*>(at)) : *reinterpret_cast<float const*>(at);
}

/// One row of an image of fewer samples than pixels.
void take_samples(Image const& from, int c, float* to, int width, int y) {
    auto const& samples = from.samples;
    quell::SamplePattern const pattern{samples.columns, samples.rows, samples.staggered != 0};
    int const row = y / pattern.rows;
    for (int x = 0; x < width; ++x) {
        int const column = x / pattern.columns;
        auto const pixel = pattern.pixel(column, row, {samples.phase_x, samples.phase_y});
        auto const place = samples.side_by_side ? glm::ivec2(column, row) : pixel;
        bool const has = pixel == glm::ivec2(x, y) && place.x < samples.width && place.y < samples.height;
        to[x] = has || samples.repeats ? component_at(from, c, std::min(place.x, samples.width - 1), std::min(place.y, samples.height - 1))
                                       : quell::detail::no_sample;
    }
}
} // namespace

void take_rows(Image const& from, int components, float* const* to, std::ptrdiff_t to_row, int width, int y0, int y1) {
    // Row by row, so that components that lie side by side are read from the cache.
    for (int y = y0; y < y1; ++y)
        for (int c = 0; c < components; ++c) {
            auto* const row = to[c] + y * to_row;
            if (from.samples.columns > 0) {
                take_samples(from, c, row, width, y);
                continue;
            }
            auto const* at = from.data + (c * from.component_stride + y * from.row_stride);
            if (!from.is_half)
                take_floats(at, from.pixel_stride, row, width);
            else
                for (int x = 0; x < width; ++x, at += from.pixel_stride)
                    row[x] = quell::Float16::get(reinterpret_cast<std::uint16_t const*>(at));
            if (c < 2 && (from.scale[c] != 1.f || from.offset[c] != 0.f)) // of vectors
                for (int x = 0; x < width; ++x) row[x] = row[x] * from.scale[c] + from.offset[c];
        }
}

} // namespace quell_library
