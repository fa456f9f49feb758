#pragma once

#include <quell/core/light.hpp>
#include <quell/resolve/light_unit.hpp>
#include <quell/resolve/window_sums.hpp>

#include <algorithm>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far samples may be from a picture of them: noise of few bright samples is skewed.
struct ResidualLimits {
    float most = 20.f;    ///< samples are at most so many times the picture's luminance
    float dark = 0.02f;   ///< part of the image's mean luminance that is added to that
    float spike = 3.f;    ///< a residual is at most so many times the root mean square around; what is more is spread there
    int noise_radius = 3; ///< of the squares in which that is taken, in pixels; at most 16
};

namespace detail {

/// Colours, row by row, in planes.
/// @param unit of light, in which the planes have them: see light_unit()
inline Planes<3> in_planes(Extent size, std::vector<glm::vec3> const& colours, float unit = 1.f) {
    Planes<3> planes(size);
    auto const view = planes.view();
    float const per_unit = 1.f / unit;
    auto from = colours.begin();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x, ++from)
            for (int c = 0; c < 3; ++c) view.set(c, x, y, (*from)[c] * per_unit);
    return planes;
}

/// The other way round.
inline void copy_out(PlanesView<3> planes, std::vector<glm::vec3>& colours, float unit = 1.f) {
    auto to = colours.begin();
    for (int y = 0; y < planes.size.height; ++y)
        for (int x = 0; x < planes.size.width; ++x, ++to)
            for (int c = 0; c < 3; ++c) (*to)[c] = planes.get(c, x, y) * unit;
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

/// Which half of a checkerboard pixels are of: 0 or 1.
template <class Real> QUELL_KERNEL Real checkerboard_half(int x, int y) {
    auto const sum = Real(static_cast<float>(x + y)) + lanes<Real>();
    return sum - 2.f * floor(sum * 0.5f);
}

/// Samples minus picture.
struct PictureResidual {
    Extent size;
    Planes<3> value;       ///< 0 where there is no sample
    Planes<1> mean_square; ///< of the pixels around, and of a hundredth of the picture's luminance; 0 where there is no sample

    template <Executor E>
    PictureResidual(E const& executor, WindowSums<4>& sums, ResidualLimits const& limits, PlanesView<3> samples, PlanesView<3> picture,
                    Brightness const& brightness)
        : size(picture.size), value(size), mean_square(size) {
        auto const to = value.view();
        auto const square = mean_square.view(), bright = brightness.of_pixels.view();
        float const dark = brightness.dark(limits.dark), times = limits.most;
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
            auto const sample = load_pixels<Real>(samples, x, y);
            auto const most = (load_pixels<Real>(bright, x, y) + dark) * times;
            auto const off = map([&](Real s, Real p) QUELL_INLINED { return min(s, most) - p; }, sample, load_pixels<Real>(picture, x, y));
            auto const is_sample = both(is_light(sample), all_finite(off));
            store_pixels<Real>(to, x, y, map([&](Real a) QUELL_INLINED { return masked(is_sample, a); }, off), count);
            store_pixels<Real>(square, x, y, masked(is_sample, Real(1.f)), count);
        });
        sums.around<2>(
            executor, limits.noise_radius,
            [=]<class Real>(AtOnce<Real>, int x, int y) {
                auto const off = load_pixels<Real>(to, x, y);
                return std::array{dot(off, off), load_pixels<Real>(square, x, y)};
            },
            [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
                auto const light = load_pixels<Real>(bright, x, y) + dark;
                auto const mean = around[0] / max(around[1], Real(1.f)) + light * light * 1e-4f;
                store_pixels<Real>(square, x, y, masked(load_pixels<Real>(square, x, y) > Real(0.f), mean), count);
            });
        spread_spikes(executor, limits);
    }

private:
    /// Noise of few bright samples is skewed. What a pixel has more than its surroundings is spread over pixels of its half of the
    /// checkerboard, so that the mean stays and the halves know nothing of each other.
    template <Executor E> void spread_spikes(E const& executor, ResidualLimits const& limits) {
        Planes<4> spikes(size); // what is too much, and which pixels have a sample
        auto const off = value.view();
        auto const square = mean_square.view();
        auto const spike = spikes.view();
        float const times = limits.spike * limits.spike;
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
            auto const whole = load_pixels<Real>(off, x, y);
            auto const mean = load_pixels<Real>(square, x, y), limit = mean * times, its = dot(whole, whole);
            auto const part = select(its > limit, sqrt(limit / max(its, Real(1e-37f))), Real(1.f));
            auto const kept = scale(whole, part);
            store_pixels<Real>(off, x, y, kept, count);
            store_pixels<Real>(spike, x, y, {whole.x - kept.x, whole.y - kept.y, whole.z - kept.z, masked(mean > Real(0.f), Real(1.f))},
                               count);
        });
        int const radius = limits.noise_radius, height = size.height;
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
            auto sum = zero<Value<4, Real>>();
            for (int j = -radius; j <= radius; ++j) {
                if (y + j < 0 || y + j >= height) continue;
                for (int i = -radius + (radius + j) % 2; i <= radius; i += 2) {
                    auto const there = load_pixels<Real>(spike, x + i, y + j);
                    sum = {sum.x + there.x, sum.y + there.y, sum.z + there.z, sum.w + there.w};
                }
            }
            auto const part = masked(load_pixels<Real>(square, x, y) > Real(0.f), 1.f / max(sum.w, Real(1.f)));
            store_pixels<Real>(off, x, y, add_scaled(load_pixels<Real>(off, x, y), vec3<Real>(sum.x, sum.y, sum.z), part), count);
        });
    }
};

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
