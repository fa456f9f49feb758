#pragma once

#include <quell/shader/shader_expression.hpp>

/// @file
/// Writes recorded passes as compute shaders.

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A pass as a compute shader, with a function `main`.
/// @param plan     of which it is a pass
/// @param pass     its number
/// @param is_first whether of a frame without a past, if the pass has such a graph
/// @param language in which
inline std::string shader_text(ShaderPlan const& plan, std::size_t pass, bool is_first, ShaderLanguage language) {
    auto const& each = plan.passes[pass];
    auto const& graph = is_first && each.first ? *each.first : each.graph;
    auto const comment = "// quell, " + plan.name + ": " + graph.name + ", pass " + std::to_string(pass + 1) + " of " +
                         std::to_string(plan.passes.size()) + (is_first ? ", in a frame without a past" : "") + "\n";
    auto written = detail::ShaderWriter(plan, graph, language).written();
    // #version must come first.
    auto const behind = language == ShaderLanguage::glsl ? written.find('\n') + 1 : std::size_t{0};
    return written.insert(behind, comment);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
