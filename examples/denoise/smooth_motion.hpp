#pragma once

#include <quell/image/extent.hpp>

#include <glm/vec2.hpp>

#include <array>
#include <optional>
#include <vector>

namespace quell::examples {

/// A motion that is smooth over the whole picture, as that of what is far away while a camera turns, or of all while a lens changes: each
/// of its components is a polynomial of second degree of the place. Rotations of a camera by small angles are such, and changes of its
/// focal length, and shifts of its lens.
struct SmoothMotion {
    static constexpr int terms = 6;
    using Terms = std::array<double, terms>;
    Extent size{};                  ///< of the picture
    std::array<Terms, 2> factors{}; ///< of the terms, for x and y, in pixels

    /// 1, x, y, x^2, x y, y^2 of a place, by the picture's width from its middle.
    [[nodiscard]] Terms terms_at(double x, double y) const;
    /// Where what is at a place was in the picture before, less where it is now.
    /// @param x, y the place in pixels; (0, 0): the middle of the first one
    [[nodiscard]] glm::vec2 at(double x, double y) const;
    /// Where what is at a place of the picture before is in this one, less where it was.
    [[nodiscard]] glm::vec2 back_from(double x, double y) const;
};

/// A picture in halved sizes, for finding how a part of it moves.
class Pyramid {
public:
    struct Level {
        Extent size;
        std::vector<float> light; ///< luminance
        std::vector<char> known;  ///< which pixels take part
    };
    std::vector<Level> levels; ///< the finest first: those with at most `widest` pixels a row, to about `narrowest`

    static constexpr int widest = 512, narrowest = 64;

    /// @param light luminance in any unit, row by row; where it is not finite, the pixel takes no part
    /// @param known which pixels take part
    Pyramid(Extent size, std::vector<float> light, std::vector<char> known);

    Extent size; ///< of the picture
};

/// How a part of a picture moves. The best shift is searched for in the coarsest pictures, and made a SmoothMotion of least squares in
/// finer ones (Gauss-Newton, with Geman-McClure weights, so that what moves otherwise is left out).
/// @param told what is told of it already, in pixels of the picture: previous = current + motion. What is found comes on top.
/// @return nothing where it is not borne out: squares of differences have to be less than .75 times those without it, and of how pixels
///         differ from their mean; so it has to be in most of the pixels in which it makes a difference, also in each quarter of the part;
///         and the mean of the motion has to be a twentieth of a pixel
[[nodiscard]] std::optional<SmoothMotion> found_motion(Pyramid const& now, Pyramid const& before, std::vector<glm::vec2> const& told);

} // namespace quell::examples
