#pragma once

#include <quell/link/evidence/by_evidence.hpp>

/// Opt-in: not in quell.hpp.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// A preset with its history and without, put together by what each frame's own samples speak for:
/// `presets::by_evidence(presets::general(radiance, Demodulate{}))`.
/// @param pipeline a Pipeline with a Temporal
/// @param rule     how samples are judged
template <class P> constexpr auto by_evidence(P const& pipeline, Evidence const& rule = {}) { return ByEvidence<P>{pipeline, rule}; }

/// The same with another judge, which takes less time:
/// `presets::by_evidence(presets::final_frame(radiance, Demodulate{}), presets::general(radiance, Demodulate{}))`.
/// @param pipeline a Pipeline with a Temporal
/// @param judge    one of the same signal that keeps and remembers no channel beside the pipeline's
/// @param rule     how samples are judged
template <class P, class Judge>
    requires detail::is_pipeline<Judge>
constexpr auto by_evidence(P const& pipeline, Judge const& judge, Evidence const& rule = {}) {
    return ByEvidence<P, Judge>{pipeline, judge, rule};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
