#pragma once

#include <quell/diagnose/hypotheses/static_motion.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline bool is_unit(glm::vec3 n) { return std::abs(glm::length(n) - 1.f) < 0.02f; }

/// Pixels without a normal at the largest depth: the sky of a host with a far plane.
inline Tally far_without_normal(Observation const& seen) {
    auto const has_none = [&](int x, int y) { return vec3_at(seen.normal, x, y) == glm::vec3(0.f); };
    float farthest = 0.f;
    for_each_hit(seen, [&](int x, int y) {
        if (seen.depth) farthest = std::max(farthest, seen.depth(0, x, y));
    });
    Tally distant;
    for_each_hit(seen, [&](int x, int y) {
        if (seen.depth && has_none(x, y)) distant.add(seen.depth(0, x, y) > 0.999f * farthest);
    });
    return distant;
}

/// Returns whether lengths are wrong; directions then need no test.
inline bool find_normal_length(Observation const& seen, std::vector<Finding>& findings) {
    Tally unit, packed;
    std::vector<float> lengths;
    for_each_hit(seen, [&](int x, int y) {
        auto const n = vec3_at(seen.normal, x, y);
        unit.add(is_unit(n)), packed.add(is_unit(n * 2.f - 1.f)), lengths.push_back(glm::length(n));
    });
    if (unit.asked == 0 || unit.share() > 0.8) return false;
    auto const evidence =
        percent(unit.share()) + " of the normals are of length 1; the median is " + number(static_cast<double>(median(lengths)));
    auto const distant = far_without_normal(seen);
    if (distant.share() > 0.98 && static_cast<double>(distant.yes) > 0.98 * static_cast<double>(unit.asked - unit.yes) && unit.yes > 0)
        findings.push_back({Mistake::depth_of_misses,
                            evidence + ", and " + std::to_string(distant.yes) +
                                " of those that were looked at are 0 and have the farthest depth of the picture",
                            "write +infinity into depth where there is no surface"});
    else if (packed.share() > unit.share() + 0.25)
        findings.push_back({Mistake::normal_packed, evidence + ", but " + percent(packed.share()) + " are of length 1 as 2 n - 1",
                            "write 2 n - 1, which is in [-1, 1]"});
    else
        findings.push_back({Mistake::normal_not_unit, evidence, "normalise them, after interpolation too"});
    return true;
}

/// View-space normal by finite differences of depth; empty at edges.
inline std::optional<glm::vec3> shown_normal(Observation const& seen, StaticMotion const& camera, int x, int y) {
    if (x + 1 >= seen.size.width || y + 1 >= seen.size.height) return std::nullopt;
    float const here = seen.depth(0, x, y), right = seen.depth(0, x + 1, y), below = seen.depth(0, x, y + 1);
    auto const beside = [&](float z) { return is_finite(z) && std::abs(z - here) < 0.05f * here; };
    if (!beside(right) || !beside(below)) return std::nullopt;
    auto const p = camera.point(x, y, here);
    return glm::vec3(glm::normalize(glm::cross(camera.point(x, y + 1, below) - p, camera.point(x + 1, y, right) - p)));
}

/// The space of the normals, by the slope of depth: world, view, or the world of an inverted view.
struct NormalSpace {
    Tally world, view, inverted;

    explicit NormalSpace(Observation const& seen) {
        StaticMotion const camera(seen.camera, seen.camera, seen.size);
        glm::mat3 const turn(seen.camera.view);
        for_each_hit(seen, [&](int x, int y) {
            if (auto const shown = shown_normal(seen, camera, x, y))
                add(vec3_at(seen.normal, x, y), glm::transpose(turn) * *shown, *shown, turn * *shown);
        });
    }

private:
    /// Only where the spaces differ, and only a normal near to one of them. A normal that faces the camera may come from constant depth.
    void add(glm::vec3 n, glm::vec3 as_world, glm::vec3 as_view, glm::vec3 as_inverted) {
        if (std::abs(glm::dot(as_world, as_view)) > 0.97f || std::abs(as_view.z) > 0.97f) return;
        float const a = std::abs(glm::dot(n, as_world)), b = std::abs(glm::dot(n, as_view)), c = std::abs(glm::dot(n, as_inverted));
        auto const is = [](float one, float other, float third) { return one > 0.9f && one > std::max(other, third) + 0.01f; };
        world.add(is(a, b, c)), view.add(is(b, a, c)), inverted.add(is(c, a, b));
    }
};

/// Returns whether the view is inverted.
inline bool find_normal_space(Observation const& seen, std::vector<Finding>& findings) {
    NormalSpace const space(seen);
    auto const evidence = "at " + std::to_string(space.world.asked) + " pixels " + percent(space.world.share()) +
                          " of the normals are those of the slope of depth in world space, ";
    bool const is_view = space.view.share() > space.world.share() + 0.25, is_inverted = space.inverted.share() > space.world.share() + 0.25;
    if (space.world.asked < 50 || is_view == is_inverted) return false;
    if (is_view)
        findings.push_back({Mistake::normal_in_view_space, evidence + percent(space.view.share()) + " in view space",
                            "write normals in world space: transpose(mat3(view)) * n"});
    else
        findings.push_back({Mistake::view_inverted, evidence + percent(space.inverted.share()) + " with the inverse of camera.view",
                            "set camera.view to the inverse of the camera's pose: it takes the world to the camera"});
    return is_inverted;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
