#pragma once

#include <quell/image/extent.hpp>
#include <quell/io/channel_names.hpp>
#include <quell/io/exr_image.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace quell::examples {

/// Tells whether two pixels show one surface.
struct SurfaceGuides {
    std::vector<float> depth = {};                  ///< of each pixel; not finite: no surface. Empty: not known
    std::array<std::vector<float>, 3> normals = {}; ///< x, y and z. Empty: not known
    /// By how much inverse depth grows over a pixel to the right, and over one down. Empty: not known
    std::array<std::vector<float>, 2> slopes = {};

    /// Takes slopes from the depth: of each pixel, the flatter one of both sides, which at an edge is the one of its own surface. Over a
    /// plane inverse depth is linear in the picture, so that planes stay one surface however steep they are seen.
    void find_slopes(Extent size);
    /// By depth alone.
    /// @param dx, dy from the pixel to the other, pixels
    [[nodiscard]] bool are_on_one_plane(std::size_t pixel, std::size_t other, int dx, int dy) const;
    /// By depth and normals.
    /// @param dx, dy from the pixel to the other, pixels
    [[nodiscard]] bool are_one(std::size_t pixel, std::size_t other, int dx, int dy) const;
};

/// By the guides that the image has; none where it has neither depth nor normals: then light of two things may be compared.
[[nodiscard]] std::optional<SurfaceGuides> surface_guides_in(io::ExrImage const& image, io::ChannelNames const& names);

/// Which pixels lie on one surface, so that sums and means stay on it. Links lead over 1, 3 and 9 pixels in eight directions. By steps of
/// these lengths in a row, a pixel reaches those of the 27x27 around it that are of its surface, each by one way.
class SurfaceLinks {
public:
    static constexpr std::array lengths{1, 3, 9};

    SurfaceLinks(Extent size, SurfaceGuides const& guides);

    /// Calls f(pixel) with those that are linked to one over lengths[level].
    template <class F> void for_each(std::size_t pixel, std::size_t level, F&& f) const {
        for (unsigned left = links[pixel] >> (8 * level) & 0xff; left != 0; left &= left - 1)
            f(moved(pixel, level, static_cast<std::size_t>(std::countr_zero(left))));
    }
    /// Calls f(pixel, other) with each two that are linked, once.
    template <class F> void for_each_pair(F&& f) const {
        for (std::size_t pixel = 0; pixel < links.size(); ++pixel)
            for (std::size_t level = 0; level < lengths.size(); ++level)
                for (std::size_t d = 0; d < directions.size() / 2; ++d)
                    if ((links[pixel] >> (8 * level + d) & 1) != 0) f(pixel, moved(pixel, level, d));
    }
    /// Of each pixel, the sum over those of the 27x27 around it that are of its surface.
    template <class Value> [[nodiscard]] std::vector<Value> window_sums(std::vector<Value> values) const {
        std::vector<Value> sums(values.size());
        for (std::size_t level = 0; level < lengths.size(); ++level) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                Value sum = values[i];
                for_each(i, level, [&](std::size_t there) { sum += values[there]; });
                sums[i] = sum;
            }
            std::swap(values, sums);
        }
        return values;
    }

private:
    /// The second four are the first, turned around.
    static constexpr std::array<std::array<int, 2>, 8> directions{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}, {1, -1}}};
    Extent size;
    std::vector<std::uint32_t> links; ///< of each pixel: eight bits for each length

    [[nodiscard]] std::size_t moved(std::size_t pixel, std::size_t level, std::size_t direction) const {
        auto const& [dx, dy] = directions[direction];
        return pixel + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(lengths[level]) * (dy * size.width + dx));
    }
};

} // namespace quell::examples
