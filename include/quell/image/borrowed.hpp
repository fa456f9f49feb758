#pragma once

#include <quell/core/error.hpp>
#include <quell/image/format.hpp>
#include <quell/image/interleaved.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Image storage that reads the host's own memory, without a copy. For each channel the host sets a pointer, the size and the strides
/// before the frame runs.
///
///     Frame frame{size, pipeline, Borrowed<>{}};
///     frame[depth] = {pointer, size, 1, 1920}; // from a pixel to the next, from a row to the next
///
/// The pointer is that of the top left pixel, wherever that lies in memory. For RGBA with the bottom row first:
///
///     frame[radiance] = {data + (height - 1) * 4 * width, size, 4, -4 * width};
///
/// The memory must outlive the run. With `pixel_stride` 1, loads are as fast as from Planar.
/// @tparam Format  Float32 or Float16; channels with `full_precision` (depth, motion, ...) are read as Float32 anyway
/// @tparam MemoryT where the host's images lie. quell repairs copies of guides there: HostMemory, for the executor Cuda DeviceMemory
template <class Format = Float32, class MemoryT = HostMemory> struct Borrowed {
    static_assert(ComponentFormat<Format>,
                  "Borrowed<Format>: `Format` must be Float32, Float16 or another format, see quell/image/format.hpp");
    using Exact = Borrowed<Float32, MemoryT>;  ///< storage of channels that need 32 bits
    using Memory = MemoryT;                    ///< where images lie
    using Copy = Interleaved<Format, Memory>;  ///< where quell keeps a guide that it has to repair
    static constexpr bool owns_memory = false; ///< history cannot use it
    static constexpr auto name = "borrowed";   ///< for messages
    using format = Format;                     ///< how a component is stored

    /// An image of N components in the host's memory.
    template <int N> struct Image {
        using Element = typename Format::Element; ///< what memory holds
        static constexpr int components = N;      ///< per pixel

        Element const* data = nullptr;       ///< component 0 of the top left pixel
        Extent extent;                       ///< pixels
        std::ptrdiff_t pixel_stride = N;     ///< to the pixel on the right, in elements; negative for rows from right to left
        std::ptrdiff_t row_stride = 0;       ///< to the pixel below, in elements; negative for bottom-up images
        std::ptrdiff_t component_stride = 1; ///< to the next component, in elements

        Image() = default;                            ///< no memory yet
        explicit Image(Extent size) : extent(size) {} ///< of a size, without memory yet
        /// All members. The strides are in elements.
        Image(Element const* data_, Extent size, std::ptrdiff_t pixel, std::ptrdiff_t row, std::ptrdiff_t component = 1)
            : data(data_), extent(size), pixel_stride(pixel), row_stride(row), component_stride(component) {}

        /// A pixel.
        [[nodiscard]] Value<N, float> const get(int x, int y) const { return view().get(x, y); }
        /// A component of a pixel.
        [[nodiscard]] float get(int c, int x, int y) const { return view().get(c, x, y); }
        /// @cond
        template <class... Args> void set(Args const&...) const {
            static_assert(sizeof...(Args) < 0, "image.set(x, y, value): a Borrowed image is read only; write to the host's own memory");
        }
        /// @endcond
        [[nodiscard]] Extent size() const { return extent; }  ///< pixels
        [[nodiscard]] std::size_t bytes() const { return 0; } ///< 0: it owns no memory
        /// The view that kernels use.
        [[nodiscard]] auto view() const { return View{data, extent, pixel_stride, row_stride, component_stride}; }

        /// An image of `Copy` that stands in for the host's.
        [[nodiscard]] static Image of_copy(auto const& copy) {
            auto const view = View::of_copy(copy);
            return {view.data, view.size, view.pixel_stride, view.row_stride, view.component_stride};
        }

        /// An ImageView. Writes do nothing.
        struct View {
            /// @cond
            static constexpr int components = N;
            Element const* data;
            Extent size;
            std::ptrdiff_t pixel_stride, row_stride, component_stride;

            static View of_copy(auto const& copy) {
                if constexpr (N == 1)
                    return {copy.planes[0], copy.size, 1, copy.row_stride(), 1};
                else
                    return {copy.data, copy.size, N, copy.row_stride(), 1};
            }
            QUELL_KERNEL float get(int c, int x, int y) const { return Format::get(at(c, x, y)); }
            QUELL_KERNEL Value<N, float> const get(int x, int y) const { return load<float>(x, y); }
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
                return generate<Real>([&](int i) { return get(c, detail::clamp_to(x + i, size.width - 1), y); });
            }
            /// @endcond
        };
    };
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
