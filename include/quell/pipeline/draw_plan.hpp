#pragma once

#include <quell/pipeline/plan.hpp>

#include <map>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A plan as a graph in the language of Graphviz.
class PlanDrawing {
    using Names = PlannedPass::Names;
    std::vector<PlannedPass> const& passes;
    std::string text = "digraph plan {\n  node [shape=box, fontname=\"Helvetica\", fontsize=11];\n"
                       "  edge [fontname=\"Helvetica\", fontsize=9, fontcolor=gray30];\n";

public:
    explicit PlanDrawing(Plan const& plan) : passes(plan.passes) {}

    [[nodiscard]] std::string drawn() {
        draw_boxes();
        for (std::size_t i = 0; i < passes.size(); ++i) draw_arrows_to(i);
        text += "  " + node(passes.size() - 1) + " -> output;\n  output [shape=plaintext];\n";
        return text + "}\n";
    }

private:
    static std::string node(std::size_t i) { return "pass" + std::to_string(i); }
    static bool has(Names const& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }
    static std::string joined(Names const& names, std::string_view separator) {
        std::string all;
        for (auto const name : names) (all += all.empty() ? "" : separator) += name;
        return all;
    }

    /// The pipelines of a composite have a frame each.
    void draw_boxes() {
        bool const is_composite = passes.back().denoises.empty();
        std::string_view above;
        for (std::size_t i = 0; i < passes.size(); ++i) {
            auto const& pass = passes[i];
            if (is_composite && pass.denoises != above) {
                if (!above.empty()) text += "  }\n";
                if (!pass.denoises.empty())
                    text += "  subgraph cluster_" + std::string(pass.denoises) + " {\n  label=\"" + std::string(pass.denoises) + "\";\n";
            }
            above = pass.denoises;
            draw_box(i);
        }
    }
    void draw_box(std::size_t i) {
        auto const& pass = passes[i];
        auto const size = pass.fraction > 1 ? ", 1/" + std::to_string(pass.fraction) : std::string();
        Names given;
        for (auto const name : pass.reads)
            if (writer(i, name) == passes.size()) given.push_back(name);
        text += "  " + node(i) + " [label=<<b>" + std::string(pass.name) + size + "</b>";
        if (!given.empty()) text += "<br/><font point-size=\"9\">" + joined(given, "<br/>") + "</font>";
        text += ">];\n";
    }
    /// Arrows of this frame, and dashed ones from the last.
    void draw_arrows_to(std::size_t i) {
        std::map<std::size_t, Names> now, past;
        for (auto const name : passes[i].reads)
            if (auto const from = writer(i, name); from < passes.size()) now[from].push_back(name);
        for (auto const name : passes[i].reads_past)
            if (auto const from = keeper(i, name); from < passes.size()) past[from].push_back(name);
        for (auto const& [from, names] : now) draw_arrow(from, i, names, "");
        for (auto const& [from, names] : past) draw_arrow(from, i, names, ", style=dashed, constraint=false");
    }
    void draw_arrow(std::size_t from, std::size_t to, Names const& names, std::string_view style) {
        text += "  " + node(from) + " -> " + node(to) + " [label=\"" + joined(names, "\\n") + "\"" + std::string(style) + "];\n";
    }
    /// The pass that has written what pass i reads; the number of passes where the host did.
    [[nodiscard]] std::size_t writer(std::size_t i, std::string_view name) const {
        for (auto before = i; before-- > 0;) {
            auto const& pass = passes[before];
            if (passes[i].denoises.empty() ? pass.denoises == name && has(pass.writes, "output")
                                           : pass.denoises == passes[i].denoises && has(pass.writes, name) && !has_of_host(pass, name))
                return before;
        }
        return passes.size();
    }
    /// The pass of the last frame that has left it for this one.
    [[nodiscard]] std::size_t keeper(std::size_t i, std::string_view name) const {
        for (auto from = passes.size(); from-- > 0;)
            if (passes[from].denoises == passes[i].denoises && has(passes[from].keeps, name)) return from;
        return passes.size();
    }
    /// Whether what a pass writes is a copy of a guide, for the next frame only.
    static bool has_of_host(PlannedPass const& pass, std::string_view name) { return has(pass.writes, "output") && has(pass.keeps, name); }
};
} // namespace detail

/// The plan as a graph for Graphviz (`dot -Tsvg`): passes are boxes with the host's channels that they read, arrows are channels, and
/// dashed arrows are what the next frame reads.
inline std::string to_graphviz(Plan const& plan) { return plan.passes.empty() ? "digraph plan {}\n" : detail::PlanDrawing(plan).drawn(); }

} // namespace quell::inline QUELL_INSTRUCTION_SET
