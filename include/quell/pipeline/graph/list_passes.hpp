#pragma once

#include <quell/pipeline/graph/run_kernel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What follows from the order of a pipeline's stages.
template <class P> class StageOrder {
    using Stages = decltype(P::stages);
    template <std::size_t i> using StageAt = std::tuple_element_t<i, Stages>;

public:
    static constexpr std::size_t count = std::tuple_size_v<Stages>;

private:
    /// Whether a stage is known to make a new signal. Of a filter of several passes only a run tells.
    template <class Stage> static constexpr bool always_makes_signal = is_temporal<Stage> || !(leaves_signal<Stage> || has_passes<Stage>);
    template <std::size_t... i> static constexpr std::size_t counted_up_to_temporal(std::index_sequence<i...>) {
        std::size_t n = 0;
        static_cast<void>(((++n, is_temporal<StageAt<i>>) || ...));
        return n;
    }
    template <std::size_t... before> static constexpr bool marked_behind(std::index_sequence<before...>) {
        return !(... || (P::has_temporal ? is_temporal<StageAt<before>> : always_makes_signal<StageAt<before>>));
    }
    static constexpr bool last_may_leave_signal() {
        if constexpr (count == 0)
            return true;
        else
            return !always_makes_signal<StageAt<count - 1>>;
    }

public:
    /// Number of stages up to and including Temporal; all of them without one.
    static constexpr std::size_t up_to_temporal = counted_up_to_temporal(std::make_index_sequence<count>{});
    /// Whether stage i may see marks of missing samples. Marks last until Temporal, which keeps the history there; without a Temporal,
    /// until a stage has made a new signal.
    template <std::size_t i> static constexpr bool may_be_marked = marked_behind(std::make_index_sequence<i>{});
    /// Whether the last stage may make no signal. Then an extra pass writes the output.
    static constexpr bool may_end_without_signal = last_may_leave_signal();
};

/// Makes the list of a pipeline's passes.
/// @tparam K the Kernels of the pipeline
template <class P, class FrameStorage, class Storage, class K> class PassLister {
    using Order = StageOrder<P>;
    P const& pipeline;
    PassList& list;
    bool marked = true; ///< whether the signal marks missing samples

public:
    constexpr PassLister(P const& p, PassList& l) : pipeline(p), list(l) {}

    /// @param stages how many of the stages: all, or those up to Temporal
    template <std::size_t stages> constexpr void through(std::integral_constant<std::size_t, stages>) {
        list.clear();
        describe_images();
        list.ingest = pass<false>(pipeline.ingest);
        list.fill_holes = pass<true>(FillHoles{0});
        [&]<std::size_t... i>(std::index_sequence<i...>) { (stage<i>(std::get<i>(pipeline.stages)), ...); }
        (std::make_index_sequence<stages>{});
        if (list.passes.empty() || !list.passes.back().makes_signal) pass_through();
    }

private:
    constexpr void describe_images() {
        list.keeps = ChannelIds(typename P::keeps{}), list.remembers = ChannelIds(typename P::remembers{});
        list.signal = format_of<Storage, typename P::Signal>, list.output = format_of<Storage, typename P::Output>;
        list.carries = ChannelIds(typename P::carries{}), list.carry = K::carry_of();
        list.has_past = P::has_past;
        list.complete_ingest = K::complete_ingest_of();
        list.demodulates = !std::is_same_v<typename P::Form, NoModulation>;
        static_assert(P::remembers::size <= std::tuple_size_v<decltype(list.guides)>, "a pipeline remembers more than 8 channels");
        for_each_channel(typename StoredChannels<typename P::remembers>::type{}, [&]<class C>(C) {
            list.guides[static_cast<std::size_t>(list.guide_count++)] = {&channel_info<C>, format_of<Storage, C>};
        });
        using Copy = StorageOfCopies<FrameStorage>;
        if constexpr (!std::is_void_v<Copy>)
            for_each_channel(common_to<CopiedGuides, typename P::reads>{}, [&]<class C>(C) {
                list.repairs.push_back({&channel_info<C>, format_of<Copy, C>, number_of_guide<C>(),
                                        reads_of<typename P::Form>::template has<C>, K::template repair_of<C>()});
            });
    }

    template <std::size_t i, class Stage> constexpr void stage(Stage const& s) {
        for_each_pass(s, [&]<class Pass>(Pass const& kernel) {
            constexpr bool makes_signal = K::template makes_signal<Pass>;
            static_assert(!leaves_signal<Stage> || !makes_signal,
                          "Spatial{filter}: a pass of a filter that says `leaves_signal` makes the signal: give it emit_channels(px)");
            if constexpr (!Order::template may_be_marked<i>)
                list.passes.push_back(pass<false>(kernel));
            else if constexpr (P::has_temporal || leaves_signal<Stage>)
                list.passes.push_back(pass<true>(kernel));
            else
                list.passes.push_back(marked ? pass<true>(kernel) : pass<false>(kernel));
            marked = marked && !makes_signal;
        });
    }
    /// Writes the output where no stage makes a signal behind the last one.
    constexpr void pass_through() {
        if constexpr (Order::may_end_without_signal && P::has_temporal)
            list.passes.push_back(pass<false>(PassThrough{}));
        else if constexpr (Order::may_end_without_signal)
            list.passes.push_back(marked ? pass<true>(PassThrough{}) : pass<false>(PassThrough{}));
    }

    template <bool marks, class Pass> constexpr FramePass pass(Pass const& kernel) {
        using S = typename K::template ScopeOf<Pass, marks>;
        FramePass made{.name = pass_name<Pass>,
                       .fraction = S::fraction,
                       .farthest_tap = farthest_tap_of(kernel),
                       .reads = ChannelIds(typename S::frame_channels{}),
                       .reads_made = ChannelIds(typename S::made_channels{}),
                       .reads_kept = ChannelIds(typename S::kept_channels{}),
                       .reads_remembered = ChannelIds(typename S::remembered_channels{}),
                       .reads_signal = !std::is_same_v<Pass, decltype(P::ingest)>,
                       .reads_past_signal = S::reads_past_signal,
                       .makes_signal = K::template makes_signal<Pass>,
                       .feeds_history = P::has_temporal && (is_temporal<Pass> || feeds_back(kernel)),
                       .make_job = &K::template make_job<Pass, marks>,
                       .run = &K::template run<Pass, marks>,
                       .job_bytes = sizeof(typename K::template JobOf<Pass, marks>),
                       .kernel = list.keep(kernel)};
        for_each_channel(decltype(emits_of<Pass>{} | keeps_of<Pass>{}){}, [&]<class C>(C) {
            made.makes.channels[static_cast<std::size_t>(made.makes.count++)] = {&channel_info<C>, format_of<Storage, C>};
        });
        static_assert(decltype(emits_of<Pass>{} | keeps_of<Pass>{})::size <= MadeChannels::most, "a pass makes more than 8 channels");
        return made;
    }
};

/// Makes the list of the first `stages` stages of a pipeline.
/// @tparam FrameStorage of the frame
/// @tparam Storage      of the history
/// @tparam K            the Kernels of the pipeline
template <std::size_t stages, class FrameStorage, class Storage, class K, class P>
constexpr void list_passes(P const& pipeline, PassList& list, bool has_target) {
    PassLister<P, FrameStorage, Storage, K>(pipeline, list).through(std::integral_constant<std::size_t, stages>{});
    list.has_target = has_target;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
