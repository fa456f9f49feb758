#pragma once

#include <quell/link/residual/repeated_residual.hpp>
#include <quell/link/residual/residual_feedback.hpp>
#include <quell/pipeline/chain.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A link that gives back to each picture the light that the denoiser before took out by mistake: by ResidualFeedback, and of what is still
/// lacking then by RepeatedResidual. A picture that is as its samples stays as it is.
///
///     constexpr auto denoise = Chain{presets::general(radiance), light_given_back(radiance, 16)};
///
/// It stands behind a denoiser of one signal of three components, before what puts pictures together from several frames or enlarges them.
/// Frames have the samples, normal, depth and motion.
/// @param is_judged whether samples chose, for each pixel, between the picture with history and one without
/// @param samples   the number of samples of each pixel; where that is not known, 1
template <ChannelTag Samples> constexpr auto light_given_back(Samples, float samples, bool is_judged = false) {
    return Pipeline{denoised, Spatial{ResidualFeedback<Samples>{.samples = samples, .is_judged = is_judged}},
                    Spatial{RepeatedResidual<Samples>{.samples = samples}}};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
