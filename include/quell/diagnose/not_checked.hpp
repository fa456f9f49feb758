#pragma once

#include <quell/diagnose/hypotheses/static_motion.hpp>
#include <quell/diagnose/observation.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Says once, as soon as there is a past, what the frame gives too little to check.
inline void say_what_is_not_checked(Observation const& seen, std::vector<Finding>& findings) {
    bool const has_past = std::ranges::any_of(seen.of_signals, &SignalSeen::has_past);
    auto& notes = seen.notes();
    if (notes.said_what_is_not_checked || (has_past && !seen.has_then)) return;
    notes.said_what_is_not_checked = true;
    if (!seen.motion && !seen.normal && !seen.depth) return;
    if (!seen.depth)
        findings.push_back({Mistake::not_checked, "the pipeline reads no depth: motion, normals and frame.camera were not compared with it",
                            "a pipeline that reads depth finds more"});
    else if (seen.camera == Camera{})
        findings.push_back({Mistake::not_checked, std::string(camera_is_not_set) + ": motion, depth and normals were not compared with it",
                            "set it, also for a pipeline that needs none"});
    else if (!known(seen.camera))
        findings.push_back(
            {Mistake::not_checked,
             "frame.camera is not a perspective camera that looks down -z: motion, depth and normals were not compared with it",
             "only perspective cameras are checked"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
