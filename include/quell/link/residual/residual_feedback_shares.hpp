#pragma once

#include <quell/core/logarithm.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How much of each part of a residual is fed back (ResidualFeedback). N is the noise of samples relative to the light: a third of its
/// logarithm to the base of 2.
struct ResidualFeedbackShares {
    float fine_held = 0;    ///< of the finest band, where held-out samples surely have it too
    float wide = 0;         ///< of the widest level
    float wide_noise = 0;   ///< the same by N
    float wide_texture = 0; ///< the same where the light varies

    /// Shares fitted to renders of Cycles of 1 and of 16 samples; in between by the logarithm, as are those of 4.
    /// @param samples of each pixel
    [[nodiscard]] static constexpr ResidualFeedbackShares of_samples(float samples);
    /// Shares for a picture that was made with its history, whatever samples say of that: where it holds, it is steadier than one frame's
    /// samples. Nothing comes back of single ones, and all that of_samples() says of 16; in between by the logarithm.
    /// @param samples of each pixel
    [[nodiscard]] static constexpr ResidualFeedbackShares beside_history(float samples);
    /// Their sum with so many of the others.
    [[nodiscard]] constexpr ResidualFeedbackShares plus(ResidualFeedbackShares const& others, float times) const {
        return {fine_held + others.fine_held * times, wide + others.wide * times, wide_noise + others.wide_noise * times,
                wide_texture + others.wide_texture * times};
    }
};

/// Fitted to renders of 1 sample by least squares, together with parts that are not fed back as they bring too little.
inline constexpr ResidualFeedbackShares feedback_of_1_sample{
    .fine_held = 0.1052f, .wide = 0.2213f, .wide_noise = -0.0563f, .wide_texture = 0.2616f};
/// Fitted to renders of 16 samples, likewise.
inline constexpr ResidualFeedbackShares feedback_of_16_samples{
    .fine_held = 0.897f, .wide = 0.3496f, .wide_noise = -0.0802f, .wide_texture = 0.2637f};

namespace detail {
/// Where a number of samples lies between 1 and 16: 0 to 1.
constexpr float between_1_and_16(float samples) {
    constexpr float octaves = .25f * 1.44269504f;
    return clamp(logarithm(max(samples, 1.f)) * octaves, 0.f, 1.f);
}
} // namespace detail

constexpr ResidualFeedbackShares ResidualFeedbackShares::of_samples(float samples) {
    float const t = detail::between_1_and_16(samples);
    return ResidualFeedbackShares{}.plus(feedback_of_1_sample, 1.f - t).plus(feedback_of_16_samples, t);
}

constexpr ResidualFeedbackShares ResidualFeedbackShares::beside_history(float samples) {
    return ResidualFeedbackShares{}.plus(of_samples(samples), detail::between_1_and_16(samples));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
