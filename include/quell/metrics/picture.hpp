#pragma once

#include <quell/core/error.hpp>
#include <quell/image/image_storage.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

/// A picture of three components per pixel, row by row from the top-left. Metrics compare *displayed* pictures: sRGB-encoded, each
/// component in [0, 1].
struct Picture {
    Extent size;                   ///< in pixels
    std::vector<glm::vec3> pixels; ///< size.pixels() of them
};

/// Copies an image, or a channel of a frame (`frame[radiance].view()`): its first three components. Missing ones repeat the last, so that
/// one component is grey.
[[nodiscard]] Picture picture_of(ImageView auto const& view) {
    constexpr int last = std::remove_cvref_t<decltype(view)>::components - 1;
    Picture picture{view.size, {}};
    picture.pixels.reserve(static_cast<std::size_t>(picture.size.pixels()));
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x)
            picture.pixels.emplace_back(view.get(0, x, y), view.get(std::min(1, last), x, y), view.get(std::min(2, last), x, y));
    return picture;
}

/// Selects pixels: one entry per pixel, non-zero counts. An empty mask selects all.
using Mask = std::vector<std::uint8_t>;

/// One number per pixel, row by row from the top-left.
/// @tparam Number float or double
template <class Number> struct Plane {
    Extent size;                ///< in pixels
    std::vector<Number> values; ///< size.pixels() of them

    [[nodiscard]] Number const* row(int y) const { return values.data() + start(y); } ///< the first number of row y
    [[nodiscard]] Number* row(int y) { return values.data() + start(y); }             ///< the first number of row y
    /// Index of the first number of row y.
    [[nodiscard]] std::size_t start(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width); }
};

/// The sRGB transfer function (IEC 61966-2-1), for a linear component in [0, 1].
[[nodiscard]] inline float srgb_from_linear(float linear) {
    // 1.055 a - 0.055, arranged so that 1 becomes exactly 1.
    return linear <= 0.0031308f ? 12.92f * linear : std::min(1.f + 1.055f * (std::pow(linear, 1.f / 2.4f) - 1.f), 1.f);
}
/// The inverse of srgb_from_linear, for an encoded component in [0, 1].
[[nodiscard]] inline float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

namespace detail {

// Both tests read bits, as -ffast-math removes tests for NaN.
inline bool is_finite(float a) { return (std::bit_cast<std::uint32_t>(a) & 0x7f800000u) != 0x7f800000u; }
/// Non-negative floats are ordered like their bits, so one comparison rejects negatives, values above 1, infinity and NaN.
inline bool in_unit_range(float a) {
    auto const bits = std::bit_cast<std::uint32_t>(a);
    return bits <= 0x3f800000u || bits == 0x80000000u;
}

inline std::size_t count(Extent size) { return static_cast<std::size_t>(size.pixels()); }

inline std::string describe(Picture const& picture, std::size_t i) {
    auto const width = static_cast<std::size_t>(picture.size.width);
    auto const& p = picture.pixels[i];
    return "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ") is (" + std::to_string(p.x) + ", " +
           std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
}

inline void check_size(std::string const& name, Extent size, std::size_t found) {
    if (size.width <= 0 || size.height <= 0) raise_error(name, "its size is " + to_string(size), "give it at least 1x1 pixels");
    if (found == count(size)) return;
    raise_error(name, "its size is " + to_string(size) + " but it holds " + std::to_string(found) + " pixels",
                "give it " + std::to_string(size.pixels()) + ", row by row from the top-left");
}

inline void check_values(std::string const& name, Picture const& picture, auto valid, std::string const& remedy) {
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        auto const& p = picture.pixels[i];
        if (!(valid(p.x) && valid(p.y) && valid(p.z))) raise_error(name, describe(picture, i), remedy);
    }
}

inline void check_displayed(std::string const& name, Picture const& picture) {
    check_size(name, picture.size, picture.pixels.size());
    check_values(name, picture, in_unit_range, "pass displayed pictures in [0, 1], see quell::metrics::displayed");
}

inline void check_pair(Picture const& reference, Picture const& test) {
    check_displayed("reference picture", reference);
    check_displayed("test picture", test);
    if (reference.size == test.size) return;
    raise_error("test picture", "its size is " + to_string(test.size) + " but the reference's is " + to_string(reference.size),
                "compare pictures of one size");
}

inline void check_mask(Mask const& mask, Extent size) {
    if (mask.empty()) return;
    auto const pixels = std::to_string(size.pixels()) + " pixels of " + to_string(size);
    if (mask.size() != count(size))
        raise_error("mask", "it has " + std::to_string(mask.size()) + " entries for the " + pixels, "give it one entry per pixel, or none");
    if (std::ranges::all_of(mask, [](auto entry) { return entry == 0; }))
        raise_error("mask", "it selects 0 of the " + pixels, "select at least one, or pass an empty mask for the whole image");
}

/// Calls f(i) for each pixel that counts.
inline void for_each_selected(Extent size, Mask const& mask, auto&& f) {
    check_mask(mask, size);
    for (std::size_t i = 0; i < count(size); ++i)
        if (mask.empty() || mask[i] != 0) f(i);
}

/// Mean of value(i) over the pixels that count.
inline double mean_over(Extent size, Mask const& mask, auto&& value) {
    double sum = 0., pixels = 0.;
    for_each_selected(size, mask, [&](std::size_t i) {
        sum += value(i);
        pixels += 1.;
    });
    return sum / pixels;
}

/// Filter weights along one axis: an odd number, the middle one for the pixel itself.
template <class Number> using Taps = std::vector<Number>;

/// Taps of a Gaussian of this standard deviation in pixels, with sum 1.
template <class Number> Taps<Number> gaussian(double deviation, int radius) {
    std::vector<double> weights;
    double sum = 0.;
    for (int x = -radius; x <= radius; ++x) sum += weights.emplace_back(std::exp(-0.5 * (x / deviation) * (x / deviation)));
    Taps<Number> taps;
    for (auto const weight : weights) taps.push_back(static_cast<Number>(weight / sum));
    return taps;
}

/// out[first + i] = sum over t of taps[t] * sources[t][first + i], for `lanes` neighbours. A constant number and local sums let compilers
/// use SIMD registers; g++ 12 still stores the sums between taps, hence four taps at a time.
template <int lanes, class Number>
void weighted_sum(std::span<Number const* const> sources, Number const* taps, std::size_t first, Number* out) {
    Number sums[std::size_t{lanes}] = {};
    std::size_t t = 0;
    for (; t + 4 <= sources.size(); t += 4) {
        Number const *a = sources[t] + first, *b = sources[t + 1] + first, *c = sources[t + 2] + first, *d = sources[t + 3] + first;
        for (int i = 0; i < lanes; ++i) sums[i] += taps[t] * a[i] + taps[t + 1] * b[i] + taps[t + 2] * c[i] + taps[t + 3] * d[i];
    }
    for (; t < sources.size(); ++t)
        for (int i = 0; i < lanes; ++i) sums[i] += taps[t] * sources[t][first + static_cast<std::size_t>(i)];
    for (int i = 0; i < lanes; ++i) out[first + static_cast<std::size_t>(i)] = sums[i];
}

/// A whole row: out[x] = sum over t of taps[t] * sources[t][x].
template <class Number>
void weighted_row(std::span<Number const* const> sources, Taps<Number> const& taps, Number* out, std::size_t width) {
    constexpr int block = 16;
    std::size_t x = 0;
    for (; x + block <= width; x += block) weighted_sum<block>(sources, taps.data(), x, out);
    for (; x < width; ++x) weighted_sum<1>(sources, taps.data(), x, out);
}

/// Filters along rows; the border repeats. Tap t weights the pixel at x + t - radius.
template <class Number> Plane<Number> along_rows(Plane<Number> const& in, Taps<Number> const& taps) {
    Plane<Number> result{in.size, std::vector<Number>(in.values.size())};
    auto const width = static_cast<std::size_t>(in.size.width), radius = taps.size() / 2;
    std::vector<Number> padded(width + 2 * radius);
    std::vector<Number const*> sources;
    for (std::size_t t = 0; t < taps.size(); ++t) sources.push_back(padded.data() + t);
    for (int y = 0; y < in.size.height; ++y) {
        auto const* const row = in.row(y);
        std::fill_n(padded.data(), radius, row[0]);
        std::copy_n(row, width, padded.data() + radius);
        std::fill_n(padded.data() + radius + width, radius, row[width - 1]);
        weighted_row<Number>(sources, taps, result.row(y), width);
    }
    return result;
}

/// Filters along columns; the border repeats.
template <class Number> Plane<Number> along_columns(Plane<Number> const& in, Taps<Number> const& taps) {
    Plane<Number> result{in.size, std::vector<Number>(in.values.size())};
    auto const radius = static_cast<int>(taps.size() / 2);
    std::vector<Number const*> sources(taps.size());
    for (int y = 0; y < in.size.height; ++y) {
        int from = y - radius;
        for (auto& source : sources) source = in.row(std::clamp(from++, 0, in.size.height - 1));
        weighted_row<Number>(sources, taps, result.row(y), static_cast<std::size_t>(in.size.width));
    }
    return result;
}

} // namespace detail

/// What a screen shows of linear light: components clamped to [0, 1] and sRGB-encoded.
/// @throws Error naming the first pixel that is not finite: clamping would make an ordinary colour of it
[[nodiscard]] inline Picture displayed(Picture const& linear) {
    detail::check_size("linear picture", linear.size, linear.pixels.size());
    detail::check_values("linear picture", linear, detail::is_finite, "find what made it; metrics don't judge broken pictures");
    auto const shown = [](float a) { return srgb_from_linear(std::clamp(a, 0.f, 1.f)); };
    Picture result{linear.size, {}};
    result.pixels.reserve(linear.pixels.size());
    for (auto const& p : linear.pixels) result.pixels.emplace_back(shown(p.x), shown(p.y), shown(p.z));
    return result;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics
