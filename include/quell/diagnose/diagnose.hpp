#pragma once

// Opt-in: finds mistakes of a host that integrates quell. Needs the same libraries as quell.hpp.

#include <quell/diagnose/hypotheses/camera/matrices.hpp>
#include <quell/diagnose/hypotheses/camera/wrong_geometry.hpp>
#include <quell/diagnose/hypotheses/guides/albedo_hypotheses.hpp>
#include <quell/diagnose/hypotheses/guides/depth_hypotheses.hpp>
#include <quell/diagnose/hypotheses/guides/normal_hypotheses.hpp>
#include <quell/diagnose/hypotheses/guides/position_hypotheses.hpp>
#include <quell/diagnose/hypotheses/motion/cuts.hpp>
#include <quell/diagnose/hypotheses/motion/forgotten_motion.hpp>
#include <quell/diagnose/hypotheses/motion/geometry_by_motion.hpp>
#include <quell/diagnose/hypotheses/motion/motion_behind.hpp>
#include <quell/diagnose/hypotheses/motion/motion_by_blocks.hpp>
#include <quell/diagnose/hypotheses/motion/motion_by_history.hpp>
#include <quell/diagnose/hypotheses/motion/motion_disagreement.hpp>
#include <quell/diagnose/hypotheses/motion/motion_offsets.hpp>
#include <quell/diagnose/hypotheses/motion/motion_scale.hpp>
#include <quell/diagnose/hypotheses/motion/scale_by_history.hpp>
#include <quell/diagnose/hypotheses/motion/sweep_hypotheses.hpp>
#include <quell/diagnose/hypotheses/samples/history_hypotheses.hpp>
#include <quell/diagnose/hypotheses/samples/repeated_noise.hpp>
#include <quell/diagnose/hypotheses/samples/sample_hypotheses.hpp>
#include <quell/diagnose/hypotheses/samples/signal_hypotheses.hpp>
#include <quell/diagnose/inspect.hpp>
#include <quell/diagnose/not_checked.hpp>
#include <quell/pipeline/graph/check_frame.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A moving camera tells best what motion must be. Exact causes come first, since one mistake has many symptoms.
inline void find_by_moving_camera(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    auto const before = findings.size();
    auto const found = [&] { return findings.size() > before; };
    find_zero_motion(pairs, findings);
    if (!found()) find_motion_convention(seen, pairs, findings);
    if (!found()) find_motion_scale(pairs, findings);
    if (!found()) find_disagreement(seen, pairs, findings);
}

/// Without known cameras, motion is judged as of a static camera, then by the history.
inline void find_motion_mistakes(Observation const& seen, GeometryIs geometry, bool cameras, bool shift_is_known,
                                 std::vector<Finding>& findings) {
    auto const before = findings.size();
    std::vector<Finding> by_blocks;
    if (!cameras) find_motion_by_blocks(seen, seen.notes().blocks, seen.has_then, by_blocks);
    auto const pairs = cameras ? motion_pairs(seen, seen.camera, seen.camera_then) : still_pairs(seen);
    auto const moved = cameras ? moving(pairs) : ComparedMotions{};
    bool const moves = moved.size() >= fewest_pairs;
    if (find_scattered_motion(seen, findings)) return;
    if (cameras && seen.depth_then && find_motion_behind(seen, seen.camera, seen.camera_then, findings)) return;
    if (pairs.size() < fewest_pairs || (shift_is_known && find_motion_jitter(seen, pairs, findings))) return;
    if (geometry == GeometryIs::right && find_motion_offset(seen, pairs, moves, findings)) return;
    std::vector<GeometryMistake> as_good;
    if (moves && find_geometry_by_motion(seen, moved, geometry == GeometryIs::right, findings, as_good)) return;
    if (moves) find_by_moving_camera(seen, moved, findings);
    for (auto i = before; i < findings.size(); ++i) add_alternatives(findings[i], as_good);
    // Without cameras the guides tell.
    for (auto& finding : by_blocks) findings.push_back(std::move(finding));
    if (!moves && findings.size() == before && seen.depth_then) find_motion_convention_by_history(seen, findings);
    if (findings.size() > before || !seen.depth_then) return;
    // Depth of a floor stays the same under a camera that turns around. What moves all by the same is rather an offset.
    bool const differs = cameras && !moves && CommonOffset(pairs).sharing.share() < 0.5;
    if (differs && find_still_camera(seen, findings)) return;
    if (cameras && !moves) find_scale_by_history(seen, findings);
    if (findings.size() > before) return;
    if (cameras) find_forgotten_motion(seen, seen.camera, seen.camera_then, findings);
}

/// Mistakes that take two frames to see.
inline void find_mistakes_over_time(Observation seen, GeometryIs geometry, bool camera_is_wrong, std::vector<Finding>& findings) {
    bool const jittered = !camera_is_wrong && find_projection_jitter(seen, findings);
    // Judge motion without the jitter.
    if (jittered) seen.camera_then.projection = seen.camera.projection;
    bool const cameras = !camera_is_wrong && known(seen.camera) && known(seen.camera_then);
    if (cameras && geometry == GeometryIs::unknown && find_still_camera(seen, findings)) return;
    if (seen.motion) find_motion_mistakes(seen, geometry, cameras, shift_of(seen) == glm::vec2(0.f), findings);
    if (seen.sweep && cameras) find_wrong_sweeps(seen, findings);
}

/// A depth buffer whose sky is at its end. Where noise hides that it is one, the camera and normals tell, before its sky is called wrong.
inline bool find_depth_buffer(Observation const& seen, std::vector<Finding>& findings) {
    auto const sky = seen.depth && seen.normal && known(seen.camera) ? sky_of_buffer(seen) : std::nullopt;
    if (!sky) return false;
    auto const masked = without_depth(seen, *sky);
    Geometry const own{.now = seen.camera, .then = seen.camera, .scattered = is_scattered(masked)};
    auto const winners = winners_of(masked, own, mistakes_of_linearity(own));
    if (winners.empty() || Misfit(masked, own, 1).is_small()) return false;
    findings.push_back(finding_of(masked, winners));
    return true;
}

/// Depth first, then the camera: later tests build on them.
inline void find_guide_mistakes(Observation seen, std::vector<Finding>& findings) {
    if (seen.albedo) find_albedo_range(seen, findings);
    bool const camera_is_wrong = find_wrong_matrices(seen, findings);
    bool const is_buffer = !camera_is_wrong && find_depth_buffer(seen, findings);
    bool const depth_is_wrong = is_buffer || (seen.depth && find_wrong_depth(seen, findings));
    if (seen.depth && !depth_is_wrong)
        if (auto const sky = find_finite_sky(seen, findings)) seen = without_depth(std::move(seen), *sky);
    bool const length_is_wrong = seen.normal && find_normal_length(seen, depth_is_wrong, findings);
    if (!seen.depth || depth_is_wrong) return;
    auto with_good_normals = seen;
    if (length_is_wrong) with_good_normals.normal = {};
    auto const geometry = camera_is_wrong ? GeometryIs::unknown : find_wrong_geometry(with_good_normals, findings);
    if (geometry == GeometryIs::wrong) return;
    if ((seen.motion || seen.sweep) && seen.has_then) find_mistakes_over_time(seen, geometry, camera_is_wrong, findings);
}

/// What the signals show together with guides, where these are right.
inline void find_signal_mistakes(Observation const& seen, std::vector<Finding>& findings) {
    auto const said = [&](auto... mistakes) {
        return std::ranges::any_of(findings, [&](Finding const& f) { return ((f.mistake == mistakes) || ...); });
    };
    bool const same = said(Mistake::identical_frames);
    bool const guides_are_wrong = said(Mistake::albedo_black, Mistake::albedo_above_one, Mistake::guides_behind, Mistake::normal_packed,
                                       Mistake::normal_not_unit, Mistake::depth_not_positive, Mistake::depth_not_linear);
    for (auto const& signal : seen.of_signals) {
        // A signal that is an older frame's follows no albedo of this one.
        if (!guides_are_wrong && !same) find_signal_mistakes(seen, signal, findings);
        // What a wrong albedo leaves of a texture looks like noise, which may stay on the screen.
        bool const misplaced = said(Mistake::signal_upside_down, Mistake::signal_behind, Mistake::guides_behind);
        if (!same && !misplaced) find_repeated_noise(seen, signal, findings);
    }
}

/// Whether a finding says already that the camera is no use.
inline bool camera_was_said(std::vector<Finding> const& findings) {
    return std::ranges::any_of(findings, [](Finding const& f) {
        return f.mistake == Mistake::projection_transposed || f.mistake == Mistake::view_transposed ||
               f.mistake == Mistake::matrices_swapped || f.mistake == Mistake::camera_faces_backwards;
    });
}

inline std::vector<Finding> findings_of(Observation seen) {
    std::vector<Finding> findings;
    if (find_cut(seen, findings)) seen = without_past(std::move(seen));
    find_resets(seen, findings);
    find_sample_mistakes(seen, findings);
    find_zero_positions(seen, findings), find_zero_hits(seen, findings);
    find_guide_mistakes(seen, findings);
    find_signal_mistakes(seen, findings);
    find_output_mistakes(seen, findings);
    if (!camera_was_said(findings)) say_what_is_not_checked(seen, findings);
    seen.notes().camera_before = seen.has_then ? std::optional(seen.camera_then) : std::nullopt;
    return findings;
}
/// What diagnose() finds in what a function observes; also what that function throws, as a finding.
template <class Observe>
std::vector<Finding> diagnosed(Observe const& observed, std::optional<MotionConvention> const& converted_from,
                               std::function<float(int c, int x, int y)> factor) {
    auto const findings = [&] {
        Observation seen = observed();
        if (converted_from) seen.convention = *converted_from;
        seen.factor = std::move(factor);
        return findings_of(std::move(seen));
    };
#if defined(__cpp_exceptions)
    try {
        return findings();
    } catch (Error const& error) {
        return {{Mistake::frame_refused, error.subject + ": " + error.found, error.remedy}};
    } catch (std::exception const& error) {
        return {{Mistake::not_checked, std::string("this frame, since there was an error: ") + error.what(), "look at the host's images"}};
    }
#else
    return findings();
#endif
}
} // namespace detail

/// Finds mistakes of the host in this frame, its past and their cameras. Empty where all is well and where there is no evidence: a static
/// camera says little about motion. One finding of a history, Mistake::not_checked, says what there was too little to check. Call it right
/// before run(), in debug builds every frame:
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
/// @param factor for hosts that divide the signal by albedo themselves and multiply the output by it: that albedo, of which it returns
/// component c at pixel (x, y)
/// No exception leaves it: a frame that run() would refuse is a finding. Where exceptions are off, the ErrorHandler is called as by run().
template <class P, class Set, class FrameStorage, class Storage>
[[nodiscard]] std::vector<Finding> diagnose(Frame<Set, FrameStorage> const& frame, History<P, Storage>& history,
                                            std::optional<MotionConvention> converted_from = {},
                                            std::function<float(int c, int x, int y)> factor = {}) {
    static_assert(
        contained_in<typename P::reads, Set>,
        "diagnose(frame, history): the frame lacks a channel that the history's pipeline reads; construct the frame with this pipeline");
    auto const observed = [&] {
        detail::check_frame<P>(frame);
        return detail::observe<P>(frame, history);
    };
    return detail::diagnosed(observed, converted_from, std::move(factor));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
