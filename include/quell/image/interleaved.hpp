#pragma once

#include <quell/image/planar.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A view of an interleaved image.
template <class Format, int N, class MemoryT> struct InterleavedView {
    using Element = typename Format::Element;
    using Memory = MemoryT;                                               ///< where images lie
    using Squares = InterleavedView<typename Format::Squares, N, Memory>; ///< a view of the same memory as variances
    static constexpr int components = N, pixel_step = N;

    Element* data = nullptr; ///< component 0 of pixel (0, 0)
    Extent size;

    /// An image of padded rows, with padding before the first.
    static InterleavedView of(Element* memory, Extent size) { return {memory + padding * N, size}; }
    [[nodiscard]] Squares squares() const { return {data, size}; }

    /// Distance from a pixel to the one below, in elements.
    QUELL_KERNEL static std::ptrdiff_t row_stride(Extent size) { return padded_width(size) * N; }
    QUELL_KERNEL std::ptrdiff_t row_stride() const { return row_stride(size); }
    /// Elements in memory, with all padding.
    static std::ptrdiff_t elements(Extent size) { return row_stride(size) * size.height + 2 * padding * N; }

    QUELL_KERNEL float get(int c, int x, int y) const { return Format::get(at(c, x, y)); }
    QUELL_KERNEL Value<N, float> const get(int x, int y) const { return load<float>(x, y); }
    QUELL_KERNEL void set(int c, int x, int y, float a) const { Format::set(at(c, x, y), a); }

    template <class Real> QUELL_KERNEL Value<N, Real> load(int x, int y) const {
        if constexpr (width_of<Real> == 1)
            return make_value<N, Real>([&](auto c) QUELL_INLINED { return get(c, x, y); });
        else {
            float const* run = nullptr;
            alignas(64) float converted[N * width_of<Real>];
            if constexpr (std::is_same_v<Element, float>)
                run = at(0, x, y);
            else {
                for (int k = 0; k < N; ++k)
                    Format::template load<Real>(at(0, x, y) + k * width_of<Real>).store_aligned(converted + k * width_of<Real>);
                run = converted;
            }
            return make_value<N, Real>([&](auto c)
                                           QUELL_INLINED { return generate<Real>([&](int i) QUELL_INLINED { return run[c + i * N]; }); });
        }
    }
    template <class Real> QUELL_KERNEL Value<N, Real> gather(Index<Real> x, Index<Real> y) const {
        auto const offset = y * Index<Real>(static_cast<std::int32_t>(row_stride())) + x * Index<Real>(N);
        return make_value<N, Real>([&](auto c) QUELL_INLINED { return Format::template gather<Real>(data + c, offset); });
    }
    template <class Real> QUELL_KERNEL void store(int x, int y, Value<N, Real> const& value) const {
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED {
            if constexpr (width_of<Real> == 1)
                (set(c, x, y, component<c>(value)), ...);
            else {
                constexpr int width = width_of<Real>;
                alignas(64) float apart[std::size_t{N}][std::size_t{width}], run[std::size_t{N * width}];
                (component<c>(value).store_aligned(apart[c]), ...);
                for (int i = 0; i < width; ++i) ((run[i * N + c] = apart[c][i]), ...);
                (Format::store(at(0, x, y) + c * width, Real::load_aligned(run + c * width)), ...);
            }
        }
        (std::make_integer_sequence<int, N>{});
    }

private:
    QUELL_KERNEL Element* at(int c, int x, int y) const { return data + (c + y * row_stride() + x * N); }
};
} // namespace detail

/// Image storage with a pixel's components side by side (RGBRGB...), as in most hosts. Slower than Planar on a CPU, since packs are
/// gathered.
/// @tparam Format  Float32 or Float16; channels with `full_precision` use Float32 anyway
/// @tparam MemoryT where images lie: HostMemory, or another as of Planar
template <class Format = Float32, class MemoryT = HostMemory> struct Interleaved {
    static_assert(ComponentFormat<Format>,
                  "Interleaved<Format>: `Format` must be Float32, Float16 or another format, see quell/image/format.hpp");
    static_assert(ImageMemory<MemoryT>, "Interleaved<Format, Memory>: `Memory` must have allocate(bytes) and release(memory), see "
                                        "quell/image/memory.hpp");
    using Half = Interleaved<Float16, MemoryT>;  ///< storage of channels with `always_half`
    using Exact = Interleaved<Float32, MemoryT>; ///< storage of channels that need 32 bits
    static constexpr auto name = "interleaved";  ///< for messages
    using format = Format;                       ///< how a component is stored
    using Memory = MemoryT;                      ///< where images and a history's counts lie
    /// An image of N components. Of one component, it is a plane.
    template <int N>
    using Image =
        detail::PaddedImage<std::conditional_t<N == 1, detail::PlanarView<Format, 1, Memory>, detail::InterleavedView<Format, N, Memory>>>;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
