#pragma once

#include "for_each_strip.hpp"
#include "take_rows.hpp"

#include <quell/image/planar.hpp>

#include <new>
#include <optional>

namespace quell_library {

/// Memory of the caller's, or operator new. Each block says in front of it whose it is, so that it goes back there.
struct CallersMemory {
    /// Whose memory images get that are made from now on in this thread.
    static Memory& current() {
        static thread_local Memory memory;
        return memory;
    }
    static void* allocate(std::size_t bytes) {
        auto const& memory = current();
        auto* const block = memory.allocate != nullptr ? memory.allocate(memory.user, bytes + head, head)
                                                       : ::operator new[](bytes + head, std::align_val_t{head}, std::nothrow);
        if (block == nullptr) throw std::bad_alloc();
        new (block) Memory(memory);
        return static_cast<std::byte*>(block) + head;
    }
    static void release(void* pixels) {
        if (pixels == nullptr) return;
        auto* const block = static_cast<std::byte*>(pixels) - head;
        auto const memory = *std::launder(reinterpret_cast<Memory*>(block));
        if (memory.release != nullptr)
            memory.release(memory.user, block);
        else
            ::operator delete[](block, std::align_val_t{head});
    }

private:
    static constexpr std::size_t head = 64;
    static_assert(sizeof(Memory) <= head);
};
using OwnImages = quell::Planar<quell::Float32, CallersMemory>;

/// Image storage of a frame, in memory of the caller's. Kernels read planes of floats in padded rows: they read images that the caller has
/// so where they lie. Of others, a pass takes some rows at a time (strips.hpp), or they are copied as a whole.
struct HostImages {
    using Exact = HostImages;
    using Copy = OwnImages;
    static constexpr bool owns_memory = false;
    static constexpr auto name = "host";

    template <int N> class Image {
        using Own = typename OwnImages::template Image<N>;
        quell::Extent extent;
        quell_library::Image given{};
        std::optional<Own> own;

    public:
        struct View : Own::View {
            /// What rows are taken of before they are read; null for an image that is there as a whole.
            quell_library::Image const* in_strips = nullptr;
            static View of_copy(typename Own::View const& copy) { return {copy}; }
        };
        static constexpr int components = N;

        Image() = default;
        explicit Image(quell::Extent size) : extent(size) {}
        /// An image of quell's own that stands in for one of the caller's.
        static Image of_copy(typename Own::View const& copy) {
            Image made(copy.size);
            made.pixels = {copy};
            return made;
        }

        /// From now on it is this one, which may stay without memory. Returns whether passes must take its rows.
        bool refer_to(quell_library::Image const& image) {
            given = image, pixels = {}, pixels.size = extent;
            if (given.data == nullptr) return false;
            if (!given.is_padded || is_scaled() || given.samples.columns > 0) return true;
            for (int c = 0; c < N; ++c) pixels.planes[c] = reinterpret_cast<float*>(given.data + c * given.component_stride);
            return false;
        }
        /// Copies it, so that it is there as a whole.
        void take_whole(Parallel const& parallel) {
            make();
            auto const row = pixels.row_stride();
            for_each_strip(parallel, extent.height, [&](int y0, int y1) { take_rows(given, N, pixels.planes, row, extent.width, y0, y1); });
        }
        /// From now on it is an image of its own, to be written.
        View make() {
            if (!own || !(own->size() == extent)) own.emplace(extent);
            return pixels = {own->view()};
        }

        [[nodiscard]] View view() const {
            auto made = pixels;
            if (made.planes[0] == nullptr && given.data != nullptr) made.in_strips = &given;
            return made;
        }
        [[nodiscard]] bool has_memory() const { return pixels.planes[0] != nullptr || given.data != nullptr; }
        [[nodiscard]] quell::Extent size() const { return extent; }
        [[nodiscard]] std::size_t bytes() const { return own ? own->bytes() : 0; }
        [[nodiscard]] auto get(int x, int y) const { return pixels.template load<float>(x, y); }
        template <class V> void set(int, int, V const&) const {} // the caller's input is never written

    private:
        View pixels{};

        [[nodiscard]] bool is_scaled() const {
            return given.scale[0] != 1.f || given.scale[1] != 1.f || given.offset[0] != 0.f || given.offset[1] != 0.f;
        }
    };
};

/// The view through which a denoiser writes what comes out.
template <int N> struct HostTarget {
    static constexpr int components = N;
    std::byte* data = nullptr;
    quell::Extent size{};
    std::ptrdiff_t component_stride = 0, pixel_stride = 0, row_stride = 0;
    bool is_half = false;

    QUELL_KERNEL float get(int c, int x, int y) const {
        auto const* const at = address(c, x, y);
        return is_half ? quell::Float16::get(reinterpret_cast<std::uint16_t const*>(at)) : *reinterpret_cast<float const*>(at);
    }
    QUELL_KERNEL void set(int c, int x, int y, float value) const {
        auto* const at = address(c, x, y);
        if (is_half)
            quell::Float16::set(reinterpret_cast<std::uint16_t*>(at), value);
        else
            *reinterpret_cast<float*>(at) = value;
    }
    template <class Real> QUELL_KERNEL void store(int x, int y, quell::Value<N, Real> const& value) const {
        if (!is_half && pixel_stride == sizeof(float))
            each([&](auto c)
                     QUELL_INLINED { quell::Float32::store(reinterpret_cast<float*>(address(c, x, y)), quell::component<c>(value)); });
        else
            store_any<Real>(*this, x, y, value);
    }

private:
    QUELL_KERNEL std::byte* address(int c, int x, int y) const { return data + (c * component_stride + x * pixel_stride + y * row_stride); }
    template <class F> QUELL_KERNEL static void each(F const& function) {
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED { (function(std::integral_constant<int, c>{}), ...); }
        (std::make_integer_sequence<int, N>{});
    }
    /// Whatever the layout. Not inlined: it would make each kernel longer.
    template <class Real> QUELL_OUTLINED static void store_any(HostTarget const& to, int x, int y, quell::Value<N, Real> const& value) {
        constexpr int width = quell::width_of<Real>;
        alignas(64) float apart[std::size_t{N}][std::size_t{width}];
        each([&](auto c) {
            if constexpr (width > 1)
                quell::component<c>(value).store_aligned(apart[c]);
            else
                apart[c][0] = quell::component<c>(value);
        });
        if (!to.is_half && to.component_stride == sizeof(float) && to.pixel_stride == N * to.component_stride) {
            auto* const pixels = reinterpret_cast<float*>(to.address(0, x, y));
            for (int i = 0; i < width; ++i)
                for (int c = 0; c < N; ++c) pixels[i * N + c] = apart[c][i];
        } else
            for (int i = 0; i < width; ++i)
                for (int c = 0; c < N; ++c) to.set(c, x + i, y, apart[c][i]);
    }
};

} // namespace quell_library
