#pragma once

#include <quell/diagnose/hypotheses/camera/camera_mistakes.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline bool is_miss(float depth) { return bits(depth) == bits(std::numeric_limits<float>::infinity()); }

/// Depths that are neither finite nor +infinity.
inline void find_depth_not_finite(Observation const& seen, std::vector<Finding>& findings) {
    Tally bad;
    for_each_place(seen.size, [&](int x, int y) { bad.add(!seen.hit(x, y) && !is_miss(seen.depth(0, x, y))); });
    if (bad.share() > 0.001)
        findings.push_back({Mistake::bad_guides, "'depth' is NaN or -infinity in " + percent(bad.share()) + " of the pixels",
                            "write +infinity where there is no surface, and the distance along the view axis everywhere else"});
}

/// No surface in 8 frames or more, and in none before: a camera that looks into the sky has usually seen the ground before. Returns whether
/// that is so.
inline bool find_no_surface(Observation const& seen, std::vector<Finding>& findings) {
    auto& notes = seen.notes();
    Tally misses;
    for_each_place(seen.size, [&](int x, int y) { misses.add(is_miss(seen.depth(0, x, y))); });
    notes.had_surface = notes.had_surface || misses.yes < misses.asked;
    if (notes.had_surface || ++notes.calls_without_surface < 8) return false;
    findings.push_back(
        {Mistake::depth_says_nothing,
         "it was +infinity at all places that were looked at in all " + std::to_string(notes.calls_without_surface) + " frames so far",
         "fill the channel before every run(): the distance along the view axis in world units"});
    return true;
}

/// The depth of the whole picture, if constant.
inline std::optional<float> constant_depth(Observation const& seen) {
    float const first = seen.depth(0, 0, 0);
    Tally same;
    for_each_place(seen.size, [&](int x, int y) { same.add(bits(seen.depth(0, x, y)) == bits(first)); });
    return same.yes == same.asked && is_finite(first) ? std::optional(first) : std::nullopt;
}
/// Whether the camera rotated or came closer, so that a plane of constant depth is none any more. Sliding along a wall keeps it.
inline bool changes_depth(Camera const& now, Camera const& then, float depth) {
    auto const turned = glm::row(now.view, 2) - glm::row(then.view, 2);
    return glm::length(glm::vec3(turned)) > 1e-4f || std::abs(turned.w) > 1e-3f * depth;
}
/// Constant depth although the camera moves. Returns whether that is so.
inline bool find_constant_depth(Observation const& seen, std::vector<Finding>& findings) {
    auto const now = constant_depth(seen), before = std::exchange(seen.notes().constant_depth, now);
    if (!now || now != before || !seen.has_then || !known(seen.camera) || !known(seen.camera_then)) return false;
    if (!changes_depth(seen.camera, seen.camera_then, *now)) return false;
    findings.push_back({Mistake::depth_says_nothing,
                        "it is " + number(static_cast<double>(*now)) +
                            " at all places that were looked at, as in the last frame, although the camera turned or came closer",
                        "fill the channel before every run(): the distance along the view axis in world units"});
    return true;
}

/// Depth of 0 or less: view-space z, or misses that are not infinite. Returns whether that is so.
inline bool find_depth_not_positive(Observation const& seen, std::vector<Finding>& findings) {
    Tally bad;
    float minimum = 0.f;
    for_each_hit(seen, [&](int x, int y) {
        auto const z = seen.depth(0, x, y);
        bad.add(!(z > 0.f)), minimum = std::min(minimum, z);
    });
    if (bad.share() < 0.01) return false;
    findings.push_back({Mistake::depth_not_positive,
                        percent(bad.share()) + " of the finite depths are 0 or less; the least is " + number(static_cast<double>(minimum)),
                        minimum < 0.f ? "write the distance along the view axis as a positive number: negate the view's z"
                                      : "write +infinity where there is no surface"});
    return true;
}

/// Tells linear depth from depth-buffer values by planes. Along a line on a plane, 1 / z of linear depth is linear in the pixel; so are
/// depth-buffer values themselves. Of three depths l, c, r at equal steps, |l + r - 2 c| / |r - l| is 0 for a depth buffer; for linear
/// depth it is the relative change of depth.
struct Evenness {
    Tally linear, buffer;

    void add(float l, float c, float r) {
        double const step = std::abs(static_cast<double>(r) - l), slope = step / (2. * c);
        double const bend = (static_cast<double>(l) + r - 2. * c) / step, rounding = 1.2e-7 * c / step;
        // Slopes lost in rounding, and edges of objects, tell nothing.
        if (!(step > 0.) || slope < 20. * rounding || std::abs(bend) > 0.5 || !(slope < 0.3)) return;
        linear.add(std::abs(bend / slope - 1.) < 0.25), buffer.add(std::abs(bend / slope) < 0.25);
    }
};

inline Evenness evenness_of(Observation const& seen) {
    Evenness evenness;
    auto const add = [&](int x, int y, int dx, int dy) {
        if (x < dx || y < dy || x + dx >= seen.size.width || y + dy >= seen.size.height) return;
        float const l = seen.depth(0, x - dx, y - dy), c = seen.depth(0, x, y), r = seen.depth(0, x + dx, y + dy);
        // A depth buffer has exactly 0 or 1 where there is no surface.
        auto const surface = [](float z) { return is_finite(z) && z > 0.f && z < 1.f; };
        if (surface(l) && surface(c) && surface(r)) evenness.add(l, c, r);
    };
    // Short steps stay on one plane, long ones stand out from rounding.
    for (int const part : {64, 32, 16}) {
        int const reach = std::max(1, seen.size.width / part);
        for_each_place(seen.size, [&](int x, int y) { add(x, y, reach, 0), add(x, y, 0, reach); });
    }
    return evenness;
}

/// Depth-buffer values. Returns whether that is so.
inline bool find_depth_not_linear(Observation const& seen, std::vector<Finding>& findings) {
    Tally in_unit_range, none;
    std::vector<float> depths;
    for_each_hit(seen, [&](int x, int y) {
        depths.push_back(seen.depth(0, x, y));
        in_unit_range.add(depths.back() >= 0.f && depths.back() <= 1.f), none.add(!(std::abs(depths.back()) > 0.f));
    });
    if (in_unit_range.share() < 0.99) return false;
    auto const evenness = evenness_of(seen);
    if (evenness.buffer.asked < 50 || evenness.buffer.share() < evenness.linear.share() + 0.25) return false;
    findings.push_back({Mistake::depth_not_linear,
                        "all depths lie in [0, 1], their median at " + number(static_cast<double>(median(depths))) + ", and of " +
                            std::to_string(evenness.buffer.asked) + " places on slopes " + percent(evenness.buffer.share()) +
                            " look like planes in a depth buffer, " + percent(evenness.linear.share()) + " like planes in linear depth",
                        std::string(make_depth_linear) +
                            (none.yes > 0 ? ", as it seems to be: it is 0 in " + percent(none.share()) + " of the picture" : "")});
    return true;
}

/// Whether depth is exactly this in a pixel, beside it and below it. The horizon of a floor is a row alone.
inline bool is_area_of(Observation const& seen, float depth, int x, int y) {
    auto const is = [&](int i, int j) { return bits(seen.depth(0, i, j)) == bits(depth); };
    return is(x, y) && is(std::min(x + 1, seen.size.width - 1), y) && is(x, std::min(y + 1, seen.size.height - 1));
}

/// The depth of a sky that a host with a far plane gives: the largest of the picture, the same in many pixels, and not that of a wall.
/// Returns it, if that is so.
inline std::optional<float> find_finite_sky(Observation const& seen, std::vector<Finding>& findings) {
    float farthest = 0.f;
    std::vector<float> depths;
    for_each_hit(seen, [&](int x, int y) { depths.push_back(seen.depth(0, x, y)), farthest = std::max(farthest, depths.back()); });
    Tally there;
    glm::vec3 sum{};
    float lengths = 0.f;
    for_each_hit(seen, [&](int x, int y) {
        bool const is_farthest = is_area_of(seen, farthest, x, y);
        there.add(is_farthest);
        if (!is_farthest || !seen.normal) return;
        sum += vec3_at(seen.normal, x, y), lengths += glm::length(vec3_at(seen.normal, x, y));
    });
    auto const before = std::exchange(seen.notes().farthest, farthest);
    if (there.share() < 0.005 || there.yes < 20 || there.yes == there.asked) return std::nullopt;
    bool const cameras = seen.has_then && known(seen.camera) && known(seen.camera_then);
    bool const stays = cameras && bits(before) == bits(farthest) && changes_depth(seen.camera, seen.camera_then, farthest);
    // A wall that faces the camera has one normal.
    bool const is_no_wall = seen.normal && (glm::length(sum) < 0.99f * lengths || lengths < 0.5f * static_cast<float>(there.yes));
    if (!stays && !is_no_wall && farthest < 1e4f * median(depths)) return std::nullopt;
    findings.push_back({Mistake::depth_of_misses,
                        "it is exactly " + number(static_cast<double>(farthest)) + " in " + percent(there.share()) +
                            " of the picture, more than anywhere else, and not as a wall is",
                        "write +infinity into depth where there is no surface"});
    return farthest;
}
/// The same frame, and its past, with misses in place of one depth.
inline Observation without_depth(Observation seen, float sky) {
    auto const masked = [sky](Lookup const& depth) -> Lookup {
        if (!depth) return {};
        return [=](int c, int x, int y) {
            float const z = depth(c, x, y);
            return bits(z) == bits(sky) ? std::numeric_limits<float>::infinity() : z;
        };
    };
    seen.depth = masked(seen.depth), seen.depth_then = masked(seen.depth_then);
    return seen;
}

/// Whether all depths are between 0 and 1, the least or the most of them exact: a depth buffer has the sky there.
inline std::optional<float> sky_of_buffer(Observation const& seen) {
    Tally zero, one, outside;
    for_each_hit(seen, [&](int x, int y) {
        float const z = seen.depth(0, x, y);
        zero.add(bits(z) == bits(0.f)), one.add(bits(z) == bits(1.f)), outside.add(!(z >= 0.f && z <= 1.f));
    });
    if (outside.yes > 0 || (zero.share() < 0.005 && one.share() < 0.005) || zero.yes + one.yes == zero.asked) return std::nullopt;
    return zero.yes > one.yes ? 0.f : 1.f;
}

/// What depth shows by itself. Returns whether it is unusable.
inline bool find_wrong_depth(Observation const& seen, std::vector<Finding>& findings) {
    find_depth_not_finite(seen, findings);
    bool const says_nothing = find_no_surface(seen, findings) || find_constant_depth(seen, findings);
    return says_nothing || find_depth_not_linear(seen, findings) || find_depth_not_positive(seen, findings);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
