#pragma once

#include <quell/core/instruction_set.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How much of each part of a residual is fed back (ResidualFeedback). N is the noise of samples relative to the light: a third of its
/// logarithm to the base of 2.
struct ResidualFeedbackShares {
    float near_noise = 0;   ///< of the finest level, by N
    float near_sure = 0;    ///< the same where it is more than noise
    float near_held = 0;    ///< the same where held-out samples have it too
    float fine_held = 0;    ///< of the finest band, where held-out samples surely have it too
    float middle_held = 0;  ///< of the third band, the same way
    float wide = 0;         ///< of the widest level
    float wide_noise = 0;   ///< the same by N
    float wide_texture = 0; ///< the same where the light varies
    float alone = 0;        ///< of what the estimate without history has more or less

    /// Shares fitted to renders of Cycles of 1 and of 16 samples; in between by the logarithm, as are those of 4.
    /// @param samples of each pixel
    [[nodiscard]] static ResidualFeedbackShares of_samples(float samples);
    /// Shares for a picture that was made with its history, whatever samples say of that: where it holds, it is steadier than one frame's
    /// samples. Nothing comes back of single ones, and all that of_samples() says of 16; in between by the logarithm.
    /// @param samples of each pixel
    [[nodiscard]] static ResidualFeedbackShares beside_history(float samples);
    /// What is right for a frame: of_samples(), but beside_history() where it was made with one, and nothing says what it is by itself.
    /// @param samples     of each pixel
    /// @param has_past    whether the frame was made with its history
    /// @param knows_alone whether it is known what the frame is by itself
    [[nodiscard]] static ResidualFeedbackShares of_frame(float samples, bool has_past, bool knows_alone) {
        return has_past && !knows_alone ? beside_history(samples) : of_samples(samples);
    }
};

/// The name of a share, and the share.
struct NamedFeedbackShare {
    char const* name;                     ///< in snake case
    float ResidualFeedbackShares::*share; ///< which it is
};
/// All of them.
inline constexpr std::array<NamedFeedbackShare, 9> feedback_shares{{{"near_noise", &ResidualFeedbackShares::near_noise},
                                                                    {"near_sure", &ResidualFeedbackShares::near_sure},
                                                                    {"near_held", &ResidualFeedbackShares::near_held},
                                                                    {"fine_held", &ResidualFeedbackShares::fine_held},
                                                                    {"middle_held", &ResidualFeedbackShares::middle_held},
                                                                    {"wide", &ResidualFeedbackShares::wide},
                                                                    {"wide_noise", &ResidualFeedbackShares::wide_noise},
                                                                    {"wide_texture", &ResidualFeedbackShares::wide_texture},
                                                                    {"alone", &ResidualFeedbackShares::alone}}};

/// Fitted to renders of 1 sample by least squares. But `alone` is half of what is best for these, and 0 at 16 samples:
/// where noise stays on the screen, a frame by itself and with its history have it both.
inline constexpr ResidualFeedbackShares feedback_of_1_sample{.near_noise = 0.0142f,
                                                             .near_sure = -0.2234f,
                                                             .near_held = -0.0433f,
                                                             .fine_held = 0.1052f,
                                                             .middle_held = 0.342f,
                                                             .wide = 0.2213f,
                                                             .wide_noise = -0.0563f,
                                                             .wide_texture = 0.2616f,
                                                             .alone = -0.1f};
/// Fitted to renders of 16 samples, likewise.
inline constexpr ResidualFeedbackShares feedback_of_16_samples{.near_noise = 0.0522f,
                                                               .near_sure = -0.3293f,
                                                               .near_held = -0.13f,
                                                               .fine_held = 0.897f,
                                                               .middle_held = 1.431f,
                                                               .wide = 0.3496f,
                                                               .wide_noise = -0.0802f,
                                                               .wide_texture = 0.2637f,
                                                               .alone = 0.f};

namespace detail {
/// Where a number of samples lies between 1 and 16: 0 to 1.
inline float between_1_and_16(float samples) { return std::clamp(std::log2(std::max(samples, 1.f)) / 4.f, 0.f, 1.f); }
} // namespace detail

inline ResidualFeedbackShares ResidualFeedbackShares::of_samples(float samples) {
    float const t = detail::between_1_and_16(samples);
    auto shares = feedback_of_1_sample;
    for (auto const& [name, share] : feedback_shares) shares.*share += (feedback_of_16_samples.*share - shares.*share) * t;
    return shares;
}

inline ResidualFeedbackShares ResidualFeedbackShares::beside_history(float samples) {
    auto shares = of_samples(samples);
    for (auto const& [name, share] : feedback_shares) shares.*share *= detail::between_1_and_16(samples);
    return shares;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
