#pragma once

#include <denoise/linear_picture.hpp>
#include <support/frame_pattern.hpp>

#include <quell/io/channel_names.hpp>
#include <quell/link/resolve/resolve.hpp>

#include <memory>
#include <string>
#include <vector>

namespace quell::examples {

struct SeenFrame;

/// How much larger pictures are to become, and whether samples of several frames make them up.
struct Upsampling {
    float ratio = 1.f;   ///< of the output's width and height to the input's, 1 to 4
    std::string alone{}; ///< why each frame is enlarged by itself, a part of a sentence; empty: frames before it take part

    [[nodiscard]] bool resolves() const { return alone.empty(); }
    /// The size of what comes out, to the next whole pixel. @throws Error where it is too large for a file
    [[nodiscard]] Extent enlarged(Extent size) const;
    /// The name of the method: resolve or bicubic.
    [[nodiscard]] std::string method() const { return resolves() ? "resolve" : "bicubic"; }
};

/// Frames before the first that a resolve puts to use.
inline constexpr int frames_of_upsampling = quell::Resolve<>::past_frames;

/// What the files say of their jitter decides. All chunks of a sequence are to ask with the same frames.
/// @param ratio  see Upsampling
/// @param frames numbers; the first that there are and can be read are looked at
[[nodiscard]] Upsampling upsampling_for(float ratio, FramePattern const& in, std::vector<long long> const& frames);

/// Enlarges the pictures of a sequence, and their alpha. Where it resolves, samples of the last frames are put together
/// (presets::resolve). Otherwise each frame is a Catmull-Rom interpolation of itself, limited to what its taps hold.
class Upsampler {
    Upsampling how;
    int threads;
    struct Histories;
    std::unique_ptr<Histories> histories;
    double taken = 0; ///< milliseconds

public:
    /// @param size    of the input
    /// @param threads 0: all that there are
    Upsampler(Extent size, Upsampling upsampling, int threads);
    ~Upsampler();

    /// Enlarges the next frame.
    /// @param names by which its guides are read
    /// @param alpha of the picture; empty: it has none
    /// @throws Error naming the file where its jitter is not known, though that of frames before it was, or is of no use
    void next(SeenFrame& seen, io::ChannelNames const& names, LinearPicture& picture, std::vector<float>& alpha);
    void release_scratch();
    [[nodiscard]] double milliseconds() const { return taken; }
    /// Memory of history and scratch, per pixel of the input.
    [[nodiscard]] double bytes_per_pixel() const;
};

} // namespace quell::examples
