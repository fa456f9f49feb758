#pragma once

#include <quell/core/error.hpp>
#include <quell/image/format.hpp>
#include <quell/image/image_storage.hpp>
#include <quell/image/memory.hpp>

#include <algorithm>
#include <memory>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Padding of a row, in pixels; a power of two. Packs may start up to a pack before a row and end up to a pack after it, so inner loops
/// need no test. The padding after a row is also the padding before the next. It is zero and stays zero.
inline constexpr int padding = 16;
#if !defined(__CUDACC__)
static_assert(width_of<Pack> <= padding, "quell: packs of more than 16 floats are wider than the rows' padding");
#endif

/// Distance from a pixel to the one below, in pixels. It follows from the size: a kernel that reads many images of one size computes each
/// address once (see Pixel::load).
QUELL_KERNEL std::ptrdiff_t padded_width(Extent size) {
    if constexpr (on_device) return ((size.width + padding - 1) & -padding) + padding; // in 32 bits
    // Rounds up by a bit mask. With a division, compilers would compute the address of each component anew.
    return ((static_cast<std::ptrdiff_t>(size.width) + padding - 1) & -padding) + padding;
}

/// Whether a T can be a pixel of so many components, all of which it has: GLM makes a vec3 of a vec4.
template <class T, int components>
inline constexpr bool is_value = std::is_convertible_v<T const&, Value<components, float>> &&
                                 (components_of<T> == 1 || components_of<T> == components);

/// An image with padded rows that owns zero-initialised memory of ViewT::Memory, aligned to 64 bytes. Packs gather by 32-bit offsets, which
/// limits the size. Copies have memory of their own.
/// @tparam ViewT PlanarView or InterleavedView
template <class ViewT> class PaddedImage {
    using Element = typename ViewT::Element;
    using Memory = typename ViewT::Memory;
    static constexpr bool on_host = reached_by_host<Memory>();
    struct Free {
        void operator()(Element* p) const { Memory::release(p); }
    };
    std::unique_ptr<Element[], Free> memory;
    Extent extent;

public:
    using View = ViewT;
    static constexpr int components = View::components;

    /// @throws Error where offsets within a component exceed 31 bits
    explicit PaddedImage(Extent size = {}) : extent(size) {
        if (size.height > 0 && View::row_stride(size) > most_offset / size.height)
            raise_error<Failure>("image size", to_string(size) + " pixels, " + std::to_string(View::pixel_step) + " floats apart",
                                 View::pixel_step > 1 ? "use Planar storage or smaller images" : "use smaller images");
        allocate();
        if constexpr (on_host)
            std::uninitialized_value_construct_n(memory.get(), elements());
        else
            Memory::clear(memory.get(), bytes());
    }
    PaddedImage(PaddedImage&&) noexcept = default;
    PaddedImage& operator=(PaddedImage&&) noexcept = default;
    PaddedImage(PaddedImage const& other) : extent(other.extent) {
        if (!other.memory) return; // moved from
        allocate();
        if constexpr (on_host)
            std::uninitialized_copy_n(other.memory.get(), elements(), memory.get());
        else
            Memory::copy(memory.get(), other.memory.get(), bytes());
    }
    /// Allocates nothing where the two are of one size.
    PaddedImage& operator=(PaddedImage const& other) {
        if (!memory || !other.memory || !(extent == other.extent)) return *this = PaddedImage(other);
        if constexpr (on_host)
            std::copy_n(other.memory.get(), elements(), memory.get());
        else
            Memory::copy(memory.get(), other.memory.get(), bytes());
        return *this;
    }
    ~PaddedImage() = default;

    [[nodiscard]] View view() const { return View::of(memory.get(), extent); }
    [[nodiscard]] Extent size() const { return extent; }
    [[nodiscard]] std::size_t bytes() const { return elements() * sizeof(Element); }

    /// Const: an assignment to what it returns would do nothing.
    [[nodiscard]] Value<components, float> const get(int x, int y) const {
        require_host();
        return view().get(x, y);
    }
    [[nodiscard]] float get(int c, int x, int y) const {
        require_host();
        return view().get(c, x, y);
    }
    void set(int x, int y, Value<components, float> const& value) {
        require_host();
        view().template store<float>(x, y, value);
    }

    // Calls that would get many lines from compilers, or lose a component in silence.
    template <class T>
        requires(!is_value<T, components>)
    void set(int, int, T const&) {
        static_assert(sizeof(T) == 0,
                      "image.set(x, y, value): `value` must have as many components as the channel: a float, a glm vector, or "
                      "braces: set(x, y, {r, g, b})");
    }
    template <std::size_t count>
        requires(count != components)
    void set(int, int, float const (&)[count]) {
        static_assert(count == 0, "image.set(x, y, {...}): there must be as many numbers in the braces as the channel has components");
    }
    template <class... Numbers>
        requires(sizeof...(Numbers) > 1)
    void set(int, int, Numbers const&...) {
        static_assert(sizeof...(Numbers) == 0,
                      "image.set(x, y, value): put the components in braces, set(x, y, {r, g, b}); one alone is set by "
                      "image.view().set(component, x, y, number)");
    }

private:
#if defined(__CUDACC__) // a device adds offsets of 32 bits, in bytes
    static constexpr std::int32_t most_offset = std::numeric_limits<std::int32_t>::max() / 4;
#else
    static constexpr std::int32_t most_offset = std::numeric_limits<std::int32_t>::max();
#endif
    // The members that call it are compiled only where they are used.
    static void require_host() {
        static_assert(on_host, "image.get() and image.set(): the image lies in the device's memory: use upload() and download() of "
                               "quell/execute/device.cuh");
    }
    void allocate() { memory.reset(static_cast<Element*>(Memory::allocate(bytes()))); }
    [[nodiscard]] std::size_t elements() const { return static_cast<std::size_t>(View::elements(extent)); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
