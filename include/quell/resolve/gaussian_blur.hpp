#pragma once

#include <quell/resolve/planes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The weights of a Gaussian's taps, to one side. Farther than three deviations there are none.
struct GaussianTaps {
    static constexpr int most = 16;
    static constexpr float largest_deviation = 5.f;
    std::array<float, most + 1> weights{};
    int radius;

    /// @param deviation in pixels, more than 0; at most largest_deviation
    explicit GaussianTaps(float deviation) : radius(std::min(static_cast<int>(std::ceil(3.f * deviation)), most)) {
        for (int i = 0; i <= radius; ++i)
            weights[static_cast<std::size_t>(i)] = std::exp(-0.5f * static_cast<float>(i * i) / (deviation * deviation));
    }
    /// @param off in pixels, in either direction
    [[nodiscard]] constexpr float operator()(int off) const { return weights[static_cast<std::size_t>(off < 0 ? -off : off)]; }
};

/// Means by a Gaussian, over what lies in the image.
template <Executor E> Planes<3> blurred(E const& executor, PlanesView<3> image, float deviation) {
    Planes<3> along_rows(image.size), blurred_image(image.size);
    auto const rows = along_rows.view(), to = blurred_image.view();
    GaussianTaps const taps(deviation);
    auto const size = image.size;
    for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
        auto const columns = Real(static_cast<float>(x)) + lanes<Real>();
        auto sum = zero<vec3<Real>>();
        Real whole(0.f);
        for (int i = -taps.radius; i <= taps.radius; ++i) {
            auto const column = columns + static_cast<float>(i);
            auto const inside = both(column >= Real(0.f), column < Real(static_cast<float>(size.width)));
            auto const weight = masked(inside, Real(taps(i)));
            sum = add_scaled(sum, load_pixels<Real>(image, x + i, y), weight), whole = whole + weight;
        }
        store_pixels<Real>(rows, x, y, scale(sum, 1.f / whole), count);
    });
    for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
        auto sum = zero<vec3<Real>>();
        float whole = 0.f;
        for (int i = std::max(-taps.radius, -y); i <= std::min(taps.radius, size.height - 1 - y); ++i)
            sum = add_scaled(sum, load_pixels<Real>(rows, x, y + i), Real(taps(i))), whole += taps(i);
        store_pixels<Real>(to, x, y, scale(sum, Real(1.f / whole)), count);
    });
    return blurred_image;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
