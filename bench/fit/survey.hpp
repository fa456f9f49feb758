#pragma once

#include "parts.hpp"
#include "sequence.hpp"

#include <array>

namespace quell::bench {

/// What a sequence shows of the effects, by its channels alone. Parts of all pixels of all frames but the first.
struct Traces {
    double shadowed = 0, shadow_moves = 0;       ///< the light sample is blocked; and receiver, blocker or light moves
    double reflecting = 0, reflection_moves = 0; ///< there is a reflection; and the surface moves in the image, or what it reflects moves
    double lit_indirectly = 0, uncovered = 0;    ///< there is indirect light; it shows what was hidden or outside a frame ago
    double swept = 0;                            ///< moves by more than half a pixel while the shutter is open
};

/// Whether an effect is worth looking at, and why.
struct Verdict {
    bool present = true; ///< false: nothing is lost where it is left out
    bool moves = true;   ///< false: methods that follow it have nothing to follow
    std::string evidence;
    bool splits = true; ///< false: it can't be denoised by itself, since its samples are of different times
};

/// Looks at a sequence once.
class Survey {
public:
    explicit Survey(FitSequence& sequence);

    [[nodiscard]] Verdict const& operator[](Part effect) const { return verdicts[static_cast<std::size_t>(effect)]; }
    /// Whether there is motion blur to be made of samples of different times.
    [[nodiscard]] Verdict const& blur() const { return blur_verdict; }

private:
    std::array<Verdict, effects.size()> verdicts;
    Verdict blur_verdict;

    Survey(Traces const& traces, std::set<std::string> const& channels);
};

namespace detail {
/// From what was counted, where `channels` were there to look at.
[[nodiscard]] std::array<Verdict, effects.size()> verdicts_on(Traces const& traces, std::set<std::string> const& channels);
[[nodiscard]] Verdict verdict_on_blur(Traces const& traces, std::set<std::string> const& channels);
} // namespace detail

} // namespace quell::bench
