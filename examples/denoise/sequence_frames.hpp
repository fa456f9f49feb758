#pragma once

#include <denoise/doubted_albedo.hpp>
#include <denoise/empty_guides.hpp>
#include <denoise/seen_frame.hpp>
#include <denoise/sequence_settings.hpp>
#include <denoise/untold_motion.hpp>

#include <quell/io/exr/exr_original.hpp>

#include <memory>
#include <string>
#include <vector>

namespace quell::examples {

/// Reads the frames of a sequence, whichever renderer wrote them: as images of a canvas, which is the display window and what the files
/// hold around it, with their light divided among signals.
class SequenceFrames {
public:
    explicit SequenceFrames(SequenceSettings some) : settings(std::move(some)) {}

    /// How frames are denoised, with the names and the upsampling that the files decide on.
    SequenceSettings settings;

    /// The first frame, or one that reaches farther out of its display window, decides on names and canvas.
    /// @throws Error naming the file and what is wrong with it
    void begin(io::ExrOriginal const& file);
    /// Reads a frame of the canvas. @throws Error naming the file and what is wrong with it
    [[nodiscard]] SeenFrame seen(io::ExrOriginal const& file, long long number);
    /// Tells a frame where its background is in the frame after it, which has been read.
    void tell_next(SeenFrame& seen) const;
    /// Its light by signals, or as one.
    [[nodiscard]] LightSplit const& split(SeenFrame& seen, bool as_one) const;
    /// What light is divided by.
    [[nodiscard]] SplitRule rule() const;

    [[nodiscard]] Extent size() const { return window; } ///< of the display window
    [[nodiscard]] Region const& region() const { return canvas; }
    [[nodiscard]] Extent canvas_size() const { return io::detail::size_of(canvas); }
    /// Whether the canvas holds all of another one.
    [[nodiscard]] bool is_inside(Region const& other) const;
    /// The part of a picture of the canvas that the display window shows.
    [[nodiscard]] metrics::Picture displayed(LinearView const& whole) const;
    /// By which images of the canvas are read.
    [[nodiscard]] io::SequenceNames const& names() const { return on_canvas; }
    /// By which the guides of all signals are read.
    [[nodiscard]] io::ChannelNames const& guide_names() const { return on_canvas.of_signals[0].channels; }
    [[nodiscard]] io::SequenceNames const& names_of(SeenFrame const& seen) const {
        if (seen.believed) return *seen.believed;
        return seen.behind ? *seen.behind : on_canvas;
    }
    /// About guides that say nothing, in the frames so far: one sentence each.
    [[nodiscard]] std::vector<std::string> remarks() const;
    /// The plane of the film's alpha; empty: none.
    [[nodiscard]] std::string const& alpha_plane() const { return alpha; }
    /// Whether alpha is denoised with the light that it belongs to.
    [[nodiscard]] bool carries_alpha() const { return !alpha.empty() && rule().carries_alpha; }
    /// Whether a signal, or the rest, has alpha in it where alpha is denoised.
    [[nodiscard]] bool has_alpha(std::size_t signal) const;

private:
    Extent window; ///< the display window's size
    Region canvas;
    io::SequenceNames on_canvas;
    std::string alpha;
    EmptyPasses empty_passes;
    UntoldMotion untold_motion;
    DoubtedAlbedo doubted_albedo;
    std::unique_ptr<Denoiser> any; ///< says what denoisers of the preset want

    void check_upsampling(io::ExrListing const& file);
    [[nodiscard]] std::vector<std::string> planes(io::ExrListing const& file) const;
};

} // namespace quell::examples
