#pragma once

#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/run.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// One pass over the image, as run() executes it. Channels appear by name. "signal" is what is denoised; "output" is what the host gets.
struct PlannedPass {
    using Names = std::vector<std::string_view>; ///< names of channels
    std::string_view name;                       ///< of the pass
    std::string_view denoises{};                 ///< the channel that its pipeline denoises; empty: it adds up what several have made
    int fraction = 1;                            ///< the pass runs at 1/fraction of the frame's width and height
    Names reads{};                               ///< may read, of this frame: from the host and from earlier passes
    Names reads_past{};                          ///< may read, of the last frame
    Names writes{};                              ///< for later passes, the next frame and the host
};

/// What run() does with each frame after the first, and how much memory that takes.
struct Plan {
    std::vector<PlannedPass> passes{}; ///< in the order in which they run
    double bytes_per_pixel = 0;        ///< of history and scratch, as history.bytes_per_pixel()
};

namespace detail {
/// The name of the channel that an ingest reads; empty for other passes.
template <class Pass> inline constexpr std::string_view ingested_by{};
template <class S, class Form, class Suppression, class Guides>
inline constexpr std::string_view ingested_by<Ingest<S, Form, Suppression, Guides>> = S::name;

/// An executor that computes nothing and records the passes.
struct PassRecorder {
    std::vector<PlannedPass>* passes;

    template <class Job> void for_each_pixel(Region, Job const& job) const {
        PlannedPass pass{.name = Job::name, .denoises = passes->empty() ? std::string_view{} : passes->back().denoises};
        auto const before = pass.denoises;
        describe(job, pass);
        if (pass.denoises != before) end_pipeline();
        passes->push_back(std::move(pass));
    }
    /// The last pass so far made what its pipeline gives, which may be the image of the signal.
    void end_pipeline() const {
        if (!passes->empty()) add(passes->back().writes, "output");
    }

private:
    template <class... Cs> static void add(PlannedPass::Names& to, Channels<Cs...>) { (add(to, Cs::name), ...); }
    static void add(PlannedPass::Names& to, std::string_view name) {
        if (std::find(to.begin(), to.end(), name) == to.end()) to.push_back(name);
    }

    template <class Pass, class S, class SignalView, class MadeViews, class FinishWork, class RememberedSet, bool keeps_marks>
    static void describe(Job<Pass, S, SignalView, MadeViews, FinishWork, RememberedSet, keeps_marks> const& job, PlannedPass& pass) {
        pass.fraction = S::fraction;
        if (ingested_by<Pass>.empty())
            add(pass.reads, "signal");
        else
            pass.denoises = ingested_by<Pass>;
        add(pass.reads, typename S::frame_channels{});
        add(pass.reads, typename S::made_channels{});
        if (is_temporal<Pass> || S::kept_channels::size + S::remembered_channels::size > 0) add(pass.reads_past, "signal");
        add(pass.reads_past, typename S::kept_channels{});
        add(pass.reads_past, typename S::remembered_channels{});
        if (job.store_signal) add(pass.writes, "signal");
        add(pass.writes, typename MadeViews::channels{});
        if (job.store_output) add(pass.writes, "output");
        if (job.store_remembered) add(pass.writes, RememberedSet{});
    }
    /// No frame is looked at, and no guide repaired.
    template <ChannelTag C, class From, class To> static void describe(RepairJob<C, From, To> const&, PlannedPass&) {}
    template <class FrameViews, class OutputView, class... Parts>
    static void describe(CompositeJob<FrameViews, OutputView, Parts...> const&, PlannedPass& pass) {
        pass.denoises = {};
        (add(pass.reads, Parts::Channel::name), ...);
        add(pass.reads, typename FrameViews::channels{});
        add(pass.writes, "output");
    }
};
} // namespace detail

/// The plan of a pipeline or composite: the passes in order, what each reads and writes, and the memory. No pixel is computed.
/// @param pipeline a Pipeline or Composite
/// @param storage  of the history
template <class P, ImageStorage Storage = Planar<>> Plan plan_of(P const& pipeline, Storage const& storage = {}) {
    // Large enough that padding hardly counts.
    constexpr Extent size{1024, 16};
    Frame frame{size, pipeline};
    frame.camera.projection[2][3] = -1.f, frame.camera.projection[3][3] = 0.f, frame.camera.projection[3][2] = -1.f;
    History<P, Storage> history{size, pipeline, storage};
    Plan plan;
    detail::PassRecorder const recorder{&plan.passes};
    run(pipeline, frame, history, recorder);
    plan.passes.clear();
    run(pipeline, frame, history, recorder);
    recorder.end_pipeline();
    plan.bytes_per_pixel = history.bytes_per_pixel();
    return plan;
}

/// The plan as a Markdown table with a row per pass. Each pipeline of a composite has a row with its signal's name above it.
inline std::string to_string(Plan const& plan) {
    auto const joined = [](PlannedPass::Names const& names) {
        std::string text;
        for (auto const name : names) (text += text.empty() ? "" : ", ") += name;
        return text;
    };
    std::string text = "| pass | reads | of the last frame | writes |\n| --- | --- | --- | --- |\n";
    bool const is_composite = !plan.passes.empty() && plan.passes.back().denoises.empty();
    std::string_view above;
    for (auto const& pass : plan.passes) {
        if (is_composite && pass.denoises != above)
            text += "| **" + std::string(pass.denoises.empty() ? "sum" : pass.denoises) + "** |  |  |  |\n";
        above = pass.denoises;
        text += "| " + std::string(pass.name) + (pass.fraction > 1 ? ", 1/" + std::to_string(pass.fraction) : "") + " | " +
                joined(pass.reads) + " | " + joined(pass.reads_past) + " | " + joined(pass.writes) + " |\n";
    }
    return text + "History and scratch: " + std::to_string(static_cast<long>(plan.bytes_per_pixel + 0.5)) + " bytes a pixel.\n";
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
