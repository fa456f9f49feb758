#pragma once

#include <quell/image/image_storage.hpp>
#include <quell/link/residual/shared_noise.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far noise may be taken for that of single pixels: 1, and down to 0 where it is shared.
/// @param rule the limits
/// @param part what shared_noise() said
[[nodiscard]] inline float independence(SharedNoise const& rule, float part) {
    return std::clamp((rule.most - part) / (rule.most - rule.least), 0.f, 1.f);
}

/// What samples have more than a picture of them, as a view of three components; not finite where a sample is no light. Of views of four
/// components the last is alpha, and one component stands for three that are the same.
template <ImageView Samples, ImageView Picture> struct LightLess {
    static constexpr int components = 3;                         ///< of what it says
    static constexpr int last = Samples::components > 1 ? 1 : 0; ///< step from one component of the samples to the next
    Samples samples;                                             ///< linear light
    Picture picture;                                             ///< of them
    Extent size = samples.size;                                  ///< of both

    /// A pixel's samples less the picture.
    /// @param x, y where it is
    [[nodiscard]] vec3<float> get(int x, int y) const {
        vec3<float> const sample{samples.get(0, x, y), samples.get(last, x, y), samples.get(2 * last, x, y)};
        float const none = detail::is_light(sample) ? 0.f : std::numeric_limits<float>::quiet_NaN();
        return {sample.x - picture.get(0, x, y) + none, sample.y - picture.get(last, x, y), sample.z - picture.get(2 * last, x, y)};
    }
};
/// @cond
template <ImageView Samples, ImageView Picture> LightLess(Samples, Picture) -> LightLess<Samples, Picture>;
/// @endcond

/// Which part of their noise neighbours have in common: about 0 where that is nothing, 1 where it is the same.
/// @param residual what samples have more than a picture of them: a view of three components, or a LightLess. What is not finite counts as
/// 0
template <class Residual> [[nodiscard]] float shared_noise(Residual const& residual) {
    constexpr int window_side = 8;
    auto const size = residual.size;
    auto const width = static_cast<std::size_t>(size.width);
    std::vector<float> parts, rows(2 * 3 * width);
    auto const take = [&](int y, float* row) {
        for (int x = 0; x < size.width; ++x, row += 3) {
            auto const e = residual.get(x, y);
            bool const is_known = is_finite(e.x) && is_finite(e.y) && is_finite(e.z);
            for (int c = 0; c < 3; ++c) row[c] = is_known ? e[c] : 0.f;
        }
    };
    /// Of one component of a window: of pixels, those to the right and those below, and of products with them.
    struct Sums {
        double here = 0, right = 0, below = 0, square = 0, by_right = 0, by_below = 0;
    };
    std::vector<std::array<Sums, 3>> windows(width / static_cast<std::size_t>(window_side) + 1);
    std::vector<double> counts(windows.size(), 0.);
    auto const close = [&] {
        for (std::size_t w = 0; w < windows.size(); ++w) {
            double raw = 0, square = 0, right = 0, below = 0;
            for (auto const& sums : windows[w]) {
                double const mean = sums.here / std::max(counts[w], 1.);
                raw += sums.square, square += sums.square - mean * sums.here;
                right += sums.by_right - mean * sums.right, below += sums.by_below - mean * sums.below;
            }
            // Where a picture lacks the same everywhere, rounding is all that is left.
            if (square > 1e-6 * raw) parts.push_back(static_cast<float>(std::min(right, below) / square));
            windows[w] = {}, counts[w] = 0.;
        }
    };
    float *here = rows.data(), *below = here + 3 * width;
    if (size.height > 0) take(0, here);
    for (int y = 0; y + 1 < size.height; ++y) {
        take(y + 1, below);
        for (std::size_t x = 0; x + 1 < width; ++x) {
            auto const window = x / static_cast<std::size_t>(window_side);
            ++counts[window];
            for (std::size_t c = 0; c < 3; ++c) {
                auto& sums = windows[window][c];
                auto const own = static_cast<double>(here[3 * x + c]), beside = static_cast<double>(here[3 * x + 3 + c]);
                auto const under = static_cast<double>(below[3 * x + c]);
                sums.here += own, sums.right += beside, sums.below += under;
                sums.square += own * own, sums.by_right += own * beside, sums.by_below += own * under;
            }
        }
        std::swap(here, below);
        if ((y + 1) % window_side == 0) close();
    }
    close();
    if (parts.empty()) return 0.f;
    auto const quartile = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 4);
    std::ranges::nth_element(parts, quartile);
    return *quartile;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
