#pragma once

#include <quell/resolve/light_unit.hpp>
#include <quell/resolve/window_sums.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Colours in planes with padded rows.
/// @param colours a view of three components
/// @param unit of light, in which the planes have them: see light_unit()
inline Planes<3> in_planes(ImageView auto const& colours, float unit = 1.f) {
    Planes<3> planes(colours.size);
    auto const view = planes.view();
    float const per_unit = 1.f / unit;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < colours.size.height; ++y)
            for (int x = 0; x < colours.size.width; ++x) view.set(c, x, y, colours.get(c, x, y) * per_unit);
    return planes;
}

/// How bright a picture is, whatever its sign. It is in units of its light.
struct Brightness {
    Planes<1> of_pixels; ///< 0 where the picture is not finite
    float mean = 0.f;    ///< of all pixels

    template <Executor E> Brightness(E const& executor, PlanesView<3> picture) : of_pixels(picture.size) {
        auto const to = of_pixels.view();
        for_all_pixels(executor, picture.size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
            auto const light = luminance(load_pixels<Real>(picture, x, y));
            store_pixels<Real>(to, x, y, masked(is_finite(light), abs(light)), count);
        });
        double sum = 0.; // row by row, so that it is the same for any number of threads
        for (int y = 0; y < picture.size.height; ++y)
            for (int x = 0; x < picture.size.width; ++x) sum += static_cast<double>(to.get(0, x, y));
        mean = static_cast<float>(sum / static_cast<double>(picture.size.pixels()));
    }
    /// A part of the mean brightness, below which pixels are taken for dark; above 0 in a black picture too.
    [[nodiscard]] float dark(float part) const { return part * mean + 1e-6f; }
};

/// The light of a picture around each pixel, and a little of that of the whole picture.
template <Executor E, int most> Planes<1> light_around(E const& executor, WindowSums<most>& sums, Brightness const& brightness) {
    constexpr int radius = 2;
    auto const from = brightness.of_pixels.view();
    auto const size = from.size;
    Planes<1> light(size);
    float const dark = brightness.dark(.02f);
    sums.template around<1>(
        executor, radius, [=]<class Real>(AtOnce<Real>, int x, int y) { return std::array{load_pixels<Real>(from, x, y)}; },
        [=, to = light.view()]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
            store_pixels<Real>(to, x, y, around[0] / pixels_in_square<Real>(x, y, radius, size) + dark, count);
        });
    return light;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
