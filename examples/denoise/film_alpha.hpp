#pragma once

#include <denoise/seen_frame.hpp>

#include <quell/frame/frame.hpp>

#include <deque>
#include <vector>

namespace quell::examples {

struct DenoisedFrame;

/// Limits denoised alpha to what the file has within three pixels. Of a light that is one of several, alpha has the noise of its share.
void limit_alpha(std::vector<float>& denoised, std::vector<float> const& alpha, Extent size);

/// What a transparent film shows in a frame of these colours and this alpha.
[[nodiscard]] FilmContents film_contents(LinearView const& colours, std::vector<float> const& alpha);

/// What a frame of a window, which is its first, shows in the 3x3 around each pixel, and the frames after it in the places that they lead
/// to. Nothing else of this frame and of later ones has a part in the pixel but by filters, which spread light.
/// @param later how many frames after it
/// @param names by which motion and depth are read
[[nodiscard]] FilmContents shown_from_now_on(std::deque<SeenFrame>& window, int later, io::ChannelNames const& names);

/// Keeps empty what a transparent film shows nothing in. Filters spread light and alpha from farther away. What is not finite counts as
/// nothing.
class FilmAlpha {
    FilmContents past; ///< of the last frame, when it was denoised; empty: there was none
    Extent size;

public:
    /// Where nothing is shown, in the history that a pixel's motion leads to neither, picture, signals and alpha are 0. Where light is
    /// shown over alpha 0, as of flames, alpha is 0 still.
    /// @param frame its alpha is that of the file, or the denoised one
    /// @param shown of the frame: see shown_from_now_on(); empty: an opaque film
    /// @param vectors its motion; null: it has no history
    void clear_empty(DenoisedFrame& frame, FilmContents const& shown, LoadedChannelPointer const& vectors);
    void forget() { past.clear(); }
};

} // namespace quell::examples
