#pragma once

#include <quell/pipeline/run.hpp>
#include <quell/resolve/evidence_passes.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Whether it is a pipeline with a history, and no composite.
template <class P> inline constexpr bool has_one_history = false;
template <ChannelTag S, class... Parts> inline constexpr bool has_one_history<Pipeline<S, Parts...>> = Pipeline<S, Parts...>::has_past;
/// Whether a judge can go on from where a pipeline is.
template <class P, class Judge> constexpr bool can_judge() {
    if constexpr (has_one_history<P> && has_one_history<Judge>)
        return std::is_same_v<typename P::Output, typename Judge::Output> && std::is_same_v<typename P::Form, typename Judge::Form> &&
               contained_in<typename Judge::keeps, typename P::keeps> &&
               contained_in<typename StoredChannels<typename Judge::remembers>::type, typename StoredChannels<typename P::remembers>::type>;
    else
        return false;
}
} // namespace detail

/// A pipeline with its history and without, put together by what samples speak for that neither has used (Evidence). Where light changes
/// faster than a history can follow, the frame alone has the say; else the history has.
///
///     constexpr auto denoise = presets::by_evidence(presets::general(radiance, Demodulate{})); // a ByEvidence
///     Frame frame{size, denoise};
///     History history{size, denoise};
///     auto const picture = run(denoise, frame, history);
///
/// Each frame with a past is denoised once with it and once by itself. A judge does both without the even pixels' samples, and without the
/// odd ones', and once more by itself with all samples, which the pipeline has done already where it is its own judge.
/// @tparam P     a Pipeline with a Temporal
/// @tparam Judge a Pipeline of the same signal that keeps and remembers nothing else: the same one, or one that takes less time, as
///               general is for final_frame
template <class P, class Judge = P> struct ByEvidence {
    static_assert(detail::has_one_history<P>, "ByEvidence{pipeline, judge, rule}: the first must be a Pipeline with a Temporal{...}, which "
                                              "alone has a history to choose");
    static_assert(!detail::has_one_history<P> || detail::can_judge<P, Judge>(),
                  "ByEvidence{pipeline, judge, rule}: the judge goes on from the pipeline's history: it must be a Pipeline of the same "
                  "signal and modulation that keeps and remembers no channel beside the pipeline's");
    using Output = typename P::Output;                                           ///< the channel of the picture
    using reads = decltype(typename P::reads{} | typename Judge::reads{});       ///< channels that the host must supply
    static constexpr MotionConvention motion_convention = P::motion_convention;  ///< what the host's motion vectors mean: see Supplied
    static constexpr bool needs_camera = P::needs_camera || Judge::needs_camera; ///< whether frame.camera must be set
    static constexpr bool is_own_judge = std::is_same_v<P, Judge>;               ///< whether both are of one type

    P pipeline;    ///< what is put together
    Judge judge;   ///< what samples are held out from; where it has the pipeline's type, it is the pipeline
    Evidence rule; ///< how they are judged

    /// @param p the pipeline
    /// @param r how samples are judged
    constexpr explicit ByEvidence(P const& p, Evidence const& r = {}) requires is_own_judge : pipeline(p), judge(p), rule(r) {}
    /// @param p the pipeline
    /// @param j the judge
    /// @param r how samples are judged
    constexpr ByEvidence(P const& p, Judge const& j, Evidence const& r = {}) : pipeline(p), judge(j), rule(r) {}
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

/// The pipeline's history, and a copy of the frame's channels of which samples are left out. What estimates need while they run is free for
/// the next one.
template <class P, class Judge, ImageStorage Storage> class History<ByEvidence<P, Judge>, Storage> {
    using Choice = ByEvidence<P, Judge>;

public:
    /// @param size    of the frames
    /// @param choice  a pipeline and its judge
    /// @param storage of histories and scratch
    /// @throws Error for a size without pixels
    explicit History(Extent size, Choice const& choice, [[maybe_unused]] Storage const& storage = {})
        : History(std::make_shared<detail::ImagePool>(detail::checked(size)), choice) {}

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() { with.forget(); }
    /// Gives scratch back, and what run() returned: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() {
        output = {};
        mix.release(), given = Given({1, 1});
        alone.release_scratch(), judge.release_scratch(), with.release_scratch();
    }
    /// Those of the pipeline with its history.
    [[nodiscard]] Statistics statistics() const { return with.statistics(); }
    /// Whether the last frame was put together from two estimates: it had a past.
    [[nodiscard]] bool has_chosen() const { return chosen; }
    /// Memory of histories, scratch, output and the copy of the frame, in bytes. Complete after the third frame.
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = pool->bytes() + mix.bytes();
        for_each_channel(typename Choice::reads{}, [&](auto c) { sum += given[c].bytes(); });
        return sum;
    }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(given.size.pixels()); }

private:
    friend struct detail::ByEvidenceRun;
    friend struct detail::OpenHistory;
    using Given = Frame<typename Choice::reads, typename Storage::Exact>;

    std::shared_ptr<detail::ImagePool> pool; ///< of all histories
    History<P, Storage> with, alone;
    History<Judge, Storage> judge;
    Given given;
    EvidenceMix<MemoryOf<Storage>> mix;
    detail::KnownPast past;
    detail::PooledImage output;
    bool chosen = false;

    explicit History(std::shared_ptr<detail::ImagePool> shared, Choice const&)
        : pool(shared), with(shared), alone(shared), judge(shared), given(shared->size()) {}
};

namespace detail {
struct ByEvidenceRun {
    /// Denoises a frame. Returns a view of the output; that is `target`, if it isn't NoTarget.
    template <class P, class Judge, class Set, class FrameStorage, class Storage, class E, class Target>
    static auto all(ByEvidence<P, Judge> const& choice, Frame<Set, FrameStorage> const& frame,
                    History<ByEvidence<P, Judge>, Storage>& history, E const& executor, Target const& target) {
        check_frame<ByEvidence<P, Judge>>(frame);
        constexpr bool has_target = !std::is_same_v<Target, NoTarget>;
        using Output = typename P::Output;
        auto &with = OpenHistory::images(history.with), &alone = OpenHistory::images(history.alone);
        history.output = {};
        copy_frame(frame, history, executor);
        with.tell(history.past);
        history.chosen = history.past.is_before(frame.size, frame.number);
        if (history.chosen) look_at_samples(choice, frame[Output{}].view(), history, executor);
        history.past.drop();
        auto const with_history = run(choice.pipeline, history.given, history.with, executor);
        auto const to = [&] {
            if constexpr (has_target)
                return target;
            else {
                history.output = history.chosen ? history.pool->take(format_of<Storage, Output>) : with.output;
                return view_in<Storage, Output>(history.output);
            }
        }();
        if (history.chosen)
            history.mix.mix(choice.rule, executor, with_history, view_in<Storage, Output>(alone.output), to);
        else if constexpr (has_target)
            copy(executor, with_history, to);
        alone.drop_past();
        submit_queue(executor);
        return to;
    }

private:
    template <class From, class To> static void copy(auto const& executor, From const& from, To const& to, int left_out = -1) {
        run_or_enqueue(executor, Region{0, 0, to.size.width, to.size.height}, CopyAllBut<From, To>{from, to, left_out});
    }
    static void copy_frame(auto const& frame, auto& history, auto const& executor) {
        auto& given = history.given;
        using Given = std::remove_reference_t<decltype(given)>;
        if (!(given.size == frame.size)) given = Given(frame.size);
        given.camera = frame.camera, given.number = frame.number, given.shutter = frame.shutter;
        for_each_channel(typename Given::channels{}, [&](auto c) { copy(executor, frame[c].view(), given[c].view()); });
    }
    /// Leaves in `alone` what the pipeline makes of the frame by itself.
    template <class P, class Judge, class Storage>
    static void look_at_samples(ByEvidence<P, Judge> const& choice, auto const& samples, History<ByEvidence<P, Judge>, Storage>& history,
                                auto const& executor) {
        auto &alone = OpenHistory::images(history.alone), &judge = OpenHistory::images(history.judge);
        auto const light = history.given[typename P::Output{}].view();
        alone.forget();
        auto b_with = run(choice.pipeline, history.given, history.alone, executor);
        alone.then.drop_images();
        PooledImage held, held_b;
        if constexpr (!ByEvidence<P, Judge>::is_own_judge) {
            judge.forget();
            b_with = run(choice.judge, history.given, history.judge, executor), held = judge.output;
        }
        for (int const left_out : {0, 1}) {
            copy(executor, samples, light, left_out);
            judge.forget();
            auto const b = run(choice.judge, history.given, history.judge, executor);
            held_b = judge.output; // as long as the next run
            judge.learn(history.past);
            auto const a = run(choice.judge, history.given, history.judge, executor);
            history.mix.judge(choice.rule, executor, left_out, samples, a, b, b_with);
        }
        judge.drop_past();
        copy(executor, samples, light);
    }
};
} // namespace detail

/// Denoises one frame with its history and without, and puts both together. Returns a view of the picture, valid until the next run with
/// this history.
/// @param choice   the pipeline, its judge, and how samples are judged
/// @param frame    as for run() of a Pipeline; it is copied
/// @param history  of this ByEvidence
/// @param executor as that of run() of a Pipeline
/// @throws Error as run() of a Pipeline does
template <class P, class Judge, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(ByEvidence<P, Judge> const& choice, Frame<Set, FrameStorage> const& frame, History<ByEvidence<P, Judge>, Storage>& history,
         E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename ByEvidence<P, Judge>::reads, Set>;
    static_assert(has_channels, "run(choice, frame, ...): the frame lacks a channel that the pipeline or its judge reads; construct the "
                                "frame with this ByEvidence");
    if constexpr (!has_channels)
        return detail::NoOutput{};
    else
        return detail::ByEvidenceRun::all(choice, frame, history, executor, detail::NoTarget{});
}

/// Like run(), but writes the picture through a view of the host's, as run_into() of a Pipeline does.
/// @param target   where the picture goes
/// @param choice   as for run()
/// @param frame    as for run()
/// @param history  as for run()
/// @param executor as for run()
/// @throws Error as run() does, and for a target that is not of the frame's size
template <class P, class Judge, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, ByEvidence<P, Judge> const& choice, Frame<Set, FrameStorage> const& frame,
              History<ByEvidence<P, Judge>, Storage>& history, E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename ByEvidence<P, Judge>::reads, Set>;
    static_assert(has_channels, "run_into(target, choice, frame, ...): the frame lacks a channel that the pipeline or its judge reads; "
                                "construct the frame with this ByEvidence");
    static_assert(Target::components == P::Output::components,
                  "run_into(target, choice, frame, ...): the target has another number of components than the pipeline's signal");
    if constexpr (has_channels && Target::components == P::Output::components) {
        detail::check_target(target.size, frame.size);
        detail::ByEvidenceRun::all(choice, frame, history, executor, target);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
