#pragma once

#include <quell/shader/assign_planes.hpp>
#include <quell/shader/recorded_repair.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Makes a plan of three recorded frames: one without a past, and two behind it, of which the second shows what the first leaves.
class PlanMaker {
    std::vector<void const*> inputs;
    ShaderPlan plan;

public:
    /// @param counts their slots are counted from 0
    void set_counts(std::vector<ShaderCount> counts) { plan.counts = std::move(counts); }
    template <ChannelTag C, class View> void add_input(View const& view) {
        for (int c = 0; c < View::components; ++c) {
            inputs.push_back(view.planes[c]);
            plan.inputs.push_back({std::string(C::name), c, C::fraction});
        }
    }
    [[nodiscard]] ShaderPlan make(std::array<RecordedFrame, 3> frames, std::string_view picture) {
        PlaneUses const uses[] = {{frames[0], inputs, nullptr}, {frames[1], inputs, &uses[0]}, {frames[2], inputs, &uses[1]}};
        require(uses[1].of_pass == uses[2].of_pass && uses[0].writer == uses[1].writer && uses[1].writer == uses[2].writer &&
                uses[0].output == uses[1].output);
        SlotsOfFrame const places(uses[0], uses[1], uses[2]);
        for (std::size_t p = 0; p < frames[1].passes.size(); ++p) {
            require(frames[1].passes[p].graph == frames[2].passes[p].graph);
            auto const graph_of = [&](std::size_t frame) {
                auto graph = frames[frame].passes[p].graph;
                auto parts = places.place(graph.planes, uses[frame].of_pass[p]);
                add_output(p, graph, uses[frame], places);
                parts.resize(graph.planes.size(), WordPart::whole);
                bool const shares = std::ranges::any_of(parts, [](WordPart part) { return part != WordPart::whole; });
                return shares ? HalfPacker(graph, parts).take() : graph;
            };
            auto& later = plan.passes.emplace_back(ShaderPass{graph_of(1), {}}).graph;
            if (auto first = graph_of(0); !(first == later)) plan.passes.back().first = std::move(first);
        }
        auto const planes = static_cast<int>(uses[1].output.size()) - (plan.counts.empty() ? 0 : plan.counts.back().slot + 1);
        for (int c = 0; c < planes; ++c) plan.output.push_back({std::string(picture), c, 1});
        for (auto& each : plan.counts) each.slot += planes;
        plan.history_slots = places.history_slots, plan.scratch_slots = places.scratch_slots;
        return std::move(plan);
    }

private:
    static void require(bool same) {
        if (!same)
            raise_error<Failure>("recorded frames", "a later frame has other steps than the one before",
                                 "a pipeline that is recorded must do "
                                 "the same with every frame");
    }
    /// The picture, where the next frame reads it too: the pass that makes it stores it twice.
    static void add_output(std::size_t pass, PassGraph& graph, PlaneUses const& uses, SlotsOfFrame const& places) {
        for (std::size_t c = 0; c < uses.output.size(); ++c) {
            auto const image = *uses.output[c];
            if (!places.is_kept(image) || uses.writer[image] != pass) continue;
            auto const use = std::find(uses.of_pass[pass].begin(), uses.of_pass[pass].end(), PlaneUse{PlaneUse::Kind::made, image});
            auto const number = static_cast<std::uint32_t>(use - uses.of_pass[pass].begin());
            auto const of_plane = [&](Node const& node) { return node.operation == Operation::store && node.payload == number; };
            auto store = *std::find_if(graph.nodes.begin(), graph.nodes.end(), of_plane);
            store.payload = static_cast<std::uint32_t>(graph.planes.size());
            graph.planes.push_back({"output", static_cast<int>(c), graph.fraction, ShaderBuffer::output, static_cast<int>(c)});
            graph.nodes.push_back(store);
        }
    }
};
} // namespace detail

/// Records a Pipeline, a Composite, a ByEvidence or a Chain: runs the kernel of each of its passes once, over numbers that remember what is
/// done to them. No pixel is computed. Policies need no line for it; what cannot be recorded, such as a branch on what is computed of a
/// pixel, is one sentence at compile time.
/// @param pipeline a Pipeline, a Composite, a ByEvidence or a Chain
/// @param name     what the plan is called
/// @param options  what is added to its passes
/// @throws Failure where passes differ from frame to frame
template <detail::PlainPipeline P>
ShaderPlan record(P const& pipeline, std::string_view name = "pipeline", RecordOptions const& options = {}) {
    constexpr Extent size{48, 32}; // of no matter: shaders get it with the frame
    Frame frame{size, pipeline};
    frame.camera.projection[2][3] = -1.f, frame.camera.projection[3][3] = 0.f, frame.camera.projection[3][2] = -1.f;
    History history{size, pipeline, Planar<detail::HalfIfAsked>{}};
    detail::PassRecorder recorder(options);
    detail::PlanMaker maker;
    for_each_channel(typename decltype(frame)::channels{}, [&]<class C>(C c) {
        recorder.note(frame[c].view(), C::name, C::fraction);
        maker.add_input<C>(frame[c].view());
    });
    detail::RecordedRepair const repair(frame, recorder);
    bool const repairs = options.repair_guides && repair.has_some;
    std::array<detail::RecordedFrame, 3> frames;
    for (auto& each : frames) {
        if (repairs) repair.record(frame, recorder);
        auto const picture = run(pipeline, frame, history, detail::RecordingExecutor{&recorder});
        each.passes = recorder.take();
        if (repairs) repair.redirect(each.passes);
        each.output.assign(std::begin(picture.planes), std::end(picture.planes));
        auto [counts, squares] = recorder.take_counts();
        each.output.insert(each.output.end(), squares.begin(), squares.end());
        maker.set_counts(std::move(counts));
    }
    auto plan = maker.make(std::move(frames), P::Output::name);
    plan.name = name, plan.needs_camera = P::needs_camera, plan.most_slots = options.most_slots;
    plan.texel_loads = options.texel_loads, plan.workgroup = options.workgroup;
    return plan;
}
/// @cond
template <class P> ShaderPlan record(P const&, std::string_view = {}, RecordOptions const& = {}) {
    static_assert(
        detail::PlainPipeline<P>,
        "record(pipeline): it takes a Pipeline, a Composite, a ByEvidence or a Chain; of a TwoSided give it the member `pipeline`; "
        "a resolve at the frame's size is a link: Chain{pipeline, Pipeline{denoised, Spatial{Resolve{}}}}");
    return {};
}
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
