#pragma once

#include <quell/core/error.hpp>
#include <quell/image/format.hpp>
#include <quell/image/image_storage.hpp>

namespace quell {

/// A host's own memory, copied nowhere: a pointer, the image's size and the strides, set for each channel before a frame runs.
///     Frame frame{size, pipeline, Borrowed<>{}};
///     frame[depth] = {pointer, size, 1, 1920}; // from a pixel to the next, from a row to the next
/// The memory must outlive the run. Rows whose pixels lie side by side (`pixel_stride` 1) load as fast as Planar.
/// @tparam Format Float32 or Float16, of colours and the like; what loses its meaning in half (depth, motion, ...) is borrowed in float
template <class Format = Float32> struct Borrowed {
    using Exact = Borrowed<Float32>;
    static constexpr bool owns_memory = false;
    static constexpr auto name = "borrowed";
    using format = Format;

    template <int N> struct Image {
        using Element = typename Format::Element;
        static constexpr int components = N;

        Element const* data = nullptr; ///< component 0 of pixel (0, 0), the top-left one
        Extent extent;
        std::ptrdiff_t pixel_stride = N;     ///< to the pixel on the right, in elements; negative: the host's rows run right to left
        std::ptrdiff_t row_stride = 0;       ///< to the pixel below, in elements; negative: the host's rows run bottom-up
        std::ptrdiff_t component_stride = 1; ///< to the next component, in elements

        Image() = default;
        explicit Image(Extent size) : extent(size) {}
        Image(Element const* data_, Extent size, std::ptrdiff_t pixel, std::ptrdiff_t row, std::ptrdiff_t component = 1)
            : data(data_), extent(size), pixel_stride(pixel), row_stride(row), component_stride(component) {}

        [[nodiscard]] Extent size() const { return extent; }
        [[nodiscard]] std::size_t bytes() const { return 0; }
        [[nodiscard]] auto view() const { return View{data, extent, pixel_stride, row_stride, component_stride}; }

        struct View {
            static constexpr int components = N;
            Element const* data;
            Extent size;
            std::ptrdiff_t pixel_stride, row_stride, component_stride;

            QUELL_KERNEL float get(int c, int x, int y) const { return Format::get(at(c, x, y)); }
            QUELL_KERNEL void set(int, int, int, float) const {} // a host's input is never written
            template <class Real> QUELL_KERNEL Value<N, Real> load(int x, int y) const {
                bool const side_by_side = pixel_stride == 1 && x >= 0 && x + width_of<Real> <= size.width;
                return make_value<N, Real>(
                    [&](auto c) QUELL_INLINED { return side_by_side ? Format::template load<Real>(at(c, x, y)) : apart<Real>(c, x, y); });
            }

        private:
            QUELL_KERNEL Element const* at(int c, int x, int y) const {
                return data + c * component_stride + y * row_stride + x * pixel_stride;
            }
            template <class Real> QUELL_KERNEL Real apart(int c, int x, int y) const {
                return detail::generate<Real>([&](int i) { return get(c, detail::clamp_to(x + i, size.width - 1), y); });
            }
        };
    };
};

} // namespace quell
