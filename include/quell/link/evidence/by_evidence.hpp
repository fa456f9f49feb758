#pragma once

#include <quell/link/evidence/choose_by_evidence.hpp>
#include <quell/link/evidence/held_out.hpp>
#include <quell/link/evidence/judge.hpp>
#include <quell/pipeline/run.hpp>
#include <quell/pipeline/stand_ins.hpp>
#include <quell/pipeline/unfinished.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A pipeline with its history and without, put together by what samples speak for that neither has used (Evidence). Where light changes
/// faster than a history can follow, the frame alone has the say; else the history has.
///
///     constexpr auto denoise = presets::by_evidence(presets::general(radiance, Demodulate{})); // a ByEvidence
///     Frame frame{size, denoise};
///     History history{size, denoise};
///     auto const picture = run(denoise, frame, history);
///
/// Each frame is denoised once with its past and once by itself. A judge does both without the even pixels' samples, and without the odd
/// ones', and once more by itself with all samples, which the pipeline has done already where it is its own judge.
/// @tparam P     a Pipeline with a Temporal
/// @tparam Judge OwnJudge, or a Pipeline of the same signal that keeps and remembers nothing else: one that takes less time, as general
///               is for final_frame, or the same one with other numbers
template <class P, class Judge = OwnJudge> struct ByEvidence {
    static constexpr bool is_own_judge = std::is_same_v<Judge, OwnJudge>; ///< whether it was given no other, of whatever numbers
    using JudgePipeline = std::conditional_t<is_own_judge, P, Judge>;     ///< what samples are held out from
    static_assert(detail::has_one_history<P>, "ByEvidence{pipeline, judge, rule}: the first must be a Pipeline with a Temporal{...}, which "
                                              "alone has a history to choose");
    static_assert(!detail::has_one_history<P> || detail::can_judge<P, JudgePipeline>(),
                  "ByEvidence{pipeline, judge, rule}: the judge goes on from the pipeline's history: it must be a Pipeline of the same "
                  "signal and modulation that keeps and remembers no channel beside the pipeline's");
    using Output = typename P::Output;                                             ///< the channel of the picture
    using reads = decltype(typename P::reads{} | typename JudgePipeline::reads{}); ///< channels that the host must supply
    static constexpr MotionConvention motion_convention = P::motion_convention;    ///< what the host's motion vectors mean: see Supplied
    static constexpr bool needs_camera = P::needs_camera || JudgePipeline::needs_camera; ///< whether frame.camera must be set
    static constexpr bool checks_jitter =
        P::checks_jitter || JudgePipeline::checks_jitter; ///< whether frame.camera.jitter must be in range
    /// @cond
    using Choice = Pipeline<FirstEstimate<Output::components>, Spatial<ChooseByEvidence<Output>>>;
    /// @endcond

    P pipeline;    ///< what is put together
    Judge judge;   ///< what samples are held out from, if it isn't the pipeline
    Choice choice; ///< how

    /// @param p the pipeline
    /// @param r how samples are judged
    constexpr explicit ByEvidence(P const& p, Evidence const& r = {}) requires is_own_judge : ByEvidence(p, OwnJudge{}, r) {}
    /// @param p the pipeline
    /// @param j the judge
    /// @param r how samples are judged
    constexpr ByEvidence(P const& p, Judge const& j, Evidence const& r = {})
        : pipeline(p), judge(j), choice(FirstEstimate<Output::components>{}, Spatial{ChooseByEvidence<Output>{r}}) {}
    /// What samples are held out from: the pipeline, or the other judge.
    [[nodiscard]] constexpr JudgePipeline const& judging() const {
        if constexpr (is_own_judge)
            return pipeline;
        else
            return judge;
    }
    /// Of the checkerboard: how many are held out.
    [[nodiscard]] constexpr int halves() const { return std::get<0>(choice.stages).kernel.rule.both_halves ? 2 : 1; }
};
/// @cond
template <class P> ByEvidence(P) -> ByEvidence<P>;
template <class P> ByEvidence(P, Evidence) -> ByEvidence<P>;
template <class P, class Judge> ByEvidence(P, Judge) -> ByEvidence<P, Judge>;
template <class P, class Judge> ByEvidence(P, Judge, Evidence) -> ByEvidence<P, Judge>;
/// @endcond

namespace detail {
struct ByEvidenceRun;
}

/// The pipeline's history, and a copy of the samples, of which some are left out. What estimates need while they run is free for the next
/// one.
template <class P, class Judge, ImageStorage Storage> class History<ByEvidence<P, Judge>, Storage> {
    using All = ByEvidence<P, Judge>;

public:
    /// @param size    of the frames
    /// @param storage of histories and scratch
    /// @throws Error for a size without pixels
    explicit History(Extent size, All const&, [[maybe_unused]] Storage const& storage = {})
        : History(std::make_shared<detail::ImagePool>(detail::checked(size))) {}

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() { with.forget(); }
    /// Gives scratch back, and what run() returned: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() { choice.release_scratch(), alone.release_scratch(), judge.release_scratch(), with.release_scratch(); }
    /// Those of the pipeline with its history.
    [[nodiscard]] Statistics statistics() const { return with.statistics(); }
    /// Memory of histories, scratch and output, in bytes. Complete after the third frame.
    [[nodiscard]] std::size_t bytes() const { return pool->bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return with.bytes_per_pixel(); }

private:
    friend struct detail::ByEvidenceRun;
    friend struct detail::OpenHistory;
    friend struct detail::PassesOf<All>;

    std::shared_ptr<detail::ImagePool> pool; ///< of all histories
    History<P, Storage> with, alone;
    History<typename All::JudgePipeline, Storage> judge;
    History<typename All::Choice, Storage> choice;
    detail::KnownPast past;

    explicit History(std::shared_ptr<detail::ImagePool> shared)
        : pool(shared), with(shared), alone(shared), judge(shared), choice(shared) {}
};

namespace detail {
template <class P, class Judge> inline constexpr int kept_frames_of<ByEvidence<P, Judge>> = kept_frames_of<P>;
struct ByEvidenceRun {
    /// Denoises a frame. Returns a view of the output; empty where it went to a target.
    template <class P, class Judge, class Set, class FrameStorage, class Storage, class E, class Into>
    static auto all(ByEvidence<P, Judge> const& by_evidence, Frame<Set, FrameStorage> const& frame,
                    History<ByEvidence<P, Judge>, Storage>& history, E const& executor, Into const& into) {
        check_frame<ByEvidence<P, Judge>>(frame);
        Unfinished unfinished(history);
        using Output = typename P::Output;
        constexpr int n = Output::components;
        OpenHistory::images(history.choice).output = {};
        if (!(history.pool->size() == frame.size)) OpenHistory::images(history.with).restart(frame.size);
        auto& past = history.past;
        OpenHistory::images(history.with).tell(past);
        if (!past.is_before(frame.size, frame.number)) past.drop();

        auto const samples = history.pool->take(format_of<Storage, Output>);
        auto const seen = with_stand_ins<typename ByEvidence<P, Judge>::reads, Channels<Output>, Storage>(
            frame, [&](auto) { return view_in<Storage, Output>(samples); });
        auto const hold_out = [&](int half) {
            auto const to = view_in<Storage, Output>(samples);
            run_or_enqueue(executor, Region{0, 0, frame.size.width, frame.size.height},
                           HoldOut<ViewOf<FrameStorage, Output>, std::remove_const_t<decltype(to)>>{frame[Output{}].view(), to, half});
        };
        auto const made_by = [&](auto const& pipeline, auto& its_history, KnownPast const* from = nullptr) {
            auto& images = OpenHistory::images(its_history);
            if (from != nullptr && from->is_known)
                images.learn(*from);
            else
                images.forget();
            run(pipeline, seen, its_history, executor);
            auto made = std::exchange(images.output, {});
            images.drop_past();
            return made;
        };
        hold_out(none_held_out);
        auto const second = made_by(by_evidence.pipeline, history.alone);
        auto judged = second;
        if constexpr (!ByEvidence<P, Judge>::is_own_judge) judged = made_by(by_evidence.judging(), history.judge);
        PooledImage first_without[2], second_without[2];
        for (int half = 0; half < by_evidence.halves(); ++half) {
            hold_out(half);
            second_without[half] = made_by(by_evidence.judging(), history.judge);
            first_without[half] = made_by(by_evidence.judging(), history.judge, &past);
        }
        if (by_evidence.halves() == 1) first_without[1] = first_without[0], second_without[1] = second_without[0];
        past.drop();
        hold_out(none_held_out);
        auto const first = run(by_evidence.pipeline, seen, history.with, executor);

        using Estimates = Channels<FirstEstimate<n>, SecondEstimate<n>, FirstWithoutEven<n>, FirstWithoutOdd<n>, SecondWithoutEven<n>,
                                   SecondWithoutOdd<n>, SecondJudged<n>>;
        auto const estimates = with_stand_ins<typename ByEvidence<P, Judge>::Choice::reads, Estimates, Storage>(frame, [&]<class C>(C) {
            if constexpr (std::is_same_v<C, FirstEstimate<n>>)
                return first;
            else
                return view_in<Storage, Output>(std::is_same_v<C, SecondEstimate<n>>      ? second
                                                : std::is_same_v<C, FirstWithoutEven<n>>  ? first_without[0]
                                                : std::is_same_v<C, FirstWithoutOdd<n>>   ? first_without[1]
                                                : std::is_same_v<C, SecondWithoutEven<n>> ? second_without[0]
                                                : std::is_same_v<C, SecondWithoutOdd<n>>  ? second_without[1]
                                                                                          : judged);
        });
        constexpr auto stages = StageOrder<typename ByEvidence<P, Judge>::Choice>::count;
        auto const output = run_stages<stages>(by_evidence.choice, estimates, history.choice, executor, into);
        unfinished.finish();
        return output;
    }
};
template <class P, class Judge> struct PassesOf<ByEvidence<P, Judge>> {
    static void append(auto& passes, ByEvidence<P, Judge> const& all, auto& history) {
        enum class Samples { as_before, copied };
        auto const group = [&](char const* name, auto const& part, auto& its_history, Samples samples = Samples::as_before) {
            auto const before = passes.size();
            if (samples == Samples::copied)
                passes.push_back({.name = "hold samples out", .reads = {P::Output::name}, .writes = {P::Output::name}});
            PassesOf<std::remove_cvref_t<decltype(part)>>::append(passes, part, its_history);
            for (auto i = before; i < passes.size(); ++i) passes[i].denoises = name;
        };
        group("the frame alone", all.pipeline, history.alone, Samples::copied);
        if constexpr (!ByEvidence<P, Judge>::is_own_judge) group("judge: the frame alone", all.judging(), history.judge);
        constexpr char const* names[] = {"judge, without even pixels: the frame alone", "judge, without even pixels: with its history",
                                         "judge, without odd pixels: the frame alone", "judge, without odd pixels: with its history"};
        for (int i = 0; i < 2 * all.halves(); ++i)
            group(names[i], all.judging(), history.judge, i % 2 == 0 ? Samples::copied : Samples::as_before);
        group("with its history", all.pipeline, history.with, Samples::copied);
        group("choice", all.choice, history.choice);
    }
};
} // namespace detail

/// As far back as the pipeline looks.
template <class P, class Judge> [[nodiscard]] constexpr int warm_up_frames(ByEvidence<P, Judge> const& by_evidence) {
    return warm_up_frames(by_evidence.pipeline);
}

/// Denoises one frame with its history and without, and puts both together. Returns a view of the picture, valid until the next run with
/// this history.
/// @param by_evidence the pipeline, its judge, and how samples are judged
/// @param frame    as for run() of a Pipeline
/// @param history  of this ByEvidence
/// @param executor as that of run() of a Pipeline
/// @throws Error as run() of a Pipeline does
template <class P, class Judge, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(ByEvidence<P, Judge> const& by_evidence, Frame<Set, FrameStorage> const& frame, History<ByEvidence<P, Judge>, Storage>& history,
         E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename ByEvidence<P, Judge>::reads, Set>;
    static_assert(has_channels,
                  "run(by_evidence, frame, ...): the frame lacks a channel that the pipeline or its judge reads; construct the "
                  "frame with this ByEvidence");
    if constexpr (!has_channels)
        return detail::NoOutput{};
    else
        return detail::ByEvidenceRun::all(by_evidence, frame, history, executor, detail::NoTarget{});
}

/// Like run(), but writes the picture through a view of the host's, as run_into() of a Pipeline does.
/// @param target      where the picture goes
/// @param by_evidence as for run()
/// @param frame       as for run()
/// @param history     as for run()
/// @param executor    as for run()
/// @throws Error as run() does, and for a target that is not of the frame's size
template <class P, class Judge, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, ByEvidence<P, Judge> const& by_evidence, Frame<Set, FrameStorage> const& frame,
              History<ByEvidence<P, Judge>, Storage>& history, E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename ByEvidence<P, Judge>::reads, Set>;
    static_assert(has_channels,
                  "run_into(target, by_evidence, frame, ...): the frame lacks a channel that the pipeline or its judge reads; "
                  "construct the frame with this ByEvidence");
    static_assert(Target::components == P::Output::components,
                  "run_into(target, by_evidence, frame, ...): the target has another number of components than the pipeline's signal");
    if constexpr (has_channels && Target::components == P::Output::components) {
        detail::check_target(target.size, frame.size);
        detail::ByEvidenceRun::all(by_evidence, frame, history, executor, target);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
