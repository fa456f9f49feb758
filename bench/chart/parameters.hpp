#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace quell::bench {

/// A number of a pipeline that a sweep changes, and the values that it tries.
struct Parameter {
    std::string_view name;
    std::span<double const> values;
};

namespace detail {

inline constexpr double levels[] = {1, 2, 3, 4, 5, 6}, sigma[] = {1, 2, 3, 4, 6}, radius[] = {3, 7, 15, 25};
inline constexpr double cap[] = {2, 4, 8, 16, 32, 48}, alpha[] = {0.05, 0.1, 0.2, 0.4, 0.6, 1}, gain[] = {25, 50, 100, 200};
inline constexpr double sigmas[] = {0.5, 1, 2, 3}, trust[] = {0.1, 0.25, 0.5, 1}, iterations[] = {0, 1, 2, 4, 8};
inline constexpr double count[] = {8, 16, 32, 64, 128}, tile_width[] = {4, 8, 16, 32}, width[] = {0.75, 1, 1.5, 2};
inline constexpr double allowed_error[] = {0.05, 0.1, 0.2, 0.4};

/// Numbers of a filter. Detectors have levels too, but no edge.
void visit_kernel(auto& kernel, auto const& visit) {
    if constexpr (requires { kernel.levels = 1, kernel.edge; }) visit(Parameter{"levels", levels}, kernel.levels);
    if constexpr (requires { kernel.sigma_luminance = 1; }) visit(Parameter{"sigma", sigma}, kernel.sigma_luminance);
    if constexpr (requires { kernel.radius = 1; }) visit(Parameter{"radius", radius}, kernel.radius);
    if constexpr (requires { kernel.footprint; }) {
        visit(Parameter{"count", count}, kernel.count);
        visit(Parameter{"tile_width", tile_width}, kernel.tile_width);
        visit(Parameter{"width", width}, kernel.width);
        if constexpr (requires { kernel.footprint.allowed_error; })
            visit(Parameter{"allowed_error", allowed_error}, kernel.footprint.allowed_error);
    }
}

/// Numbers of a blend policy and of those that it decorates.
void visit_blending(auto& blending, auto const& visit) {
    if constexpr (requires { blending.cap = 1; }) visit(Parameter{"cap", cap}, blending.cap);
    if constexpr (requires { blending.alpha = 1; }) visit(Parameter{"alpha", alpha}, blending.alpha);
    if constexpr (requires { blending.gain = 1; }) visit(Parameter{"gain", gain}, blending.gain);
    if constexpr (requires { blending.range.sigmas = 1; }) visit(Parameter{"sigmas", sigmas}, blending.range.sigmas);
    if constexpr (requires { blending.inner; }) visit_blending(blending.inner, visit);
}

void visit_motion(auto& motion, auto const& visit) {
    if constexpr (requires { motion.iterations = 1; }) visit(Parameter{"iterations", iterations}, motion.iterations);
    if constexpr (requires { motion.rest.trust = 1; }) visit(Parameter{"trust", trust}, motion.rest.trust);
}

} // namespace detail

/// Calls visit(parameter, number&) for each number of a pipeline's stages by which charts sweep: found by the names of members, so that new
/// presets are swept without being told.
void for_each_parameter(auto& pipeline, auto const& visit) {
    auto const visit_stage = [&](auto& stage) {
        if constexpr (requires { stage.kernel; }) detail::visit_kernel(stage.kernel, visit);
        if constexpr (requires { stage.blending; })
            detail::visit_blending(stage.blending, visit), detail::visit_motion(stage.motion, visit);
    };
    if constexpr (requires { pipeline.stages; }) std::apply([&](auto&... stage) { (visit_stage(stage), ...); }, pipeline.stages);
}

} // namespace quell::bench
