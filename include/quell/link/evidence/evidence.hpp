#pragma once

#include <quell/core/logarithm.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Chooses between two estimates of a picture by samples that neither has used: the part of the first that brings the sum of both nearest
/// to what is true, without bias whatever the noise is. Let I be the samples, A and B the estimates. Over a window of 25x25 pixels, the
/// part is
///
///     w = sum (I - B)(A - B) / sum (A - B)^2
///
/// limited to [0, 1]: the least squares of I - B by A - B. Terms are divided by the square of the luminance of A and B, so that dark and
/// bright count alike, and samples are limited to a multiple of it. Samples are held out by a checkerboard: A and B are made once without
/// the even pixels, and once without the odd ones, or only without the even ones.
///
/// What is chosen for are estimates that do use a pixel's own sample, and have a part of its noise. In A, which has many samples, that is
/// little. In B it is d, what the sample changes of B. Where samples are noisy, sum d^2 is added above and below: it is the error that
/// comes with 1 - w.
///
/// Where samples speak against A, as they do where light moves that A remembers, caution would keep a part of it. `doubt` lessens caution
/// there: it counts 1 - doubt (1 - v) of what it does, where v is the part of A without caution.
///
/// The part's own variance, n / (sum (A - B)^2)^2 with n = sum ((I - (A + B) / 2)(A - B))^2, says how far it is to be trusted over what was
/// taken before any sample was seen: a normal distribution about `at_first`.
struct Evidence {
    float dark = 0.02f;      ///< part of the picture's mean luminance that is added to the luminance that terms are divided by
    float most = 20.f;       ///< samples are at most so many times that luminance
    float caution = 2.f;     ///< how often sum d^2 counts, at least 0
    float at_first = 1.f;    ///< the part where nothing is known
    float spread = 1.f;      ///< standard deviation of the part about that, before samples are seen; above 0
    float doubt = 0.f;       ///< how much less caution counts where samples leave nothing of A: from 0, the same, to 1, not at all
    bool both_halves = true; ///< whether both halves of the checkerboard are held out: one takes two runs less, and knows less

    /// For frames of so many samples of each pixel, of which caution depends: 2 at 1 sample, 0 from 16 on. Files may tell of more samples
    /// than were taken. From 2 samples on, one half of the checkerboard says enough.
    /// @param samples of each pixel; less than 1 counts as 1
    [[nodiscard]] static constexpr Evidence of_samples(float samples) {
        return {.caution = max(2.f - 0.5f * octaves_of(samples), 0.f), .both_halves = wants_both_halves(samples)};
    }
    /// For a history that has seen later frames too, and deserves more trust: caution is 2 up to 32 samples, with a doubt that goes up to 1
    /// at 16; from then on it falls, to 0.75 at 64 samples and 0 from 97 on. One half is enough as there.
    /// @param samples of each pixel; less than 1 counts as 1
    [[nodiscard]] static constexpr Evidence with_later_frames(float samples) {
        float const octaves = octaves_of(samples), beyond = max(octaves - 5.f, 0.f);
        return {.caution = max(2.f - 1.25f * beyond, 0.f), .doubt = min(.25f * octaves, 1.f), .both_halves = wants_both_halves(samples)};
    }

private:
    static constexpr bool wants_both_halves(float samples) { return samples < 2.f; }
    static constexpr float octaves_of(float samples) { return detail::logarithm(max(samples, 1.f)) * 1.44269504f; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
