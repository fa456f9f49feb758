#pragma once

#include <quell/diagnose/finding.hpp>
#include <quell/motion/supplied_motion.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace quell::detail {

/// What this convention has other than quell's own.
inline std::vector<Mistake> mistakes_of(MotionConvention convention) {
    std::vector<Mistake> mistakes;
    if (convention.points != MotionConvention{}.points) mistakes.push_back(Mistake::motion_sign);
    if (convention.unit != MotionConvention{}.unit) mistakes.push_back(Mistake::motion_unit);
    if (convention.y != MotionConvention{}.y) mistakes.push_back(Mistake::motion_y);
    return mistakes;
}

/// All that hosts may follow, but for jitter; those that differ in less from quell's own come first, quell's own at the front.
inline std::vector<MotionConvention> motion_conventions() {
    using C = MotionConvention;
    std::vector<C> all;
    for (auto points : {C::Points::to_previous, C::Points::from_previous})
        for (auto unit : {C::Unit::pixel, C::Unit::uv, C::Unit::ndc})
            for (auto y : {C::Y::down, C::Y::up}) all.push_back({.points = points, .unit = unit, .y = y});
    std::stable_sort(all.begin(), all.end(), [](C a, C b) { return mistakes_of(a).size() < mistakes_of(b).size(); });
    return all;
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

} // namespace quell::detail
