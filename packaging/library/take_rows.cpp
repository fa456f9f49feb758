#include "host_images.hpp"

namespace quell_library {

namespace {
template <class Element, class Get>
void take(Image const& from, int c, float* to, std::ptrdiff_t to_row, int width, int y0, int y1, Get const& get) {
    bool const is_vector = c < 2;
    float const scale = is_vector ? from.scale[c] : 1.f, offset = is_vector ? from.offset[c] : 0.f;
    for (int y = y0; y < y1; ++y) {
        auto const* at = from.data + (c * from.component_stride + y * from.row_stride);
        auto* const row = to + y * to_row;
        if (scale == 1.f && offset == 0.f)
            for (int x = 0; x < width; ++x, at += from.pixel_stride) row[x] = get(*reinterpret_cast<Element const*>(at));
        else
            for (int x = 0; x < width; ++x, at += from.pixel_stride) row[x] = get(*reinterpret_cast<Element const*>(at)) * scale + offset;
    }
}
} // namespace

void take_rows(Image const& from, int components, float* const* to, std::ptrdiff_t to_row, int width, int y0, int y1) {
    // Row by row, so that components that lie side by side are read from the cache.
    for (int y = y0; y < y1; ++y)
        for (int c = 0; c < components; ++c)
            if (from.is_half)
                take<std::uint16_t>(from, c, to[c], to_row, width, y, y + 1,
                                    [](std::uint16_t const& half) { return quell::Float16::get(&half); });
            else
                take<float>(from, c, to[c], to_row, width, y, y + 1, [](float value) { return value; });
}

} // namespace quell_library
