#pragma once

#include <quell/diagnose/hypotheses/motion_hypotheses.hpp>

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

/// Hosts with row vectors give a transposed matrix, hosts with D3D's conventions one that looks down +z; some give both.
inline void find_wrong_projection(Camera const& camera, std::vector<Finding>& findings) {
    auto projection = camera.projection;
    auto const turned = glm::transpose(projection);
    bool const transposed = !is_affine(projection) && !nearly(std::abs(last_row(projection).z), 1.f) && is_perspective(turned);
    if (transposed) {
        findings.push_back({Mistake::projection_transposed, row_and_column(projection), transpose_it});
        projection = turned;
    }
    if (!faces_backwards(projection)) return;
    findings.push_back({Mistake::camera_faces_backwards,
                        (transposed ? "transposed, its last row is " : "its last row is ") + text_of(last_row(projection)),
                        std::string(transposed ? "after that, " : "") +
                            "negate the view's third row and the projection's third column: quell's view looks down -z"});
}

inline void find_transposed_view(Camera const& camera, std::vector<Finding>& findings) {
    if (is_affine(camera.view) || !is_affine(glm::transpose(camera.view))) return;
    findings.push_back({Mistake::view_transposed, row_and_column(camera.view), transpose_it});
}

/// What the matrices show by themselves. Returns whether the camera is unusable.
inline bool find_wrong_matrices(Observation const& seen, std::vector<Finding>& findings) {
    auto const before = findings.size();
    find_swapped_matrices(seen.camera, findings);
    if (findings.size() == before) {
        find_wrong_projection(seen.camera, findings);
        find_transposed_view(seen.camera, findings);
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

/// Share of surfaces that move as static ones must, with the cameras as given and with other ones.
struct OtherCameras {
    Tally own, other;
    /// better than any motion convention, too: a camera that only translates looks like motion of the wrong sign, the commoner mistake
    bool better = false;

    OtherCameras(Observation const& seen, ComparedMotions const& pairs, Camera const& now, Camera const& then) {
        auto const others = moving(motion_pairs(seen, now, then));
        if (others.size() < fewest_pairs) return;
        own = agreeing(pairs, {1.f, 1.f}), other = agreeing(others, {1.f, 1.f});
        better = other.share() >= std::max(own.share() + clear_margin, BestConvention(pairs, seen).best.share() + 0.02);
    }
    [[nodiscard]] std::string evidence() const {
        return percent(own.share()) + " of the surface pixels move as depth and cameras say of what stands still, but " +
               percent(other.share());
    }
};

/// The camera's pose in place of its inverse: with the inverse, static surfaces would move as expected. Returns whether that is so.
inline bool find_inverted_view(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    auto now = seen.camera, then = seen.camera_then;
    now.view = glm::inverse(now.view), then.view = glm::inverse(then.view);
    OtherCameras const inverted(seen, pairs, now, then);
    if (!inverted.better) return false;
    findings.push_back({Mistake::view_inverted, inverted.evidence() + " with the inverse of camera.view",
                        "set camera.view to the inverse of the camera's pose: it takes the world to the camera"});
    return true;
}

/// Images with the first row at the bottom, or a projection as for Vulkan. Returns whether that is so.
inline bool find_camera_upside_down(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    auto now = seen.camera, then = seen.camera_then;
    for (auto* const camera : {&now, &then})
        for (int column = 0; column < 4; ++column) camera->projection[column][1] *= -1.f;
    OtherCameras const turned(seen, pairs, now, then);
    if (!turned.better) return false;
    findings.push_back({Mistake::camera_upside_down, turned.evidence() + " with the second row of camera.projection negated",
                        "negate that row, or give all images with their first row at the top: row 0 is y = +1 of the projection"});
    return true;
}

/// The camera never changes, although all surfaces move.
inline void find_still_camera(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    if (!(seen.camera.view == seen.camera_then.view && seen.camera.projection == seen.camera_then.projection)) return;
    Tally moves;
    std::vector<float> lengths;
    for (auto const& pair : pairs) moves.add(glm::length(pair.found) > 0.05f), lengths.push_back(glm::length(pair.found));
    long long places = 0;
    for_each_place(seen.size, [&](int, int) { ++places; });
    if (moves.share() < 0.98 || 2 * moves.asked < places) return;
    findings.push_back({Mistake::camera_never_moves,
                        "view and projection are those of the last frame, but " + percent(moves.share()) +
                            " of all surface pixels move, by " + number(static_cast<double>(median(lengths))) + " pixels (median)",
                        "set frame.camera in every frame; where it is right, motion of what stands still must be 0"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
