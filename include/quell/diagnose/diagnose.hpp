#pragma once

// Opt-in: finds mistakes of a host that integrates quell. Needs the same libraries as quell.hpp.

#include <quell/diagnose/hypotheses/albedo_hypotheses.hpp>
#include <quell/diagnose/hypotheses/camera_hypotheses.hpp>
#include <quell/diagnose/hypotheses/depth_hypotheses.hpp>
#include <quell/diagnose/hypotheses/history_hypotheses.hpp>
#include <quell/diagnose/hypotheses/motion_by_history.hpp>
#include <quell/diagnose/hypotheses/motion_disagreement.hpp>
#include <quell/diagnose/hypotheses/normal_hypotheses.hpp>
#include <quell/diagnose/hypotheses/sample_hypotheses.hpp>
#include <quell/diagnose/hypotheses/sweep_hypotheses.hpp>
#include <quell/diagnose/inspect.hpp>
#include <quell/pipeline/execution/check_frame.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A moving camera tells best what motion must be. Exact causes come first, since one mistake has many symptoms.
inline void find_by_moving_camera(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    auto const before = findings.size();
    find_zero_motion(pairs, findings);
    if (findings.size() == before && !find_inverted_view(seen, pairs, findings) && !find_camera_upside_down(seen, pairs, findings))
        find_motion_convention(seen, pairs, findings);
    if (findings.size() == before) find_disagreement(seen, pairs, findings);
}

/// Without known cameras, motion is judged as of a static camera, then by the history.
inline void find_motion_mistakes(Observation const& seen, bool cameras, bool shift_is_known, std::vector<Finding>& findings) {
    auto const pairs = cameras ? motion_pairs(seen, seen.camera, seen.camera_then) : still_pairs(seen);
    if (pairs.size() < fewest_pairs || (shift_is_known && find_motion_jitter(seen, pairs, findings))) return;
    if (cameras) find_still_camera(seen, pairs, findings);
    if (auto const moved = moving(pairs); cameras && moved.size() >= fewest_pairs)
        find_by_moving_camera(seen, moved, findings);
    else if (seen.depth_then)
        find_motion_convention_by_history(seen, findings);
}

/// Mistakes that take two frames to see.
inline void find_mistakes_over_time(Observation seen, bool camera_is_wrong, std::vector<Finding>& findings) {
    bool const jittered = !camera_is_wrong && find_projection_jitter(seen, findings);
    // Judge motion without the jitter.
    if (jittered) seen.camera_then.projection = seen.camera.projection;
    bool const cameras = !camera_is_wrong && known(seen.camera) && known(seen.camera_then);
    if (seen.motion) find_motion_mistakes(seen, cameras, shift_of(seen) == glm::vec2(0.f), findings);
    if (seen.sweep && cameras) find_wrong_sweeps(seen, findings);
}

/// Depth first, then the camera: later tests build on them.
inline void find_guide_mistakes(Observation const& seen, std::vector<Finding>& findings) {
    if (seen.albedo) find_albedo_range(seen, findings);
    bool camera_is_wrong = find_wrong_matrices(seen, findings);
    bool const depth_is_wrong = seen.depth && find_wrong_depth(seen, findings);
    bool const length_is_wrong = seen.normal && find_normal_length(seen, findings);
    if (!seen.depth || depth_is_wrong) return;
    if (seen.normal && !length_is_wrong && !camera_is_wrong && known(seen.camera)) camera_is_wrong = find_normal_space(seen, findings);
    if ((seen.motion || seen.sweep) && seen.has_then) find_mistakes_over_time(seen, camera_is_wrong, findings);
}

inline std::vector<Finding> findings_of(Observation const& seen) {
    std::vector<Finding> findings;
    find_resets(seen, findings);
    find_sample_mistakes(seen, findings);
    find_guide_mistakes(seen, findings);
    find_output_mistakes(seen, findings);
    return findings;
}
} // namespace detail

/// Finds mistakes of the host in this frame, its past and their cameras. Empty where all is well and where there is no evidence: a static
/// camera says little about motion. Call it right before run(), in debug builds every frame:
///
///     for (auto const& finding : diagnose(frame, history)) log(to_string(finding));
///     run(denoise, frame, history);
///
/// It reads the pipeline's channels at up to 16,384 pixels; only bad samples are counted at all pixels. It keeps notes in the history for
/// mistakes that only show over several calls. For Pipeline and Composite, any storage. Whether the output equals the input is not checked
/// after run_into(), whose output the host owns, nor for motion blur. Perspective cameras only. Objects may move, if about a quarter of the
/// picture does not.
/// @param frame the frame that run() gets next
/// @param history the history that run() gets next; it also keeps the notes
/// @param converted_from for hosts that convert motion vectors before they write them: the convention from which, so that the finding names
/// the mistake in its terms. Not needed with Supplied<>.
/// @throws Error as run() does for a frame that it could not use
template <class P, class Set, class FrameStorage, class Storage>
[[nodiscard]] std::vector<Finding> diagnose(Frame<Set, FrameStorage> const& frame, History<P, Storage>& history,
                                            std::optional<MotionConvention> converted_from = {}) {
    static_assert(
        contained_in<typename P::reads, Set>,
        "diagnose(frame, history): the frame lacks a channel that the history's pipeline reads; construct the frame with this pipeline");
    detail::check_frame<P>(frame);
    auto seen = detail::observe<P>(frame, history);
    if (converted_from) seen.convention = *converted_from;
    return detail::findings_of(seen);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
