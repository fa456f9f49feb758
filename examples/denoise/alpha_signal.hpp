#pragma once

#include <denoise/denoiser.hpp>
#include <denoise/seen_frame.hpp>

#include <memory>
#include <vector>

namespace quell::examples {

/// What denoises alpha as a signal of its own, in films that a preset denoises: the preset itself where it tells noise from change, else
/// general, by each frame alone. Shadows move over catchers that stand still, and others would leave them behind. Null where general is
/// not compiled.
[[nodiscard]] Preset const* preset_of_alpha(Preset const& preset);

/// Alpha of a transparent film where no light speaks for it: denoised as a signal of its own, by a filter whose weights go by guides and
/// by alpha's own noise. Elsewhere alpha goes with the light (LightSplit).
class AlphaSignal {
    std::unique_ptr<Denoiser> denoiser; ///< null before it was wanted
    bool remembers = true;              ///< whether earlier frames have a part in it
    std::vector<float> carried;         ///< by light in the last frame

public:
    /// Shows it a frame of the window, in order.
    void look_ahead(Preset const& preset, Extent size, int threads, SeenFrame& seen, LightSplit const& split);
    /// Alpha of a frame: what light carries, and beside it what is a signal of its own.
    /// @param with_light what light carries, as it was denoised
    /// @param given      the file's, which limits what filters make of it
    [[nodiscard]] std::vector<float> complete(std::vector<float> with_light, std::vector<float> const& given, SeenFrame const& seen,
                                              LightSplit const& split);
    /// What light carried of the last frame's alpha; empty before there was one.
    [[nodiscard]] std::vector<float> const& with_light() const { return carried; }

    /// Drops the frames that it was shown and has not denoised.
    void drop_ahead() {
        if (denoiser) denoiser->drop_ahead();
    }
    void release_scratch() {
        if (denoiser) denoiser->release_scratch();
    }
    void forget() { denoiser.reset(), carried.clear(); }
    [[nodiscard]] double milliseconds() const { return denoiser ? denoiser->milliseconds() : 0.; }
    [[nodiscard]] double bytes_per_pixel() const {
        return denoiser ? denoiser->bytes_per_pixel() + static_cast<double>(sizeof(float)) : 0.;
    }
};

} // namespace quell::examples
