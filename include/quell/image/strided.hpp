#pragma once

#include <quell/core/error.hpp>
#include <quell/image/format.hpp>
#include <quell/image/image_storage.hpp>

#include <algorithm>
#include <memory>
#include <new>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Padding of a row, in pixels; a power of two. Packs may start up to a pack before a row and end up to a pack after it, so inner loops
/// need no test. The padding after a row is also the padding before the next. It is zero and stays zero.
inline constexpr int padding = 16;
#if !defined(__CUDACC__)
static_assert(width_of<Pack> <= padding, "quell: packs of more than 16 floats are wider than the rows' padding");
#endif

/// A view of a planar (`pixel_step` 1) or interleaved (`pixel_step` N) image. The strides follow from the size: a kernel that reads many
/// images of one size computes each address once (see Pixel::load).
template <class Format, int N, int pixel_step> struct StridedView {
    using Element = typename Format::Element;
    using Squares = StridedView<typename Format::Squares, N, pixel_step>; ///< a view of the same memory as variances
    static constexpr int components = N;

    Element* data = nullptr; ///< component 0 of pixel (0, 0)
    Extent size;

    /// Distance from a pixel to the one below, in elements.
    QUELL_KERNEL std::ptrdiff_t row_stride() const {
        // Rounds up by a bit mask. With a division, compilers would compute the address of each component anew.
        return (((static_cast<std::ptrdiff_t>(size.width) + padding - 1) & -padding) + padding) * pixel_step;
    }
    /// Distance from a component to the next, in elements.
    QUELL_KERNEL std::ptrdiff_t component_stride() const { return pixel_step > 1 ? 1 : row_stride() * size.height + padding; }
    /// Elements in memory, with all padding.
    QUELL_KERNEL std::ptrdiff_t elements() const {
        return (pixel_step > 1 ? row_stride() * size.height + padding * N : component_stride() * N) + padding * pixel_step;
    }

    QUELL_KERNEL float get(int c, int x, int y) const { return Format::get(at(c, x, y)); }
    QUELL_KERNEL void set(int c, int x, int y, float a) const { Format::set(at(c, x, y), a); }

    template <class Real> QUELL_KERNEL Value<N, Real> load(int x, int y) const {
        if constexpr (pixel_step == 1 || width_of<Real> == 1)
            return make_value<N, Real>([&](auto c) QUELL_INLINED { return Format::template load<Real>(at(c, x, y)); });
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
            return make_value<N, Real>(
                [&](auto c) QUELL_INLINED { return generate<Real>([&](int i) QUELL_INLINED { return run[c + i * pixel_step]; }); });
        }
    }
    template <class Real>
        requires(pixel_step == 1)
    QUELL_KERNEL Real load_component(int c, int x, int y)
    const { return Format::template load<Real>(at(c, x, y)); }
    template <class Real> QUELL_KERNEL Value<N, Real> gather(Index<Real> x, Index<Real> y) const {
        auto const offset = y * Index<Real>(static_cast<std::int32_t>(row_stride())) + x * Index<Real>(pixel_step);
        return make_value<N, Real>([&](auto c)
                                       QUELL_INLINED { return Format::template gather<Real>(data + c * component_stride(), offset); });
    }
    template <class Real> QUELL_KERNEL void store(int x, int y, Value<N, Real> const& value) const {
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED {
            if constexpr (pixel_step == 1 || width_of<Real> == 1)
                (Format::store(at(c, x, y), component<c>(value)), ...);
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
    QUELL_KERNEL Element* at(int c, int x, int y) const { return data + (c * component_stride() + y * row_stride() + x * pixel_step); }
};

/// An image that owns zero-initialised memory, aligned to 64 bytes. Packs gather by 32-bit offsets, which limits the size. Copies have
/// memory of their own.
template <class Format, int N, bool interleaved> class StridedImage {
    using Element = typename Format::Element;
    struct Free {
        void operator()(Element* p) const { ::operator delete[](p, std::align_val_t{64}); }
    };
    std::unique_ptr<Element[], Free> memory;
    Extent extent;

public:
    static constexpr int components = N;
    static constexpr int step = interleaved ? N : 1;
    using View = StridedView<Format, N, step>;

    /// @throws Error where offsets within a component exceed 31 bits
    explicit StridedImage(Extent size = {}) : extent(size) {
        if (size.height > 0 && View{nullptr, size}.row_stride() > std::numeric_limits<std::int32_t>::max() / size.height)
            raise_error("image size", to_string(size) + " pixels, " + std::to_string(step) + " floats apart",
                        step > 1 ? "use Planar storage or smaller images" : "use smaller images");
        allocate();
        std::uninitialized_value_construct_n(memory.get(), elements());
    }
    StridedImage(StridedImage&&) noexcept = default;
    StridedImage& operator=(StridedImage&&) noexcept = default;
    StridedImage(StridedImage const& other) : extent(other.extent) {
        if (!other.memory) return; // moved from
        allocate();
        std::uninitialized_copy_n(other.memory.get(), elements(), memory.get());
    }
    /// Allocates nothing where the two are of one size.
    StridedImage& operator=(StridedImage const& other) {
        if (!memory || !other.memory || !(extent == other.extent)) return *this = StridedImage(other);
        std::copy_n(other.memory.get(), elements(), memory.get());
        return *this;
    }
    ~StridedImage() = default;

    [[nodiscard]] View view() const { return {memory.get() + padding * step, extent}; }
    [[nodiscard]] Extent size() const { return extent; }
    [[nodiscard]] std::size_t bytes() const { return elements() * sizeof(Element); }

    [[nodiscard]] Value<N, float> get(int x, int y) const { return view().template load<float>(x, y); }
    void set(int x, int y, Value<N, float> const& value) { view().template store<float>(x, y, value); }

private:
    void allocate() { memory.reset(static_cast<Element*>(::operator new[](bytes(), std::align_val_t{64}))); }
    [[nodiscard]] std::size_t elements() const { return static_cast<std::size_t>(View{nullptr, extent}.elements()); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
