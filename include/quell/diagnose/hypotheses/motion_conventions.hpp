#pragma once

#include <quell/diagnose/finding.hpp>
#include <quell/frame/motion_convention.hpp>
#include <quell/image/extent.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The mistakes in taking vectors of one convention for those of another.
inline std::vector<Mistake> mistakes_of(MotionConvention convention, MotionConvention taken_for) {
    std::vector<Mistake> mistakes;
    if (convention.points != taken_for.points) mistakes.push_back(Mistake::motion_sign);
    if (convention.unit != taken_for.unit) mistakes.push_back(Mistake::motion_unit);
    if (convention.y != taken_for.y) mistakes.push_back(Mistake::motion_y);
    return mistakes;
}

/// All conventions except for jitter. The one that vectors are taken for comes first, then the others by how little they differ.
inline std::vector<MotionConvention> motion_conventions(MotionConvention taken_for) {
    using C = MotionConvention;
    std::vector<C> all;
    for (auto points : {C::Points::to_previous, C::Points::from_previous})
        for (auto unit : {C::Unit::pixel, C::Unit::uv, C::Unit::ndc})
            for (auto y : {C::Y::down, C::Y::up}) all.push_back({.points = points, .unit = unit, .y = y});
    std::stable_sort(all.begin(), all.end(), [&](C a, C b) { return mistakes_of(a, taken_for).size() < mistakes_of(b, taken_for).size(); });
    return all;
}

/// Factor for a vector that was converted to quell's convention from `taken_for`, and is of `convention`.
inline glm::vec2 correction(MotionConvention convention, MotionConvention taken_for, Extent size) {
    return to_pixels(convention, size) / to_pixels(taken_for, size);
}

/// As code: MotionConvention{.points = MotionConvention::Points::from_previous}.
inline std::string code_of(MotionConvention convention) {
    using C = MotionConvention;
    std::string text;
    auto const add = [&](bool differs, char const* member) { text += !differs ? "" : (text.empty() ? "" : ", ") + std::string(member); };
    add(convention.points == C::Points::from_previous, ".points = MotionConvention::Points::from_previous");
    add(convention.unit == C::Unit::uv, ".unit = MotionConvention::Unit::uv");
    add(convention.unit == C::Unit::ndc, ".unit = MotionConvention::Unit::ndc");
    add(convention.y == C::Y::up, ".y = MotionConvention::Y::up");
    add(convention.jitter == C::Jitter::left_in, ".jitter = MotionConvention::Jitter::left_in");
    return "MotionConvention{" + text + "}";
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
