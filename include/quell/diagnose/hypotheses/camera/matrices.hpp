#pragma once

#include <quell/diagnose/hypotheses/static_motion.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <cmath>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

// The last row tells the kind of a matrix: (0, 0, -1, 0) perspective projection, (0, 0, 1, 0) one that looks down +z, (0, 0, 0, 1) view.
// m[0..3] are columns.

inline glm::vec4 last_row(glm::mat4 const& m) { return {m[0][3], m[1][3], m[2][3], m[3][3]}; }
inline bool nearly(glm::vec4 const& a, glm::vec4 const& b) { return glm::distance(a, b) < 1e-4f; }
inline bool faces_backwards(glm::mat4 const& m) { return nearly(last_row(m), {0, 0, 1, 0}); }
inline bool is_perspective(glm::mat4 const& m) { return nearly(last_row(m), {0, 0, -1, 0}) || faces_backwards(m); }
inline bool is_affine(glm::mat4 const& m) { return nearly(last_row(m), {0, 0, 0, 1}); }
inline std::string text_of(glm::vec4 const& v) {
    return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ", " + number(v.w) + ")";
}

inline void find_swapped_matrices(Camera const& camera, std::vector<Finding>& findings) {
    if (!is_perspective(camera.view) || !is_affine(camera.projection)) return;
    findings.push_back({Mistake::matrices_swapped,
                        "the last row of camera.view is " + text_of(last_row(camera.view)) + ", that of camera.projection " +
                            text_of(last_row(camera.projection)),
                        "set camera.view to the view and camera.projection to the projection"});
}

inline std::string row_and_column(glm::mat4 const& m) {
    return "its last row is " + text_of(last_row(m)) + " and its last column " + text_of(m[3]);
}
inline constexpr char transpose_it[] = "transpose it: quell's matrices are column-major and multiply column vectors";

inline bool view_is_transposed(Camera const& camera) { return !is_affine(camera.view) && is_affine(glm::transpose(camera.view)); }
inline bool projection_is_transposed(glm::mat4 const& p) {
    return !is_affine(p) && !nearly(std::abs(last_row(p).z), 1.f) && is_perspective(glm::transpose(p));
}

/// Hosts with row vectors give transposed matrices: one cause, one finding.
inline void find_transposed(Camera const& camera, std::vector<Finding>& findings) {
    bool const view = view_is_transposed(camera), projection = projection_is_transposed(camera.projection);
    if (!view && !projection) return;
    Finding finding{projection ? Mistake::projection_transposed : Mistake::view_transposed,
                    row_and_column(projection ? camera.projection : camera.view), transpose_it};
    if (view && projection) finding.also = {Mistake::view_transposed}, finding.remedy = "transpose both" + finding.remedy.substr(12);
    findings.push_back(std::move(finding));
}

/// Hosts with D3D's conventions give a projection that looks down +z.
inline void find_backwards_projection(Camera const& camera, std::vector<Finding>& findings) {
    bool const transposed = projection_is_transposed(camera.projection);
    auto const projection = transposed ? glm::transpose(camera.projection) : camera.projection;
    if (!faces_backwards(projection)) return;
    findings.push_back({Mistake::camera_faces_backwards,
                        (transposed ? "transposed, its last row is " : "its last row is ") + text_of(last_row(projection)),
                        std::string(transposed ? "after that, " : "") +
                            "set frame.camera to camera_looking_along_z(view, projection), which negates the "
                            "view's third row and the projection's third column: quell's view looks down -z"});
}

/// What the matrices show by themselves. Returns whether the camera is unusable.
inline bool find_wrong_matrices(Observation const& seen, std::vector<Finding>& findings) {
    auto const before = findings.size();
    find_swapped_matrices(seen.camera, findings);
    if (findings.size() == before) {
        find_transposed(seen.camera, findings);
        find_backwards_projection(seen.camera, findings);
    }
    return findings.size() > before;
}

/// Movement of the projection's centre since the last frame, in pixels; 0 if anything else of it changed, or if it is more than two frames'
/// jitter.
inline glm::vec2 shift_of(Observation const& seen) {
    auto then = seen.camera_then.projection;
    auto const& now = seen.camera.projection;
    glm::vec2 const moved{(now[2][0] - then[2][0]) * 0.5f * static_cast<float>(seen.size.width),
                          (now[2][1] - then[2][1]) * 0.5f * static_cast<float>(seen.size.height)};
    then[2][0] = now[2][0], then[2][1] = now[2][1];
    bool const sub_pixel = std::abs(moved.x) < 1.5f && std::abs(moved.y) < 1.5f && glm::length(moved) > 0.02f && then == now;
    return sub_pixel ? moved : glm::vec2(0.f);
}

/// A projection whose centre moves by subpixels, differently each time. Returns whether it does.
inline bool find_projection_jitter(Observation const& seen, std::vector<Finding>& findings) {
    auto const moved = shift_of(seen), before = std::exchange(seen.notes().shift, moved);
    // A slow lens shift moves on by the same amount.
    if (moved == glm::vec2(0.f) || before == glm::vec2(0.f) || glm::length(moved - before) < 0.02f) return false;
    findings.push_back({Mistake::projection_jitter,
                        "from the last frame to this one its centre moved by " + pair(moved.x, moved.y) + " pixels, and before by " +
                            pair(before.x, before.y),
                        "set camera.projection without the jitter, and camera.jitter to the offset in pixels, y down"});
    return true;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
