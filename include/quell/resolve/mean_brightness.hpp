#pragma once

#include <quell/core/value.hpp>
#include <quell/execute/executor.hpp>
#include <quell/image/image_storage.hpp>

#include <type_traits>

/// The mean luminance of a picture by two passes, so that it can stay on a device. Sums are those of rows, one after the other: they are
/// the same for any number of threads.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A pixel as a colour: one component stands for three that are the same, and alpha is left out.
QUELL_KERNEL vec3<float> colour_at(ImageView auto const& view, int x, int y) {
    constexpr int last = std::remove_cvref_t<decltype(view)>::components > 1 ? 1 : 0;
    return {view.get(0, x, y), view.get(last, x, y), view.get(2 * last, x, y)};
}

/// How bright the rows of a picture are: the sum of the luminance of each, whatever its sign.
template <class Picture> struct BrightnessOfRows {
    static constexpr auto name = "evidence, brightness";
    Picture picture;
    double* rows;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int, int y, int) const {
        double sum = 0.;
        for (int x = 0; x < picture.size.width; ++x)
            if (float const light = luminance(colour_at(picture, x, y)); is_finite(light)) sum += static_cast<double>(abs(light));
        rows[y] = sum;
    }
};
/// The first row's brightness becomes the mean of all pixels.
struct MeanBrightness {
    static constexpr auto name = "evidence, mean brightness";
    double* rows;
    Extent size;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int, int, int) const {
        double sum = 0.;
        for (int y = 0; y < size.height; ++y) sum += rows[y];
        rows[0] = sum / static_cast<double>(size.pixels());
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
