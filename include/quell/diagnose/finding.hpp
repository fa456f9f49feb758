#pragma once

#include <quell/core/instruction_set.hpp>

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Mistakes of hosts that show in a frame and its past. The last is none: it says what could not be checked. name_of() says each in words.
enum class Mistake {
    cut,
    motion_sign,
    motion_unit,
    motion_y,
    motion_zero,
    motion_jitter,
    motion_disagrees,
    motion_offset,
    motion_scale,
    motion_forgotten,
    motion_behind,
    sweep_sign,
    sweep_y,
    shutter_differs,
    projection_jitter,
    projection_transposed,
    view_transposed,
    view_inverted,
    view_rotation_transposed,
    view_looks_backwards,
    view_mirrored,
    matrices_swapped,
    camera_faces_backwards,
    camera_upside_down,
    field_of_view,
    camera_never_moves,
    depth_says_nothing,
    depth_of_misses,
    depth_not_positive,
    depth_not_linear,
    depth_is_ray_length,
    depth_unit,
    normal_packed,
    normal_not_unit,
    normal_in_view_space,
    albedo_above_one,
    albedo_black,
    albedo_encoded,
    albedo_squared,
    guides_behind,
    bad_samples,
    bad_guides,
    positions_zero,
    hits_zero,
    signal_demodulated,
    signal_has_albedo,
    signal_encoded,
    signal_upside_down,
    signal_behind,
    identical_frames,
    seed_repeats,
    resets_every_frame,
    output_is_input,
    frame_refused,
    not_checked, ///< no mistake: what there was too little to go by
};

namespace detail {
/// Begins the evidence of what is not checked where the frame has no camera.
inline constexpr std::string_view camera_is_not_set = "frame.camera is not set";
/// In the order of Mistake.
inline constexpr std::string_view mistake_names[] = {
    "the picture is cut, and the history goes on",
    "motion points the wrong way",
    "motion is in another unit",
    "motion's y points the other way",
    "motion is zero although the camera moves",
    "motion has the jitter in it",
    "motion, cameras and depth disagree",
    "motion is beside the right place, by the same in every pixel and frame",
    "motion is too long or too short",
    "something that moves has no motion of its own",
    "motion is one frame behind",
    "sweeps point the wrong way",
    "the y of sweeps points the other way",
    "frame.shutter is not what sweeps last",
    "camera.projection has the jitter in it",
    "camera.projection is transposed",
    "camera.view is transposed",
    "camera.view is the camera's pose and not its inverse",
    "the rotation in camera.view is transposed",
    "camera.view looks down +z",
    "camera.view is mirrored",
    "camera.view and camera.projection are swapped",
    "camera.projection looks down +z",
    "rows start at the bottom, or camera.projection has y down",
    "camera.projection is not what the picture was made with",
    "frame.camera stays the same although everything moves",
    "depth says nothing",
    "depth is finite where there is no surface",
    "depth is not positive",
    "depth is not linear",
    "depth is the length of the ray",
    "depth is in another unit than positions",
    "normals are packed into [0, 1]",
    "normals are not of unit length",
    "normals are in view space",
    "albedo is above 1",
    "albedo is black",
    "albedo is not linear",
    "albedo is squared",
    "guides are one frame behind",
    "samples are not finite or negative",
    "guides are not finite",
    "positions are zero",
    "what a ray hit is zero where it hit nothing",
    "the signal is already divided by albedo",
    "the signal has the albedo in it already",
    "the signal is not linear",
    "the signal's rows are in the other order than those of the guides",
    "the signal is one frame behind",
    "the signal is the same in every frame",
    "the noise is the same in every frame",
    "history starts afresh in every frame",
    "the output is the input",
    "run() refuses the frame",
    "not checked",
};
static_assert(std::size(mistake_names) == static_cast<std::size_t>(Mistake::not_checked) + 1);
} // namespace detail

/// A few words for reports.
[[nodiscard]] constexpr std::string_view name_of(Mistake mistake) { return detail::mistake_names[static_cast<int>(mistake)]; }

/// A mistake that diagnose() found.
struct Finding {
    Mistake mistake;      ///< its kind
    std::string evidence; ///< what was measured
    std::string remedy;   ///< what to change in the host
    /// Further mistakes that the frame shows and that the same change mends.
    std::vector<Mistake> also{};
    /// Mistakes that it may be in place of the first: the frame does not tell them apart. The remedy has them too.
    std::vector<Mistake> or_else{};
};

/// One line for a log.
[[nodiscard]] inline std::string to_string(Finding const& finding) {
    std::string names(name_of(finding.mistake));
    for (auto const mistake : finding.also) names += ", and " + std::string(name_of(mistake));
    return names + ": " + finding.evidence + "; " + finding.remedy;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
