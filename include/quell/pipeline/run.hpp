#pragma once

#include <quell/pipeline/check_frame.hpp>
#include <quell/pipeline/history.hpp>
#include <quell/pipeline/job.hpp>

namespace quell {

namespace detail {
/// One frame's way through a pipeline: ingest, then pass after pass, each with views of exactly what it declares.
template <class P, class FrameT, class H, class E, class Into> class Run;

template <class P, class Set, class FrameStorage, class Storage, class E, class Into>
class Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, Into> {
    using Signal = typename P::Signal;
    using SignalImage = ImageOf<Storage, Signal>;
    using SignalView = ViewOf<Storage, Signal>;
    using Output = ImageOf<Storage, typename P::Output>;
    using OutputView = ViewOf<Storage, typename P::Output>;
    using Remembers = typename P::remembers;
    using Vectors = VectorConversion<P::motion_convention>;
    using NoViews = Views<Storage, Channels<>>;

    template <class Pass, bool raw>
    using ScopeOf = Scope<Views<FrameStorage, common_to<decltype(reads_of<Pass>{} | typename P::known_samples{}), Set>>,
                          Views<Storage, common_to<reads_of<Pass>, typename P::made>>, SignalView, SignalView,
                          Views<Storage, decltype(keeps_of<Pass>{} | reads_kept_of<Pass>{})>,
                          RememberedViewsOf<Storage, remembers_of<Pass>>, raw, Vectors>;
    using FinishReads = decltype(reads_of<typename P::Form>{} | Remembers{});
    using FinishScope = Scope<Views<FrameStorage, FinishReads>, NoViews, SignalView, SignalView, NoViews,
                              RememberedViewsOf<Storage, Channels<>>, false, Vectors>;

    P const& pipeline;
    Frame<Set, FrameStorage> const& frame;
    History<P, Storage>& history;
    E const& executor;
    Into const& into;

    std::shared_ptr<SignalImage> current, for_history;
    Handles<Storage, typename P::made> made;
    Handles<Storage, typename History<P, Storage>::Remembered> remembered;
    int passes_left = 0;
    bool past = false;
    bool marked = true; ///< whether the current signal marks missing samples
    PixelRays rays, rays_then;
    std::int32_t frame_index = 0;

public:
    Run(P const& p, Frame<Set, FrameStorage> const& f, History<P, Storage>& h, E const& e, Into const& i)
        : pipeline(p), frame(f), history(h), executor(e), into(i) {}

    OutputView all() {
        check_frame<P>(frame);
        begin();
        bool ends_with_signal = false;
        pipeline.for_each_pass([&](auto const& kernel) { ++passes_left, ends_with_signal = makes_signal<decltype(kernel)>; });
        if (!ends_with_signal) ++passes_left;
        ingest();
        stages(std::make_index_sequence<stage_count>{});
        if (!ends_with_signal) pass_through();
        end();
        return history.output ? history.output->view() : OutputView{};
    }

    /// The ingest and the stages up to Temporal: what the history is to know of this frame, and what it says then.
    OutputView accumulated() {
        static_assert(P::has_past, "accumulate(pipeline, ...): the pipeline has no Temporal{...}, so there is nothing to accumulate");
        check_frame<P>(frame);
        begin();
        passes_left = passes_of_first(std::make_index_sequence<up_to_temporal>{});
        ingest();
        stages(std::make_index_sequence<up_to_temporal>{});
        end();
        return history.output->view();
    }

private:
    static constexpr std::size_t stage_count = std::tuple_size_v<decltype(P::stages)>;
    template <std::size_t i> using StageAt = std::tuple_element_t<i, decltype(P::stages)>;
    /// How many stages there are up to Temporal, which is one of them.
    static constexpr std::size_t up_to_temporal = []<std::size_t... i>(std::index_sequence<i...>) {
        std::size_t count = 0;
        static_cast<void>(((++count, is_temporal<StageAt<i>>) || ...));
        return count;
    }
    (std::make_index_sequence<stage_count>{});
    template <std::size_t... i> int passes_of_first(std::index_sequence<i...>) const {
        int count = 0;
        (detail::for_each_pass(std::get<i>(pipeline.stages), [&](auto const&) { ++count; }), ...);
        return count;
    }
    template <class Kernel>
    static constexpr bool makes_signal = makes_signal_of<std::remove_cvref_t<Kernel>, ScopeOf<std::remove_cvref_t<Kernel>, true>>;
    template <class Stage>
    static constexpr bool always_makes_signal =
        is_temporal<Stage> || !(leaves_signal<Stage> || requires(Stage s) { s.kernel.for_each_pass(AnyPass{}); });
    /// Where nothing behind Temporal makes a new signal, the last one does not write the output either.
    static constexpr bool may_end_without_signal = [] {
        if constexpr (stage_count == 0)
            return true;
        else
            return !always_makes_signal<StageAt<stage_count - 1>>;
    }();
    void pass_through() {
        if constexpr (may_end_without_signal && P::has_past)
            pass<false>(PassThrough{});
        else if constexpr (may_end_without_signal) {
            if (marked)
                pass<true>(PassThrough{});
            else
                pass<false>(PassThrough{});
        }
    }

    void begin() {
        bool const follows = !frame.number || !history.number || *frame.number == *history.number + 1;
        if (!(history.pool.size() == frame.size)) history.restart(frame.size);
        if (!follows) history.empty = true;
        past = !history.empty;
        if (!past) ++history.counted.resets, history.counted.frames = 0;
        // Until the frame is complete there is no history: an exception on the way must not leave half of one.
        history.empty = true;
        history.output.reset();
        if constexpr (P::needs_camera) {
            rays = PixelRays(frame.camera, frame.size);
            rays_then = PixelRays(past ? history.camera : frame.camera, frame.size);
        }
        frame_index = static_cast<std::int32_t>(frame.number.value_or(history.counted.frames));
    }

    void end() {
        if constexpr (P::has_past) history.signal = for_history;
        for_each_channel(typename P::keeps{}, [&](auto c) { history.kept[c] = made[c]; });
        history.remembered = remembered;
        history.camera = frame.camera;
        history.shutter = frame.shutter;
        history.number = frame.number;
        history.empty = !P::has_past;
        ++history.counted.frames;
    }

    void ingest() {
        Counts counts;
        run<false>(pipeline.ingest, false, &counts);
        history.counted.missing_samples = counts.missing;
        history.counted.suppressed = counts.suppressed.total();
    }

    /// Passes see the marks of missing samples up to Temporal, which keeps the past there; without a Temporal, until one of them has made a
    /// signal of its own.
    template <std::size_t... i> void stages(std::index_sequence<i...>) { (stage<i>(std::get<i>(pipeline.stages)), ...); }
    template <std::size_t... before> static constexpr bool may_be_marked(std::index_sequence<before...>) {
        return !(... || (P::has_past ? is_temporal<StageAt<before>> : !leaves_signal<StageAt<before>>));
    }
    template <std::size_t i, class Stage> void stage(Stage const& s) {
        detail::for_each_pass(s, [&](auto const& kernel) {
            if constexpr (!may_be_marked(std::make_index_sequence<i>{}))
                pass<false>(kernel);
            else if constexpr (P::has_past || leaves_signal<Stage>)
                pass<true>(kernel);
            else if (marked)
                pass<true>(kernel);
            else
                pass<false>(kernel);
            marked = marked && !makes_signal<decltype(kernel)>;
            if constexpr (is_temporal<Stage> && !past_wanted_behind(std::make_index_sequence<stage_count - i - 1>{})) drop_past();
        });
    }
    /// Whether a filter behind Temporal, which is followed by these many stages, looks at the last frame.
    template <std::size_t... behind> static constexpr bool past_wanted_behind(std::index_sequence<behind...>) {
        return (... || (remembers_of<StageAt<stage_count - 1 - behind>>::size > 0));
    }
    void drop_past() {
        history.signal.reset();
        history.kept.drop_all();
    }

    template <bool raw, class Pass> void pass(Pass const& kernel) {
        run<raw>(kernel, --passes_left == 0, nullptr);
        if constexpr (is_temporal<Pass>) for_history = current;
        if constexpr (requires { kernel.feedback; })
            if (kernel.feedback) for_history = current;
    }

    template <bool raw, class Pass> void run(Pass const& kernel, bool last, Counts* counts) {
        using S = ScopeOf<Pass, raw>;
        using Made = decltype(emits_of<Pass>{} | keeps_of<Pass>{});
        constexpr bool keeps_marks = raw && P::has_past && !is_temporal<Pass>;
        bool const goes_on = !last || is_temporal<Pass> || feeds_back(kernel);

        Handles<Storage, Made> next_made;
        next_made.take_all(history.pool);
        auto next = current;
        if (makes_signal<Pass>) next = goes_on ? history.pool.template take<SignalImage>() : nullptr;
        auto const seen = scope<S, Pass>();
        if (last) prepare_end(remembers_of<Pass>::size > 0, next);

        auto job = Job<Pass, S, SignalView, decltype(next_made.views(Made{})), decltype(finish()), Remembers, keeps_marks>{
            kernel,
            seen,
            next ? next->view() : SignalView{},
            next_made.views(Made{}),
            finish(),
            goes_on && makes_signal<Pass>,
            last && stores_output(next),
            last && Remembers::size > 0,
            counts};
        executor.for_each_pixel(Region{0, 0, frame.size.width, frame.size.height}, job);
        current = next;
        for_each_channel(Made{}, [&](auto c) { made[c] = next_made[c]; });
    }

    template <class Pass> static bool feeds_back(Pass const& kernel) {
        if constexpr (requires { kernel.feedback; })
            return kernel.feedback;
        else
            return false;
    }

    /// The last pass writes the output, unless that is the very image which goes into the history, and what is remembered of this frame:
    /// over the old, unless this pass still reads the old.
    void prepare_end(bool reads_remembered, std::shared_ptr<SignalImage> const& next) {
        if (!reads_remembered) history.remembered.drop_all();
        remembered.take_all(history.pool);
        if constexpr (std::is_same_v<Into, NoTarget>) {
            if constexpr (!remodulates) history.output = next;
            if (!history.output) history.output = history.pool.template take<Output>();
        }
        history.remembered.drop_all();
    }
    static constexpr bool remodulates = !std::is_same_v<typename P::Form, NoModulation>;

    bool stores_output(std::shared_ptr<SignalImage> const& next) const {
        if constexpr (remodulates || !std::is_same_v<Into, NoTarget>)
            return true;
        else
            return history.output != next;
    }

    template <class S, class Pass> S scope() const {
        auto then = RememberedViewsOf<Storage, remembers_of<Pass>>{};
        return {frame.size,
                frame.views(typename S::frame_channels{}),
                made.views(typename S::made_channels{}),
                current ? current->view() : SignalView{},
                history.signal ? history.signal->view() : SignalView{},
                history.kept.views(typename S::kept_channels{}),
                remembered_views(typename StoredChannels<typename decltype(then)::channels>::type{}),
                frame.camera.clip_from_world(),
                (past ? history.camera : frame.camera).clip_from_world(),
                rays,
                rays_then,
                frame.camera.jitter,
                history.camera.jitter,
                frame.shutter,
                history.shutter,
                frame_index,
                past && history.signal != nullptr,
                vectors()};
    }
    Vectors vectors() const { return {frame.size, frame.camera.jitter, history.camera.jitter}; }
    template <class Stored> auto remembered_views(Stored) const { return history.remembered.views(Stored{}); }

    auto finish() const {
        FinishScope const scope{frame.size, frame.views(FinishReads{}), {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0, false,
                                vectors()};
        auto const views = remembered.views(typename History<P, Storage>::Remembered{});
        if constexpr (std::is_same_v<Into, NoTarget>) {
            auto const target = history.output ? history.output->view() : OutputView{};
            return Finish<typename P::Form, FinishScope, OutputView, decltype(views)>{pipeline.ingest.modulation, scope, target, views};
        } else
            return Finish<typename P::Form, FinishScope, Into, decltype(views)>{pipeline.ingest.modulation, scope, into, views};
    }
};
} // namespace detail

/// Denoises one frame. Returns a view of the output, which stays valid until the history's next run:
///     auto clean = run(denoise, frame, history, Threads{});    clean.get(component, x, y)
/// @throws Error for images whose sizes differ, memory that is missing, and cameras that a motion source needs and that are singular
template <class P, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>,
                  "run(pipeline, frame, ...): the frame lacks a channel that the pipeline reads; construct the frame with this pipeline");
    detail::NoTarget const none;
    return detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, detail::NoTarget>(pipeline, frame, history, executor, none)
        .all();
}

/// Adds a frame to the history and does no more: the filters behind Temporal are left out. Returns a view of what the history then shows,
/// which stays valid until the history's next run. For frames that serve others: those of a warm-up, those after the one that is wanted
/// (pipeline/two_sided.hpp).
/// @throws Error as run() does
template <class P, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto accumulate(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>, "accumulate(pipeline, frame, ...): the frame lacks a channel that the pipeline "
                                                        "reads; construct the frame with this pipeline");
    detail::NoTarget const none;
    return detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, detail::NoTarget>(pipeline, frame, history, executor, none)
        .accumulated();
}

/// run(), writing the output through a view of the host's own.
/// @throws Error as run() does, and for a target of another size
template <class P, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history,
              E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>, "run_into(target, pipeline, frame, ...): the frame lacks a channel that the "
                                                        "pipeline reads; construct the frame with this pipeline");
    static_assert(Target::components == P::Output::components,
                  "run_into(target, pipeline, frame, ...): the target has another number of components than the pipeline's signal");
    if (!(target.size == frame.size))
        throw Error("run_into: the target", to_string(target.size) + " for a frame of " + to_string(frame.size),
                    "give it the frame's size");
    detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, Target>(pipeline, frame, history, executor, target).all();
}

} // namespace quell
