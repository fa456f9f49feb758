#pragma once

// Opt-in: what a host that integrates quell gets wrong, in words. Needs no more than quell.hpp does.

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

namespace quell {

namespace detail {
/// Cameras that move say best what motion must be; the exact cause first, since one mistake explains many symptoms.
inline void find_by_moving_camera(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    auto const before = findings.size();
    find_zero_motion(pairs, findings);
    if (findings.size() == before && !find_inverted_view(seen, pairs, findings) && !find_camera_upside_down(seen, pairs, findings))
        find_motion_convention(seen, pairs, findings);
    if (findings.size() == before) find_disagreement(seen, pairs, findings);
}

/// What is expected, with what is known of the cameras: of one that is not known nothing is, or that it stands still.
inline void find_motion_mistakes(Observation const& seen, bool cameras, bool shift_is_known, std::vector<Finding>& findings) {
    auto const pairs = cameras ? motion_pairs(seen, seen.camera, seen.camera_then) : still_pairs(seen);
    if (pairs.size() < fewest_pairs || (shift_is_known && find_motion_jitter(seen, pairs, findings))) return;
    if (cameras) find_still_camera(seen, pairs, findings);
    if (auto const moved = moving(pairs); cameras && moved.size() >= fewest_pairs)
        find_by_moving_camera(seen, moved, findings);
    else if (seen.depth_then)
        find_motion_convention_by_history(seen, findings);
}

/// What takes two cameras.
inline void find_mistakes_over_time(Observation seen, bool camera_is_wrong, std::vector<Finding>& findings) {
    bool const jittered = !camera_is_wrong && find_projection_jitter(seen, findings);
    // Motion is then judged without it.
    if (jittered) seen.camera_then.projection = seen.camera.projection;
    bool const cameras = !camera_is_wrong && known(seen.camera) && known(seen.camera_then);
    if (seen.motion) find_motion_mistakes(seen, cameras, shift_of(seen) == glm::vec2(0.f), findings);
    if (seen.sweep && cameras) find_wrong_sweeps(seen, findings);
}

/// Whether depth is wrong is known before anything is built on it, and so on for the camera.
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

/// What the host of a pipeline gets wrong, as far as this frame, the one before it, and their cameras show: nothing where all is well, and
/// nothing where there is no evidence (a still camera says little about motion). Call it right before run(), in debug builds every frame:
///     for (auto const& finding : diagnose(frame, history)) log(to_string(finding));
///     run(denoise, frame, history);
/// It looks at the channels that the pipeline reads, at some 16,000 of their pixels (at all of them for samples that are not finite), and
/// keeps notes in the history, so that it also sees what only several calls show. For Pipeline and Composite, any storage.
/// Whether the output is the input is not asked after run_into(), whose output the host keeps, nor of motion blur.
/// Perspective cameras only; objects may move, as long as some quarter of the picture does not.
/// @param converted_from for hosts that convert their motion vectors before they put them into the frame: the convention from which, so
///                       that the mistake is named in its terms. Pipelines with Supplied<> need no mention.
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

} // namespace quell
