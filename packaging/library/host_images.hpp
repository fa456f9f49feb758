#pragma once

#include "preset_code.hpp"

#include <quell/image/format.hpp>
#include <quell/image/interleaved.hpp>

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

/// Image storage that reads the caller's memory: any strides, floats or halves.
struct HostImages {
    using Exact = HostImages;
    using Copy = quell::Interleaved<>;
    static constexpr bool owns_memory = false;
    static constexpr auto name = "host";

    template <int N> struct Image {
        static constexpr int components = N;
        quell_library::Image image;
        quell::Extent extent;

        Image() = default;
        explicit Image(quell::Extent size) : extent(size) {}

        struct View {
            static constexpr int components = N;
            std::byte const* data = nullptr;
            quell::Extent size{};
            std::ptrdiff_t component_stride = 0, pixel_stride = 0, row_stride = 0;
            bool is_half = false;

            /// Of a guide that was repaired.
            static View of_copy(auto const& copy) {
                std::ptrdiff_t constexpr element = sizeof(float);
                auto const* const first = [&] {
                    if constexpr (N == 1)
                        return copy.planes[0];
                    else
                        return copy.data;
                }();
                return {reinterpret_cast<std::byte const*>(first), copy.size, element, N * element, copy.row_stride() * element, false};
            }
            QUELL_KERNEL float get(int c, int x, int y) const {
                auto const* const at = address(c, x, y);
                return is_half ? quell::Float16::get(reinterpret_cast<std::uint16_t const*>(at)) : *reinterpret_cast<float const*>(at);
            }
            QUELL_KERNEL void set(int, int, int, float) const {} // the caller's input is never written
            template <class Real> QUELL_KERNEL quell::Value<N, Real> load(int x, int y) const {
                return quell::make_value<N, Real>([&](auto c) QUELL_INLINED { return load_component<Real>(c, x, y); });
            }
            template <class Real> QUELL_KERNEL Real load_component(int c, int x, int y) const {
                if (x >= 0 && x + quell::width_of<Real> <= size.width) {
                    auto const* const at = address(c, x, y);
                    if (!is_half && pixel_stride == sizeof(float))
                        return quell::Float32::template load<Real>(reinterpret_cast<float const*>(at));
                    if (is_half && pixel_stride == sizeof(std::uint16_t))
                        return quell::Float16::template load<Real>(reinterpret_cast<std::uint16_t const*>(at));
                }
                return quell::generate<Real>([&](int i)
                                                 QUELL_INLINED { return get(c, quell::detail::clamp_to(x + i, size.width - 1), y); });
            }

        private:
            QUELL_KERNEL std::byte const* address(int c, int x, int y) const {
                return data + (c * component_stride + x * pixel_stride + y * row_stride);
            }
        };
        [[nodiscard]] View view() const {
            return {image.data, extent, image.component_stride, image.pixel_stride, image.row_stride, image.is_half};
        }
        [[nodiscard]] quell::Extent size() const { return extent; }
        [[nodiscard]] static std::size_t bytes() { return 0; }
        [[nodiscard]] auto get(int x, int y) const { return view().template load<float>(x, y); }
        template <class V> void set(int, int, V const&) const {}
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
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED { (store_component(c, x, y, quell::component<c>(value)), ...); }
        (std::make_integer_sequence<int, N>{});
    }

private:
    QUELL_KERNEL std::byte* address(int c, int x, int y) const { return data + (c * component_stride + x * pixel_stride + y * row_stride); }
    template <class Real> QUELL_KERNEL void store_component(int c, int x, int y, Real const& value) const {
        if (!is_half && pixel_stride == sizeof(float))
            quell::Float32::store(reinterpret_cast<float*>(address(c, x, y)), value);
        else
            for (int i = 0; i < quell::width_of<Real>; ++i) set(c, x + i, y, quell::lane(value, i));
    }
};

} // namespace quell_library
