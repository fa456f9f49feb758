#pragma once

#include <quell/pipeline/chain.hpp>
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
    int farthest_tap = 0;                        ///< how far it looks at images of this frame, in its own pixels; may be `anywhere`
    Names reads{};                               ///< of this frame: from the host and from earlier passes
    Names reads_past{};                          ///< of the last frame
    Names writes{};                              ///< for later passes, the next frame and the host
    Names keeps{};                               ///< those of `writes` that the next frame reads
};

/// What run() does with each frame after the first, and how much memory that takes.
struct Plan {
    std::vector<PlannedPass> passes{}; ///< in the order in which they run
    double bytes_per_pixel = 0;        ///< of history and scratch, as history.bytes_per_pixel()
};

namespace detail {
/// An executor that computes nothing.
struct NoWork {
    void for_each_pixel(Region, auto const&) const {}
};

inline void add(PlannedPass::Names& to, std::string_view name) {
    if (std::find(to.begin(), to.end(), name) == to.end()) to.push_back(name);
}
inline void add(PlannedPass::Names& to, ChannelIds const& channels) {
    for (ChannelId const channel : channels) add(to, channel->name);
}
inline PlannedPass planned(FramePass const& pass, std::string_view denoises) {
    PlannedPass made{.name = pass.name, .denoises = denoises, .fraction = pass.fraction, .farthest_tap = pass.farthest_tap};
    if (pass.reads_signal) add(made.reads, "signal");
    add(made.reads, pass.reads), add(made.reads, pass.reads_made);
    if (pass.reads_past_signal) add(made.reads_past, "signal");
    add(made.reads_past, pass.reads_kept), add(made.reads_past, pass.reads_remembered);
    return made;
}
/// Adds what the next frame reads of what pass i writes.
inline void add_kept(PlannedPass& made, PassList const& list, std::size_t i) {
    auto const feeds = [](FramePass const& pass) { return pass.feeds_history; };
    auto const later = std::span(list.passes).subspan(i + 1);
    if (list.passes[i].feeds_history && std::ranges::none_of(later, feeds)) add(made.keeps, "signal");
    for (auto const& each : list.passes[i].makes) {
        bool const again = std::ranges::any_of(later, [&](FramePass const& pass) { return pass.makes.has(each.id); });
        if (list.keeps.has(each.id) && !again) add(made.keeps, each.id->name);
    }
    if (later.empty()) add(made.keeps, list.remembers);
}
/// The passes that a history has run in its last frame.
inline void append_passes(std::vector<PlannedPass>& passes, PassList const& list, std::string_view denoises) {
    passes.push_back(planned(list.ingest, denoises));
    passes.back().writes.push_back("signal");
    for (std::size_t i = 0; i < list.passes.size(); ++i) {
        auto made = planned(list.passes[i], denoises);
        if (list.stores_signal(i)) add(made.writes, "signal");
        for (auto const& each : list.passes[i].makes)
            if (list.is_wanted(each.id, i)) add(made.writes, each.id->name);
        if (i + 1 == list.passes.size()) add(made.writes, "output"), add(made.writes, list.remembers);
        add_kept(made, list, i);
        passes.push_back(std::move(made));
    }
}
template <ChannelTag S, class... Parts> struct PassesOf<Pipeline<S, Parts...>> {
    static void append(auto& passes, Pipeline<S, Parts...> const&, auto& history) {
        append_passes(passes, OpenHistory::images(history).passes.list(), S::name);
    }
};
template <class... Ps> struct PassesOf<Composite<Ps...>> {
    static void append(auto& passes, Composite<Ps...> const& composite, auto& history) {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (PassesOf<Ps>::append(passes, std::get<i>(composite.pipelines), OpenHistory::of_pipeline<i>(history)), ...);
        }
        (std::index_sequence_for<Ps...>{});
        PlannedPass sum{.name = "composite"};
        (add(sum.reads, Ps::Output::name), ...);
        add(sum.reads, ChannelIds(typename Composite<Ps...>::factors{})), add(sum.writes, "output");
        passes.push_back(std::move(sum));
    }
};
template <class First, class... Links> struct PassesOf<Chain<First, Links...>> {
    static void append(auto& passes, Chain<First, Links...> const& chain, auto& history) {
        PassesOf<First>::append(passes, chain.first, OpenHistory::first(history));
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (PassesOf<Links>::append(passes, std::get<i>(chain.links), OpenHistory::link<i>(history)), ...);
        }
        (std::index_sequence_for<Links...>{});
    }
};
} // namespace detail

namespace detail {
/// Whether what a denoiser runs can be listed.
template <class P>
concept Planned = requires {
    sizeof(PassesOf<P>);
};
} // namespace detail

/// The plan of a denoiser: the passes in order, what each reads and writes, and the memory. No pixel is computed. Of a TwoSided it is that
/// of a window of two frames.
/// @param pipeline a Pipeline, a Composite, a ByEvidence, a TwoSided, a Chain or a Resolved
/// @param storage  of the history
template <detail::Planned P, ImageStorage Storage = Planar<>> Plan plan_of(P const& pipeline, Storage const& storage = {}) {
    // Large enough that padding hardly counts.
    constexpr Extent size{1024, 16};
    decltype(Frame{size, pipeline}) window[]{Frame{size, pipeline}, Frame{size, pipeline}};
    for (auto& frame : window)
        frame.camera.projection[2][3] = -1.f, frame.camera.projection[3][3] = 0.f, frame.camera.projection[3][2] = -1.f;
    History<P, Storage> history{size, pipeline, storage};
    for (int i = 0; i < 2 + detail::kept_frames_of<P>; ++i)
        if constexpr (detail::is_two_sided<P>)
            run(pipeline, window, history, detail::NoWork{});
        else
            run(pipeline, window[0], history, detail::NoWork{});
    Plan plan;
    detail::PassesOf<P>::append(plan.passes, pipeline, history);
    plan.bytes_per_pixel = history.bytes_per_pixel();
    return plan;
}
/// @cond
template <class P, class... Storage> Plan plan_of(P const&, Storage const&...) {
    static_assert(detail::Planned<P>,
                  "plan_of(pipeline): it takes a Pipeline, a Composite, a ByEvidence, a TwoSided, a Chain, or what presets::resolve makes");
    return {};
}
/// @endcond

/// The plan as a Markdown table with a row per pass. Each pipeline of a composite or a chain has a row with its signal's name above it.
inline std::string to_string(Plan const& plan) {
    auto const joined = [](PlannedPass::Names const& names) {
        std::string text;
        for (auto const name : names) (text += text.empty() ? "" : ", ") += name;
        return text;
    };
    std::string text = "| pass | reads | of the last frame | writes |\n| --- | --- | --- | --- |\n";
    bool const has_several = std::ranges::any_of(plan.passes, [&](auto const& pass) { return pass.denoises != plan.passes[0].denoises; });
    std::string_view above;
    for (auto const& pass : plan.passes) {
        if (has_several && pass.denoises != above)
            text += "| **" + std::string(pass.denoises.empty() ? "sum" : pass.denoises) + "** |  |  |  |\n";
        above = pass.denoises;
        text += "| " + std::string(pass.name) + (pass.fraction > 1 ? ", 1/" + std::to_string(pass.fraction) : "") + " | " +
                joined(pass.reads) + " | " + joined(pass.reads_past) + " | " + joined(pass.writes) + " |\n";
    }
    return text + "History and scratch: " + std::to_string(static_cast<long>(plan.bytes_per_pixel + 0.5)) + " bytes a pixel.\n";
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
