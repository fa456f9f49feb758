#pragma once

#include <denoise/denoised_frame.hpp>
#include <denoise/seen_frame.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace quell::examples {

/// What is done to a picture once its signals are denoised, by frames around it: noise of guides is taken off (RepeatedDetail), and what
/// several frames lack is given back (ResidualLinks). Frames are to be handed over in order. Signals change by as much as the
/// picture, each by its part of the light, so that they stay the picture's.
class PictureRefiner {
    /// Of the frame of a number; none before the first, or where frames did not have it.
    template <typename T> using OfFrame = std::optional<std::pair<long long, T>>;
    OfFrame<LinearPicture> detail_before; ///< the finest that noisy guides added

public:
    /// The picture as one has no noise of guides, and lacks their texture. Of what the signals have more in their finest detail, that part
    /// is taken off which is the guides', and which these do not repeat from frame to frame.
    /// @param guide_names by which the frame's guides are read
    /// @param names       by which its light and colours are
    /// @param light       the frame's, by signals
    /// @param as_one      the picture, denoised as one
    void take_off_noise_of_guides(SeenFrame& seen, io::ChannelNames const& guide_names, io::SequenceNames const& names,
                                  LightSplit const& light, LinearView const& as_one, DenoisedFrame& frame);

    void forget() { detail_before.reset(); }
    /// Memory of what is remembered.
    [[nodiscard]] double bytes_per_pixel() const { return detail_before ? static_cast<double>(sizeof(glm::vec3)) : 0.; }
};

/// The samples that a picture is made of, put together as the picture is; not finite where one is missing. Empty where the file has no
/// motion.
/// @param names by which the frame's guides are read
/// @param light as the picture is made of it
[[nodiscard]] LinearPicture samples_of_picture(SeenFrame const& seen, io::ChannelNames const& names, LightSplit const& light);
/// Adds to each signal its share of what a picture has more than it had before: that of the light.
/// @param before what the picture was
void change_signals(DenoisedFrame& frame, LinearView const& before);

} // namespace quell::examples
