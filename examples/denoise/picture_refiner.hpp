#pragma once

#include <denoise/denoised_frame.hpp>
#include <denoise/seen_frame.hpp>

#include <quell/frame/frame.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace quell::examples {

/// What is done to a picture once its signals are denoised, by frames around it: noise of guides is taken off (RepeatedDetail), and what
/// several frames lack is given back (RepeatedResidual). Frames are to be handed over in order. Signals change by as much as the
/// picture, each by its part of the light, so that they stay the picture's.
class PictureRefiner {
    /// Of the frame of a number; none before the first, or where frames did not have it.
    template <typename T> using OfFrame = std::optional<std::pair<long long, T>>;
    OfFrame<metrics::Picture> detail_before;        ///< the finest that noisy guides added
    OfFrame<std::vector<glm::vec3>> lacking_before; ///< what the picture lacked of its samples
    int threads;

public:
    /// @param count of threads; 0: as many as the machine has
    explicit PictureRefiner(int count) : threads(count) {}

    /// The picture as one has no noise of guides, and lacks their texture. Of what the signals have more in their finest detail, that part
    /// is taken off which is the guides', and which these do not repeat from frame to frame.
    /// @param names  by which the frame's guides are read
    /// @param light  the frame's, by signals
    /// @param as_one the picture, denoised as one
    void take_off_noise_of_guides(SeenFrame const& seen, io::ChannelNames const& names, LightSplit const& light,
                                  metrics::Picture const& as_one, DenoisedFrame& frame);

    /// What a picture lacks of its samples, as give_back_repeated() wants it; empty where the file has no motion.
    /// @param names   by which the frame's guides are read
    /// @param light   as the picture is made of it
    /// @param picture without what is given back
    [[nodiscard]] std::vector<glm::vec3> lacking(SeenFrame const& seen, io::ChannelNames const& names, LightSplit const& light,
                                                 metrics::Picture const& picture) const;

    /// Gives back what this picture, the one before and the one after lack of their samples.
    /// @param names of the frame's guides
    /// @param here  what lacking() said of this frame
    /// @param next  what it said of the frame after; null: there is none
    /// @param why   told what that changed
    void give_back_repeated(SeenFrame const& seen, io::ChannelNames const& names, std::vector<glm::vec3> here,
                            std::vector<glm::vec3> const* next, DenoisedFrame& frame, StageAccount& why);

    void forget() { detail_before.reset(), lacking_before.reset(); }
    /// Memory of what is remembered.
    [[nodiscard]] double bytes_per_pixel() const {
        return static_cast<double>(sizeof(glm::vec3)) * ((detail_before ? 1. : 0.) + (lacking_before ? 1. : 0.));
    }
};

} // namespace quell::examples
