#pragma once

#include <quell/frame/frame.hpp>
#include <quell/metrics/picture.hpp>

#include <vector>

namespace quell::examples {

struct DenoisedFrame;

/// Limits denoised alpha to what the file has within three pixels. Of a light that is one of several, alpha has the noise of its share.
void limit_alpha(std::vector<float>& denoised, std::vector<float> const& alpha, Extent size);

/// Keeps empty what a transparent film shows nothing in: where alpha is 0 in the pixel, in the 3x3 around it and in the history that its
/// motion leads to, picture, signals and alpha are 0. Filters spread light from farther away.
class FilmAlpha {
    std::vector<float> past; ///< of the last frame, when it was denoised
    Extent size;

public:
    /// @param frame  its alpha is that of the file, or the denoised one
    /// @param alpha  of the file
    /// @param motion of the frame, to the last one
    void clear_empty(DenoisedFrame& frame, std::vector<float> const& alpha, Frame<Channels<Motion>> const& motion);
    void forget() { past.clear(); }

private:
    [[nodiscard]] bool is_empty_around(std::vector<float> const& alpha, int x, int y) const;
    [[nodiscard]] bool was_empty(glm::vec2 const& place) const;
};

} // namespace quell::examples
