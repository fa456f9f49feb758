#pragma once

#include <quell/image/extent.hpp>

#include <glm/vec2.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Which pixels have a sample where a host makes fewer samples than pixels: one in each block of `columns` x `rows` pixels. Which one that
/// is the frame's phase says: it moves from frame to frame, so that after columns * rows frames each pixel had a sample.
///
///     half_size            half_width           checkerboard          "#" has a sample, at phase (0, 0)
///     # . # . # .          # . # . # .          # . # . # .
///     . . . . . .          # . # . # .          . # . # . #
///     # . # . # .          # . # . # .          # . # . # .
///     . . . . . .          # . # . # .          . # . # . #
struct SamplePattern {
    int columns = 1,        ///< of a block, in pixels: 1 to 8
        rows = 1;           ///< of a block, in pixels: 1 to 8
    bool staggered = false; ///< each row of blocks has its samples one column further right than the row above, as a checkerboard

    /// Equal in all.
    friend constexpr bool operator==(SamplePattern, SamplePattern) = default;

    /// The number of phases, which is that of pixels in a block.
    [[nodiscard]] constexpr int phases() const { return columns * rows; }
    /// The phase of frame `number`, in an order in which each follows one that is far from it. For half_size: (0, 0), (1, 1), (1, 0), (0,
    /// 1). Any other order in which all come equally often will do as well.
    /// @param number of the frame, 0 or more
    [[nodiscard]] constexpr glm::ivec2 phase(long long number) const {
        auto const k = static_cast<int>(number % phases());
        return {(k % rows + k / rows) % columns, k % rows};
    }
    /// The size of an image of all samples side by side: a part of the frame's, rounded up.
    [[nodiscard]] constexpr Extent stored(Extent frame) const {
        auto const up = [](int length, int part) { return length / part + (length % part > 0 ? 1 : 0); };
        return {up(frame.width, columns), up(frame.height, rows)};
    }
    /// Whether an image of this size can hold the samples: each length a part of the frame's, rounded up or down.
    [[nodiscard]] constexpr bool fits(Extent image, Extent frame) const {
        auto const most = stored(frame);
        auto const least = Extent{frame.width / columns, frame.height / rows};
        auto const between = [](int least_length, int length, int most_length) {
            return length >= 1 && length >= least_length && length <= most_length;
        };
        return between(least.width, image.width, most.width) && between(least.height, image.height, most.height);
    }
    /// The column of the sample in a block of that row of blocks.
    [[nodiscard]] constexpr int column_in_block(int block_row, glm::ivec2 phase) const {
        return (phase.x + (staggered ? block_row : 0)) % columns;
    }
    /// The pixel that the sample in this column and row of the stored image is of. Blocks cut off by the right or the lower border may have
    /// theirs outside the frame: such a sample is not read.
    /// @param column of the stored image
    /// @param row    of the stored image
    /// @param phase  from (0, 0) to (columns - 1, rows - 1)
    [[nodiscard]] constexpr glm::ivec2 pixel(int column, int row, glm::ivec2 phase) const {
        return {column * columns + column_in_block(row, phase), row * rows + phase.y};
    }
    /// Whether the pixel (x, y) has a sample; it stands at (x / columns, y / rows) in the stored image.
    /// @param x     column of the frame
    /// @param y     row of the frame
    /// @param phase from (0, 0) to (columns - 1, rows - 1)
    [[nodiscard]] constexpr bool has(int x, int y, glm::ivec2 phase) const {
        return pixel(x / columns, y / rows, phase) == glm::ivec2(x, y);
    }
};

/// A sample in each 2x2 pixels: half the width and half the height.
inline constexpr SamplePattern half_size{.columns = 2, .rows = 2};
/// A sample in every second column.
inline constexpr SamplePattern half_width{.columns = 2};
/// A sample in every second row.
inline constexpr SamplePattern half_height{.rows = 2};
/// A sample in every second pixel: even ones in one row, odd ones in the next.
inline constexpr SamplePattern checkerboard{.columns = 2, .staggered = true};

} // namespace quell::inline QUELL_INSTRUCTION_SET
