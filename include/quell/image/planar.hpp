#pragma once

#include <quell/image/padded_image.hpp>

#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A view of a planar image. Each component is a plane of its own, which may lie anywhere: a history puts images together from planes that
/// others don't need any more.
template <class Format, int N, class MemoryT> struct PlanarView {
    using Element = typename Format::Element;
    using Memory = MemoryT;                                          ///< where images lie
    using Squares = PlanarView<typename Format::Squares, N, Memory>; ///< a view of the same memory as variances
    using Plane = PaddedImage<PlanarView<Format, 1, Memory>>;        ///< an image of one component
    static constexpr int components = N, pixel_step = 1;

    Element* planes[std::size_t{N}] = {}; ///< pixel (0, 0) of each component
    Extent size;

    /// An image in one piece: a plane of padded rows after the other, with padding before each.
    static PlanarView of(Element* memory, Extent size) {
        PlanarView view{{}, size};
        for (int c = 0; c < N; ++c) view.planes[c] = memory + padding + c * plane_elements(size);
        return view;
    }
    /// An image of planes.
    static PlanarView of(std::array<std::shared_ptr<Plane>, std::size_t{N}> const& each) {
        std::array<Plane const*, std::size_t{N}> planes;
        for (std::size_t c = 0; c < each.size(); ++c) planes[c] = each[c].get();
        return of(planes);
    }
    /// The same without owners.
    static PlanarView of(std::array<Plane const*, std::size_t{N}> const& each) {
        PlanarView view{{}, each[0]->size()};
        for (std::size_t c = 0; c < each.size(); ++c) view.planes[c] = each[c]->view().planes[0];
        return view;
    }
    [[nodiscard]] Squares squares() const {
        Squares view{{}, size};
        std::copy_n(planes, N, view.planes);
        return view;
    }

    /// Distance from a pixel to the one below, in elements.
    QUELL_KERNEL static std::ptrdiff_t row_stride(Extent size) { return padded_width(size); }
    QUELL_KERNEL std::ptrdiff_t row_stride() const { return row_stride(size); }
    /// Elements in memory, with all padding.
    static std::ptrdiff_t elements(Extent size) { return plane_elements(size) * N + padding; }

    QUELL_KERNEL float get(int c, int x, int y) const { return Format::get(at(c, x, y)); }
    QUELL_KERNEL Value<N, float> const get(int x, int y) const { return load<float>(x, y); }
    QUELL_KERNEL void set(int c, int x, int y, float a) const { Format::set(at(c, x, y), a); }

    template <class Real> QUELL_KERNEL Value<N, Real> load(int x, int y) const {
        return make_value<N, Real>([&](auto c) QUELL_INLINED { return load_component<Real>(c, x, y); });
    }
    template <class Real> QUELL_KERNEL Real load_component(int c, int x, int y) const { return Format::template load<Real>(at(c, x, y)); }
    template <class Real> QUELL_KERNEL Value<N, Real> gather(Index<Real> x, Index<Real> y) const {
        if constexpr (on_device) return load<Real>(x, y);
        auto const offset = y * Index<Real>(static_cast<std::int32_t>(row_stride())) + x;
        return make_value<N, Real>([&](auto c) QUELL_INLINED { return Format::template gather<Real>(planes[c], offset); });
    }
    template <class Real> QUELL_KERNEL void store(int x, int y, Value<N, Real> const& value) const {
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED { (Format::store(at(c, x, y), component<c>(value)), ...); }
        (std::make_integer_sequence<int, N>{});
    }

private:
    static std::ptrdiff_t plane_elements(Extent size) { return row_stride(size) * size.height + padding; }
    QUELL_KERNEL Element* at(int c, int x, int y) const {
        if constexpr (on_device)
            return by_offset(planes[c], x, y);
        else
            return planes[c] + (y * row_stride() + x);
    }
    /// The same by an offset of 32 bits, in bytes, that is not negative: a device has one for all planes in a register, and adds it to each
    /// plane's address while loading.
    template <class E> QUELL_KERNEL E* by_offset(E* plane, int x, int y) const {
        auto const place = static_cast<unsigned>(y * static_cast<int>(padded_width(size)) + x + padding);
        return reinterpret_cast<E*>(reinterpret_cast<char*>(plane) + place * static_cast<unsigned>(sizeof(E))) - padding;
    }
};
} // namespace detail

/// Image storage of one plane per component. The fastest on a CPU: a pack of pixels is one load per component.
/// @tparam Format  Float32 or Float16; channels with `full_precision` use Float32 anyway
/// @tparam MemoryT where images lie: HostMemory, ManagedMemory, or the host's own
template <class Format = Float32, class MemoryT = HostMemory> struct Planar {
    static_assert(ComponentFormat<Format>,
                  "Planar<Format>: `Format` must be Float32, Float16 or another format, see quell/image/format.hpp");
    static_assert(ImageMemory<MemoryT>, "Planar<Format, Memory>: `Memory` must have allocate(bytes) and release(memory), see "
                                        "quell/image/memory.hpp");
    using Half = Planar<Float16, MemoryT>;  ///< storage of channels with `always_half`
    using Exact = Planar<Float32, MemoryT>; ///< storage of channels that need 32 bits
    static constexpr auto name = "planar";  ///< for messages
    using format = Format;                  ///< how a component is stored
    using Memory = MemoryT;                 ///< where images and a history's counts lie
    /// An image of N components.
    template <int N> using Image = detail::PaddedImage<detail::PlanarView<Format, N, Memory>>;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
