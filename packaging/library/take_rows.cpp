#include "take_rows.hpp"

#include <quell/image/format.hpp>

namespace quell_library {

namespace {
/// One row of floats that lie `stride` after each other, a constant of the compiler's where that is fastest.
template <int stride> void take_floats(float const* from, std::ptrdiff_t any_stride, float* to, int width) {
    std::ptrdiff_t const step = stride > 0 ? stride : any_stride;
    for (int x = 0; x < width; ++x) to[x] = from[x * step];
}
void take_floats(std::byte const* at, std::ptrdiff_t bytes, float* to, int width) {
    auto const* const from = reinterpret_cast<float const*>(at);
    constexpr std::ptrdiff_t element = sizeof(float);
    switch (bytes) {
    case element:
        return take_floats<1>(from, 1, to, width);
    case 2 * element:
        return take_floats<2>(from, 2, to, width);
    case 3 * element:
        return take_floats<3>(from, 3, to, width);
    case 4 * element:
        return take_floats<4>(from, 4, to, width);
    default:
        break;
    }
    if (bytes % element == 0) return take_floats<0>(from, bytes / element, to, width);
    for (int x = 0; x < width; ++x, at += bytes) to[x] = *reinterpret_cast<float const*>(at);
}
} // namespace

void take_rows(Image const& from, int components, float* const* to, std::ptrdiff_t to_row, int width, int y0, int y1) {
    // Row by row, so that components that lie side by side are read from the cache.
    for (int y = y0; y < y1; ++y)
        for (int c = 0; c < components; ++c) {
            auto* const row = to[c] + y * to_row;
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
