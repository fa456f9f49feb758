#pragma once

#include <denoise/denoiser.hpp>
#include <denoise/guide_images.hpp>

#include <quell/link/residual/residual_feedback_shares.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// A frame's picture and what it was made of.
struct PictureOfSamples {
    LinearPicture const& samples; ///< not finite where there is none
    LinearPicture const& denoised;
    LoadedChannelPointer motion{}, motion_next{}; ///< the latter null: not known
};

/// The links behind a preset that give back what its filter took out by mistake (ResidualFeedback, RepeatedResidual), with their frames,
/// which are filled from files.
class ResidualLinks {
    struct Feedback;
    template <bool has_next> struct Repeated;
    struct Next;
    int threads;
    std::unique_ptr<Feedback> feedback;
    std::unique_ptr<Repeated<false>> alone;
    std::unique_ptr<Repeated<true>> with_next;
    std::unique_ptr<Next> next;
    LinearPicture other; ///< memory that pictures are written into

public:
    /// @param count of threads; 0: as many as the machine has
    explicit ResidualLinks(int count);
    ~ResidualLinks();

    /// Feeds the residual of a signal's light back.
    /// @param denoiser of the light
    /// @param light    is changed
    /// @return how far noise was that of single pixels; nothing where the file has no normals or no depth
    std::optional<float> feed_back(Denoiser const& denoiser, ResidualFeedbackShares const& shares, LinearPicture& light);

    /// What was left out of what frames in a row lack.
    struct Refusal {
        float trust = 1.f;         ///< how far noise was that of single pixels
        std::vector<float> same{}; ///< of each pixel: which part of the frames around is left out, as they have the same noise
    };
    /// Gives back what a picture, the one before and the one after lack of their samples. Frames are to be handed over in order.
    /// @param here   the frame
    /// @param number of the frame
    /// @param count  samples of each pixel
    /// @param after  the frame after; null: there is none
    /// @param picture gets the picture
    [[nodiscard]] Refusal give_back_repeated(PictureOfSamples const& here, long long number, int count, PictureOfSamples const* after,
                                             LinearPicture& picture);

    void forget();          ///< all frames so far
    void release_scratch(); ///< all memory but what is remembered
    [[nodiscard]] double bytes_per_pixel() const;
};

/// The plans of its links, under a line each.
[[nodiscard]] std::string plans_of_residual_links();

} // namespace quell::examples
