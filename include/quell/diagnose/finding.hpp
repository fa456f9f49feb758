#pragma once

#include <quell/core/instruction_set.hpp>

#include <string>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Mistakes of hosts that show in a frame and its past. name_of() says each in words.
enum class Mistake {
    motion_sign,
    motion_unit,
    motion_y,
    motion_zero,
    motion_jitter,
    motion_disagrees,
    sweep_sign,
    shutter_differs,
    projection_jitter,
    projection_transposed,
    view_transposed,
    view_inverted,
    matrices_swapped,
    camera_faces_backwards,
    camera_upside_down,
    camera_never_moves,
    depth_says_nothing,
    depth_of_misses,
    depth_not_positive,
    depth_not_linear,
    normal_packed,
    normal_not_unit,
    normal_in_view_space,
    albedo_above_one,
    albedo_black,
    bad_samples,
    bad_guides,
    identical_frames,
    resets_every_frame,
    output_is_input,
};

/// A few words for reports.
[[nodiscard]] constexpr std::string_view name_of(Mistake mistake) {
    constexpr std::string_view names[] = {
        "motion points the wrong way",
        "motion is in another unit",
        "motion's y points the other way",
        "motion is zero although the camera moves",
        "motion has the jitter in it",
        "motion, cameras and depth disagree",
        "sweeps point the wrong way",
        "frame.shutter is not what sweeps last",
        "camera.projection has the jitter in it",
        "camera.projection is transposed",
        "camera.view is transposed",
        "camera.view is the camera's pose and not its inverse",
        "camera.view and camera.projection are swapped",
        "camera.projection looks down +z",
        "camera.projection has y down",
        "frame.camera stays the same although everything moves",
        "depth says nothing",
        "depth is finite where there is no surface",
        "depth is not positive",
        "depth is not linear",
        "normals are packed into [0, 1]",
        "normals are not of unit length",
        "normals are in view space",
        "albedo is above 1",
        "albedo is black",
        "samples are not finite or negative",
        "guides are not finite",
        "the signal is the same in every frame",
        "history starts afresh in every frame",
        "the output is the input",
    };
    return names[static_cast<int>(mistake)];
}

/// A mistake that diagnose() found.
struct Finding {
    Mistake mistake;      ///< its kind
    std::string evidence; ///< what was measured
    std::string remedy;   ///< what to change in the host
};

/// One line for a log.
[[nodiscard]] inline std::string to_string(Finding const& finding) {
    return std::string(name_of(finding.mistake)) + ": " + finding.evidence + "; " + finding.remedy;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
