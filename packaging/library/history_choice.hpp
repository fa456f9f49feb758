#pragma once

#include "compiled_preset.hpp"

#include <quell/link/evidence/evidence.hpp>

namespace quell_library {

/// Whether a compiled preset can be put together of what its history and what the frame alone make of it: it must have one history, and a
/// colour, with alpha or without, or one component.
[[nodiscard]] bool can_choose_history(Way const& way);

/// The preset whose estimates are judged in the place of another's: general for final-frame, whose history it can go on from in less time;
/// for others, and where it is not compiled, the preset itself.
[[nodiscard]] CompiledPreset const& judge_of(CompiledPreset const& preset);

/// What is done then: a sentence before the preset's plan.
/// @param way   of the preset
/// @param judge of its judge; the same one where it judges itself
[[nodiscard]] std::string plan_of_choice(Way const& way, Way const& judge);

/// Puts what a preset makes with its history, and without, together by what samples speak for that neither has used (quell::ByEvidence).
/// Several denoisers of one way may have it in turn. It is compiled for numbers of components, and not for each preset.
class HistoryChoice {
public:
    HistoryChoice() = default;
    HistoryChoice(HistoryChoice const&) = delete;
    HistoryChoice& operator=(HistoryChoice const&) = delete;
    virtual ~HistoryChoice() = default;

    /// Denoises the first frame of a window, which then is its past.
    /// @param denoiser made by the way
    /// @param window   as for CompiledDenoiser::run(): with its history, the frame is denoised with those after it
    /// @param output   written
    /// @throws quell::Error as CompiledDenoiser::run() does
    virtual void run(CompiledDenoiser& denoiser, std::span<FrameImages const> window, Image const& output) = 0;
    /// Copies what the frame alone made of the last one. Returns false where there was nothing to choose, as it had no past.
    /// @param output written; of the frame's size
    virtual bool copy_alone(Image const& output) = 0;
    /// Copies what the last one is with its whole history, in the same way.
    virtual bool copy_with_history(Image const& output) = 0;
    /// How far samples of the last one were believed: 1, and less where pixels share their noise.
    [[nodiscard]] virtual float trust() const = 0;
    /// How many samples pixels of the frames that follow have: 1, if nothing is said. A history that has seen later frames is judged by
    /// Evidence::with_later_frames(), another one by Evidence::of_samples().
    virtual void tell_samples(float count) = 0;
    /// Gives its memory back, which the next frame takes again.
    virtual void release_scratch() = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};
/// @param way   one that can_choose_history()
/// @param judge the judge's way of the same purpose; the same one where the preset judges itself
/// @throws quell::Error, std::bad_alloc
[[nodiscard]] std::unique_ptr<HistoryChoice> make_history_choice(Way const& way, Way const& judge, quell::Extent size,
                                                                 Parallel const& parallel, Memory const& memory);

/// A compiled denoiser with that.
/// @param denoiser made by the way
[[nodiscard]] std::unique_ptr<CompiledDenoiser> with_history_choice(std::unique_ptr<CompiledDenoiser> denoiser,
                                                                    std::unique_ptr<HistoryChoice> choice);

} // namespace quell_library
