#include "take_rows.hpp"

#include <quell/image/format.hpp>

namespace quell_library {

namespace {
/// One row of a component.
template <class Element, class Get> void take_row(Image const& from, int c, int y, float* to, int width, Get const& get) {
    float const scale = c < 2 ? from.scale[c] : 1.f, offset = c < 2 ? from.offset[c] : 0.f; // of vectors
    auto const* at = from.data + (c * from.component_stride + y * from.row_stride);
    if (scale == 1.f && offset == 0.f)
        for (int x = 0; x < width; ++x, at += from.pixel_stride) to[x] = get(reinterpret_cast<Element const*>(at));
    else
        for (int x = 0; x < width; ++x, at += from.pixel_stride) to[x] = get(reinterpret_cast<Element const*>(at)) * scale + offset;
}
} // namespace

void take_rows(Image const& from, int components, float* const* to, std::ptrdiff_t to_row, int width, int y0, int y1) {
    // Row by row, so that components that lie side by side are read from the cache.
    for (int y = y0; y < y1; ++y)
        for (int c = 0; c < components; ++c) {
            auto* const row = to[c] + y * to_row;
            if (from.is_half)
                take_row<std::uint16_t>(from, c, y, row, width, [](std::uint16_t const* half) { return quell::Float16::get(half); });
            else
                take_row<float>(from, c, y, row, width, [](float const* value) { return *value; });
        }
}

} // namespace quell_library
