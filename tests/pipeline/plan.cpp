#include "../frames.hpp"

#include <quell/pipeline/draw_plan.hpp>
#include <quell/presets/blur.hpp>

#include <algorithm>

using namespace quell;

namespace {
bool has(PlannedPass::Names const& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

/// What a run of two frames has taken.
template <class P> double bytes_of(P const& pipeline) {
    Frame frame{Extent{1024, 16}, pipeline};
    tests::fill_still(frame);
    History history{frame.size, pipeline};
    for (int i = 0; i < 2; ++i) run(pipeline, frame, history);
    return history.bytes_per_pixel();
}
template <class P> std::vector<std::string_view> kept_by(P const&) {
    PlannedPass::Names names;
    for_each_channel(typename P::keeps{}, [&](auto c) { names.push_back(c.name); });
    return names;
}

/// Whether a later pass, or one of the next frame, reads a channel that pass `writer` has written.
bool is_read(Plan const& plan, std::size_t writer, std::string_view name) {
    for (std::size_t i = 0; i < plan.passes.size(); ++i)
        if ((i > writer && has(plan.passes[i].reads, name)) || has(plan.passes[i].reads_past, name)) return true;
    return name == "output";
}
/// Whatever a pass reads is the host's or was written before, the past that it reads was written in the last frame, and whatever it writes
/// is read.
template <class P> void check_order(P const& pipeline) {
    auto const plan = plan_of(pipeline);
    for (std::size_t i = 0; i < plan.passes.size(); ++i)
        for (auto const name : plan.passes[i].writes) {
            INFO(plan.passes[i].name, " writes ", name);
            CHECK(is_read(plan, i, name));
        }
    PlannedPass::Names supplied, written;
    for_each_channel(typename P::reads{}, [&](auto c) { supplied.push_back(c.name); });
    for (auto const& pass : plan.passes) {
        CAPTURE(pass.name);
        for (auto const name : pass.reads) CHECK((has(supplied, name) || has(written, name)));
        written.insert(written.end(), pass.writes.begin(), pass.writes.end());
    }
    for (auto const& pass : plan.passes)
        for (auto const name : pass.reads_past) CHECK(has(written, name));
    CHECK(has(plan.passes.back().writes, "output"));
    for (auto const name : kept_by(pipeline)) CHECK(has(written, name));
}
} // namespace

TEST_CASE("a plan names the passes in order, with what they read and write") {
    auto const plan = plan_of(presets::svgf(radiance, Demodulate{}));
    REQUIRE(plan.passes.size() == 8);
    CHECK(plan.passes[0].name == "ingest");
    CHECK(plan.passes[0].reads == PlannedPass::Names{"radiance", "albedo", "normal", "depth", "motion"});
    CHECK(plan.passes[1].name == "temporal");
    CHECK(has(plan.passes[1].reads, "motion"));
    CHECK(has(plan.passes[1].reads_past, "luminance_mean"));
    CHECK(has(plan.passes[1].writes, "history_length"));
    CHECK(plan.passes[1].denoises == "radiance");
    CHECK(to_string(plan).find("| ingest | radiance, albedo, normal, depth, motion |  | signal |") != std::string::npos);
    check_order(presets::svgf(radiance, Demodulate{}));
    check_order(presets::general(radiance, Demodulate{}));
    check_order(presets::shadow(visibility));
    check_order(presets::blur(radiance));
}

TEST_CASE("a plan's memory is what a run takes, and what nothing reads any more is used again") {
    auto const check = [](auto const& pipeline) { CHECK(plan_of(pipeline).bytes_per_pixel == doctest::Approx(bytes_of(pipeline))); };
    check(presets::none(radiance));
    check(presets::svgf(radiance, Demodulate{}));
    check(presets::general(radiance, Demodulate{}));
    CHECK(bytes_of(presets::general(radiance, Demodulate{})) <= 80);
    CHECK(plan_of(presets::blur(radiance)).bytes_per_pixel <= 200);
    CHECK(plan_of(presets::svgf(radiance), Planar<Float16>{}).bytes_per_pixel < 0.6 * plan_of(presets::svgf(radiance)).bytes_per_pixel);
}

TEST_CASE("the pipelines of a composite run in order and share what is scratch") {
    constexpr auto one = presets::svgf(glossy);
    constexpr auto other = presets::svgf(indirect);
    constexpr Composite both{one, other};
    auto const plan = plan_of(both);
    REQUIRE(plan.passes.size() == 17);
    CHECK(has(plan.passes[0].reads, "glossy"));
    CHECK(has(plan.passes[8].reads, "indirect"));
    CHECK(plan.passes.back().name == "composite");
    CHECK(plan.passes[7].denoises == "glossy");
    CHECK(has(plan.passes[7].writes, "output"));
    CHECK(plan.passes[15].denoises == "indirect");
    CHECK(plan.passes[16].denoises.empty());
    auto const text = to_string(plan), heading = std::string("| **indirect** |  |  |  |\n| ingest | indirect, normal, depth, motion |");
    CHECK(text.find(heading) != std::string::npos);
    CHECK(to_string(plan_of(one)).find("**") == std::string::npos);
    CHECK(plan.bytes_per_pixel < plan_of(one).bytes_per_pixel + plan_of(other).bytes_per_pixel);
}

TEST_CASE("a drawing has a box for each pass, and arrows for what goes from one to another, and to the next frame") {
    auto const text = to_graphviz(plan_of(presets::svgf(radiance, Demodulate{})));
    auto const has_line = [&](std::string_view line) { return text.find("\n  " + std::string(line) + "\n") != std::string::npos; };
    CHECK(has_line("pass1 [label=<<b>temporal</b><br/><font point-size=\"9\">motion<br/>depth<br/>normal</font>>];"));
    CHECK(has_line("pass0 -> pass1 [label=\"signal\"];"));
    CHECK(has_line("pass2 -> pass3 [label=\"variance\"];"));
    CHECK(has_line("pass6 -> pass7 [label=\"signal\\nvariance\"];"));
    CHECK(has_line("pass7 -> output;"));
    // The first level's output goes into the history, the last pass copies guides.
    CHECK(has_line("pass3 -> pass1 [label=\"signal\", style=dashed, constraint=false];"));
    CHECK(has_line("pass7 -> pass1 [label=\"depth\\nnormal\", style=dashed, constraint=false];"));
    CHECK(text.find("pass8") == std::string::npos);
    CHECK(to_graphviz(Plan{}) == "digraph plan {}\n");

    auto const both = to_graphviz(plan_of(Composite{presets::surface(glossy), presets::surface(indirect)}));
    CHECK(both.find("subgraph cluster_glossy {") != std::string::npos);
    CHECK(both.find("pass3 -> pass4 [label=\"indirect\"];") != std::string::npos);
    CHECK(both.find("pass1 -> pass4 [label=\"glossy\"];") != std::string::npos);
    CHECK(std::ranges::count(both, '{') == std::ranges::count(both, '}'));
}
