#pragma once

#include <denoise/guide_images.hpp>
#include <denoise/linear_picture.hpp>
#include <denoise/stage_account.hpp>

#include <quell/frame/frame.hpp>
#include <quell/io/sequence_names.hpp>
#include <quell/link/colours/anti_aliased.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace quell::examples {

/// Colours in planes with padded rows, as kernels fetch them; null: not known.
using ColourImage = std::optional<ImageOf<Planar<>, Albedo>>;

/// A frame as those around it see it: what its pixels show, and where that goes.
struct FrameAround {
    int samples;                                     ///< per pixel
    LoadedChannelPointer depth, motion, motion_next; ///< null: not known
    std::vector<ColourImage> colours; ///< what signals are multiplied by, in order, and last what is added; null where that is not known
};

/// Reads what an AntiAliasing wants of a frame; null where its files lack that, or where nothing says how its colours were sampled, or
/// where many samples were taken at the pixels' centres: then its colours are what they should be.
/// @param samples per pixel; 0: not known
[[nodiscard]] std::shared_ptr<FrameAround const> frame_around(io::ExrImage const& image, io::SequenceNames const& names, int samples,
                                                              GuideImages& guides);
/// The planes that frame_around() reads.
[[nodiscard]] std::vector<std::string> planes_of_frame_around(io::ExrListing const& file, io::SequenceNames const& names);

/// Multiplies light by colours of a frame, anti-aliased by the frames around it.
struct AntiAliasing {
    using FramePointer = std::shared_ptr<FrameAround const>;
    FramePointer here;                    ///< null: nothing is anti-aliased
    std::span<FramePointer const> before; ///< the nearest first; a null one ends them
    std::vector<FramePointer> after;      ///< the same
    int threads;                          ///< that it runs on; 0: all
    bool is_blurred;                      ///< whether guides are noisy: samples lie beyond their pixel

    /// A colour times light; none where it is not known.
    /// @param light  null: the colour alone, which may change by itself
    /// @param signal that the colour is of
    /// @param why    told how far frames around count
    [[nodiscard]] std::optional<LinearPicture> product(std::size_t colour, LinearView const* light, std::string const& signal,
                                                       StageAccount& why) const;
};

} // namespace quell::examples
