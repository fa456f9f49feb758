#pragma once

#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Colours of one ray per pixel, anti-aliased by those of other frames (after Yang et al. 2009, "Amortized supersampling", with samples in
/// place of pictures, so that nothing is blurred from frame to frame). Each sample of a frame around is moved along its own motion to where
/// it is now. It counts where its depth is found among the 3x3 pixels there, and by a Gaussian of its distance from the pixel's centre.
///
/// The samples of a pixel are those of two surfaces at most, the nearest and the farthest of the 3x3: each is multiplied by the light of
/// its own surface, so that an edge is as mixed as its pixel covers of both.
struct AntiAliased {
    static constexpr int most_frames = 4; ///< to each side

    float deviation = 0.5f; ///< of the Gaussian, in pixels
    float range = 0.03f;    ///< part of the depth by which samples may be off
    float own = 1.f;        ///< weight of the pixel's own sample
    bool by_surface = true; ///< whether each surface has its own light; else both have the pixel's
    float change = 0.f;     ///< colours whose mean is by more than this part none of those around have changed by themselves; 0: none does

    /// For pixels of so many samples. Of one, each surface has its light, and a pixel's own sample is one among others. What is the mean of
    /// many has the pixel's filter already, and less noise: above 8 samples it is soon nearly all.
    /// @param samples per pixel, 1 or more
    [[nodiscard]] static constexpr AntiAliased of_samples(int samples) {
        if (samples <= 1) return {.deviation = .45f, .change = .1f};
        float const square = static_cast<float>(samples) * static_cast<float>(samples);
        return {.deviation = .35f, .own = square / 16.f * std::max(1.f, square / 64.f), .by_surface = false, .change = .1f};
    }
};

/// A frame as anti-aliasing sees it, as views.
/// @tparam Storage of its images
template <class Storage = Planar<>> struct ColouredFrame {
    ViewOf<Storage, Albedo> colour{};  ///< what light is multiplied by
    ViewOf<Storage, Depth> depth{};    ///< as the channel
    ViewOf<Storage, Motion> motion{};  ///< to the frame before, in pixels, without jitter
    ViewOf<Storage, Motion> to_next{}; ///< the same to the frame after; not finite: not known
    glm::vec2 jitter{0.f};             ///< where the samples lie, from the pixels' centres
    bool knows_next = true;            ///< whether there is `to_next`
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
