#pragma once

#include <denoise/denoiser.hpp>

namespace quell::examples {

/// A signal's light, and what it is by its frame alone.
struct ChosenLight {
    metrics::Picture light, alone;
};

/// Puts a signal's light together from two estimates, with history and without, by what samples speak for that neither has used (Evidence).
/// The samples are judged by general's estimates, which take less time than final-frame's.
class HistoryChoice {
public:
    /// @param preset  whose estimates are put together
    /// @param threads 0: all that there are
    HistoryChoice(Preset const& preset, Purpose purpose, Extent size, int threads);

    /// What is best of the frame that was denoised last.
    /// @param with         what denoised it
    /// @param before       what that remembered before
    /// @param with_history what came out
    [[nodiscard]] ChosenLight choose(Denoiser const& with, io::ExrImage const& image, io::ChannelNames const& names, long long number,
                                     HistoryContents const& before, metrics::Picture const& with_history);

    void release_scratch() { alone.release_scratch(), judge.release_scratch(); }
    [[nodiscard]] double bytes_per_pixel() const { return alone.bytes_per_pixel() + judge.bytes_per_pixel(); }
    [[nodiscard]] double milliseconds() const { return alone.milliseconds() + judge.milliseconds(); }

private:
    Denoiser alone, judge;
};

} // namespace quell::examples
