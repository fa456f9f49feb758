#pragma once

#include <denoise/layout_changes.hpp>

#include <quell/core/value.hpp>
#include <quell/metrics/picture.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace quell::examples {

/// Index of a pixel, row by row from the top-left.
[[nodiscard]] inline std::size_t index_of(Extent size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
}

/// Linear light or colours of all pixels: planes of red, green and blue, each row by row from the top-left, wherever they lie.
/// @tparam Number float, or float const where they are only read
template <class Number> struct ColourPlanes {
    static constexpr int components = 3;
    Extent size{};                   ///< in pixels
    std::array<Number*, 3> planes{}; ///< null: there are none

    [[nodiscard]] bool empty() const { return planes[0] == nullptr; }
    [[nodiscard]] std::size_t pixels() const { return empty() ? 0 : static_cast<std::size_t>(size.pixels()); }
    [[nodiscard]] glm::vec3 operator[](std::size_t i) const { return {planes[0][i], planes[1][i], planes[2][i]}; }
    [[nodiscard]] Number& at(int c, std::size_t i) const { return planes[static_cast<std::size_t>(c)][i]; }
    // As an image that pipelines read or write.
    [[nodiscard]] float get(int c, int x, int y) const { return at(c, index_of(size, x, y)); }
    void set(int c, int x, int y, float value) const {
        if constexpr (!std::is_const_v<Number>) at(c, index_of(size, x, y)) = value;
    }
};
using LinearView = ColourPlanes<float const>;

/// Linear light or colours of all pixels, and where they lie.
struct LinearPicture {
    Extent size{};               ///< in pixels
    std::vector<float> values{}; ///< one plane after the other

    /// A pixel that can be changed.
    struct Pixel {
        float &r, &g, &b;

        Pixel(float& red, float& green, float& blue) : r(red), g(green), b(blue) {}
        Pixel(Pixel const&) = default;
        operator glm::vec3() const { return {r, g, b}; } // not explicit: it is a colour
        Pixel const& operator=(glm::vec3 const& to) const { return r = to.r, g = to.g, b = to.b, *this; }
        Pixel const& operator=(Pixel const& to) const { return *this = glm::vec3(to); }
        void operator+=(glm::vec3 const& more) const { *this = glm::vec3(*this) + more; }
        void operator-=(glm::vec3 const& less) const { *this = glm::vec3(*this) - less; }
        void operator*=(glm::vec3 const& by) const { *this = glm::vec3(*this) * by; }
    };

    LinearPicture() = default;
    explicit LinearPicture(Extent s, float everywhere = 0.f) : size(s), values(3 * static_cast<std::size_t>(s.pixels()), everywhere) {}
    /// A copy.
    explicit LinearPicture(LinearView const& of) : LinearPicture(of.size) {
        LayoutChanges::add();
        for (std::size_t c = 0; c < 3; ++c)
            std::copy_n(of.planes[c], of.pixels(), values.begin() + static_cast<std::ptrdiff_t>(c * of.pixels()));
    }

    [[nodiscard]] bool empty() const { return values.empty(); }
    [[nodiscard]] std::size_t pixels() const { return empty() ? 0 : static_cast<std::size_t>(size.pixels()); }
    [[nodiscard]] Pixel operator[](std::size_t i) { return {at(0, i), at(1, i), at(2, i)}; }
    [[nodiscard]] glm::vec3 operator[](std::size_t i) const { return {at(0, i), at(1, i), at(2, i)}; }
    [[nodiscard]] float& at(int c, std::size_t i) { return values[static_cast<std::size_t>(c * size.pixels()) + i]; }
    [[nodiscard]] float at(int c, std::size_t i) const { return values[static_cast<std::size_t>(c * size.pixels()) + i]; }
    [[nodiscard]] ColourPlanes<float> target() { return {size, {values.data(), values.data() + pixels(), values.data() + 2 * pixels()}}; }
    [[nodiscard]] LinearView view() const {
        if (empty()) return {size, {}};
        return {size, {values.data(), values.data() + pixels(), values.data() + 2 * pixels()}};
    }
    operator LinearView() const { return view(); } // not explicit: whoever reads a picture takes a view
    /// For metrics.
    operator metrics::Picture() const {
        LayoutChanges::add();
        return metrics::picture_of(view());
    }
};

/// A picture that is read where it lies, or that had to be computed.
struct ReadPicture : LinearView {
    std::shared_ptr<LinearPicture> made{}; ///< null: it lies in the planes of an image, which has to outlive it

    ReadPicture() = default;
    explicit ReadPicture(LinearView const& where) : LinearView(where) {}
    explicit ReadPicture(LinearPicture picture) : made(std::make_shared<LinearPicture>(std::move(picture))) {
        static_cast<LinearView&>(*this) = *made;
    }
    /// A picture of that size to be computed from this one, pixel by pixel: where this was computed, in its place.
    [[nodiscard]] LinearPicture in_place() const { return made ? std::move(*made) : LinearPicture(size); }
};

} // namespace quell::examples
