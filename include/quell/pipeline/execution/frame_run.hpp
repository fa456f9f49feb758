#pragma once

#include <quell/pipeline/execution/check_frame.hpp>
#include <quell/pipeline/execution/guides.hpp>
#include <quell/pipeline/execution/job.hpp>
#include <quell/pipeline/execution/pass_scopes.hpp>
#include <quell/pipeline/execution/readers.hpp>
#include <quell/pipeline/fill_holes.hpp>
#include <quell/pipeline/history.hpp>
#include <quell/pipeline/stage_order.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Runs one frame through a pipeline: the ingest, then each pass, with views of exactly the channels that it declares.
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
    using Order = StageOrder<P>;

    using Scopes = PassScopes<P, Set, FrameStorage, Storage>;
    template <class Pass, bool raw> using ScopeOf = typename Scopes::template Of<Pass, raw>;
    using FinishScope = typename Scopes::Finish;

    P const& pipeline;
    Frame<Set, FrameStorage> const& frame;
    History<P, Storage>& history;
    E const& executor;
    Into const& into;
    Guides<Set, FrameStorage> given{frame};

    PooledImage<SignalImage> current;
    Handles<Storage, typename P::made> made;
    Readers<typename P::made> readers; ///< passes that still have to read each channel that passes make
    int passes_left = 0;
    bool past = false;
    bool nothing_seen = false; ///< whether all samples are missing
    bool marked = true;        ///< whether the current signal marks missing samples
    PixelRays rays, rays_then;
    std::int32_t frame_index = 0;

public:
    Run(P const& p, Frame<Set, FrameStorage> const& f, History<P, Storage>& h, E const& e, Into const& i)
        : pipeline(p), frame(f), history(h), executor(e), into(i) {}

    /// The whole pipeline.
    OutputView all() { return through<Order::count>(); }
    /// The ingest and the stages up to Temporal. Returns the accumulated signal.
    OutputView accumulated() {
        static_assert(P::has_past, "accumulate(pipeline, ...): the pipeline has no Temporal{...}, so there is nothing to accumulate");
        return through<Order::up_to_temporal>();
    }

private:
    /// The ingest and the first `stage_count` stages.
    template <std::size_t stage_count> OutputView through() {
        constexpr std::make_index_sequence<stage_count> all_of_them{};
        check_frame<P>(frame);
        begin();
        bool ends_with_signal = false;
        for_each_pass(all_of_them, [&]<class Kernel>(Kernel const&) {
            ++passes_left, ends_with_signal = makes_signal<Kernel>;
            readers.template expect<Kernel>();
        });
        if (!ends_with_signal) ++passes_left;
        ingest();
        stages(all_of_them);
        if (!ends_with_signal) pass_through();
        end();
        return history.output ? history.output.view() : OutputView{};
    }
    template <std::size_t... i> void for_each_pass(std::index_sequence<i...>, auto&& visit) const {
        (detail::for_each_pass(std::get<i>(pipeline.stages), visit), ...);
    }

    template <class Kernel>
    static constexpr bool makes_signal = makes_signal_of<std::remove_cvref_t<Kernel>, ScopeOf<std::remove_cvref_t<Kernel>, true>>;
    void pass_through() {
        if constexpr (Order::may_end_without_signal && P::has_past)
            pass<false>(PassThrough{});
        else if constexpr (Order::may_end_without_signal) {
            if (marked)
                pass<true>(PassThrough{});
            else
                pass<false>(PassThrough{});
        }
    }

    void begin() {
        past = history.start(frame.size, frame.number);
        if constexpr (P::needs_camera) {
            rays = PixelRays(frame.camera, frame.size);
            rays_then = PixelRays(past ? history.then.camera : frame.camera, frame.size);
        }
        frame_index = static_cast<std::int32_t>(frame.number.value_or(history.counted.frames));
    }

    void end() {
        for_each_channel(typename P::keeps{}, [&](auto c) { history.now.kept[c] = made[c]; });
        history.advance(frame);
        // What no sample was ever seen of is no past.
        history.empty = !P::has_past || (!past && nothing_seen);
        ++history.counted.frames;
    }

    void ingest() {
        auto &first = *history.counts, &again = *history.counts_again;
        first.reset(), again.reset();
        run_pass<false>(pipeline.ingest, false, &first);
        bool const repeat = given.template repair<typename P::reads, reads_of<typename P::Form>>(first.guides, *history.pool, executor);
        if (repeat) run_pass<false>(pipeline.ingest, false, &again);
        auto& counts = repeat ? again : first;
        history.note(first.guides, counts);
        nothing_seen = counts.missing == frame.size.pixels();
        if (nothing_seen && past) run_pass<true>(FillHoles{0}, false, nullptr);
        for (int step = 2; counts.holes > 0 && !nothing_seen; step *= 2) counts.holes = 0, run_pass<true>(FillHoles{step}, false, &counts);
    }

    /// Passes see marks of missing samples until Temporal, which keeps the history there; without a Temporal, until one has made a new
    /// signal.
    template <std::size_t... i> void stages(std::index_sequence<i...>) { (stage<i>(std::get<i>(pipeline.stages)), ...); }
    template <std::size_t i, class Stage> void stage(Stage const& s) {
        detail::for_each_pass(s, [&](auto const& kernel) {
            static_assert(!leaves_signal<Stage> || !makes_signal<decltype(kernel)>,
                          "Spatial{filter}: a pass of a filter that says `leaves_signal` makes the signal: give it emit_channels(px)");
            if constexpr (!Order::template may_be_marked<i>)
                pass<false>(kernel);
            else if constexpr (P::has_past || leaves_signal<Stage>)
                pass<true>(kernel);
            else if (marked)
                pass<true>(kernel);
            else
                pass<false>(kernel);
            marked = marked && !makes_signal<decltype(kernel)>;
            if constexpr (is_temporal<Stage> && !Order::template past_wanted_behind<i>) drop_past();
        });
    }
    void drop_past() {
        history.then.signal = {};
        history.then.kept.drop_all();
    }

    template <bool raw, class Pass> void pass(Pass const& kernel) {
        run_pass<raw>(kernel, --passes_left == 0, nullptr);
        if (P::has_past && (is_temporal<Pass> || feeds_back(kernel))) history.now.signal = current;
    }

    template <bool raw, class Pass> void run_pass(Pass const& kernel, bool last, Counts* counts) {
        using S = ScopeOf<Pass, raw>;
        using Made = decltype(emits_of<Pass>{} | keeps_of<Pass>{});
        constexpr bool keeps_marks = raw && P::has_past && !is_temporal<Pass> && !std::is_same_v<Pass, FillHoles>;
        bool const goes_on = !last || is_temporal<Pass> || feeds_back(kernel);

        Handles<Storage, Made> next_made;
        next_made.take_all(*history.pool);
        auto next = current;
        if (makes_signal<Pass>) next = goes_on ? history.pool->template take<SignalImage>() : PooledImage<SignalImage>{};
        auto const seen = scope<S, Pass>();
        if (last) prepare_end(remembers_of<Pass>::size > 0, next);

        auto job = Job<Pass, S, SignalView, decltype(next_made.views(Made{})), decltype(finish()), Remembers, keeps_marks>{
            .pass = kernel,
            .scope = seen,
            .signal = next ? next.view() : SignalView{},
            .made = next_made.views(Made{}),
            .finish = finish(),
            .store_signal = goes_on && makes_signal<Pass>,
            .store_output = last && stores_output(next),
            .store_remembered = last && Remembers::size > 0,
            .counts = counts};
        executor.for_each_pixel(Region{0, 0, seen.size.width, seen.size.height}, job);
        current = next;
        for_each_channel(Made{}, [&](auto c) { made[c] = next_made[c]; });
        readers.template done<Pass>();
        for_each_channel(without<typename P::made, typename P::keeps>{}, [&](auto c) {
            if (!readers.any(c)) made[c] = {};
        });
    }

    /// The last pass also writes the guides for the next frame, and the output, unless that is the signal's image. Guides of the last frame
    /// that it doesn't read are overwritten in place.
    void prepare_end(bool reads_guides, PooledImage<SignalImage> const& next) {
        if (past && !reads_guides)
            history.now.guides = std::exchange(history.then.guides, {});
        else
            history.now.guides.take_all(*history.pool);
        if constexpr (std::is_same_v<Into, NoTarget>) {
            if constexpr (!remodulates) history.output = next;
            if (!history.output) history.output = history.pool->template take<Output>();
        }
    }
    static constexpr bool remodulates = !std::is_same_v<typename P::Form, NoModulation>;

    bool stores_output(PooledImage<SignalImage> const& next) const {
        if constexpr (remodulates || !std::is_same_v<Into, NoTarget>)
            return true;
        else
            return !(history.output == next);
    }

    template <class S, class Pass> S scope() const {
        auto const& then = history.then;
        return {.size = divided(frame.size, S::fraction),
                .frame = given.views(typename S::frame_channels{}),
                .made = made.views(typename S::made_channels{}),
                .signal = current ? current.view() : SignalView{},
                .signal_then = then.signal ? then.signal.view() : SignalView{},
                .kept_then = then.kept.views(typename S::kept_channels{}),
                .remembered = then.guides.views(typename StoredChannels<remembers_of<Pass>>::type{}),
                .clip_from_world = frame.camera.clip_from_world(),
                .clip_from_world_then = (past ? then.camera : frame.camera).clip_from_world(),
                .rays = rays,
                .rays_then = rays_then,
                .jitter = frame.camera.jitter,
                .jitter_then = then.camera.jitter,
                .shutter = frame.shutter,
                .shutter_then = then.shutter,
                .frame_index = frame_index,
                .has_past = past && then.signal,
                .vectors = vectors()};
    }
    Vectors vectors() const { return {frame.size, frame.camera.jitter, history.then.camera.jitter}; }

    auto finish() const {
        FinishScope const scope{.size = frame.size, .frame = given.views(typename FinishScope::frame_channels{}), .vectors = vectors()};
        auto const guides = history.now.guides.views(typename History<P, Storage>::State::Guides{});
        auto const ending = [&]<class Target>(Target const& target) {
            return Finish<typename P::Form, FinishScope, Target, decltype(guides)>{
                .modulation = pipeline.ingest.modulation, .scope = scope, .output = target, .remembered = guides};
        };
        if constexpr (std::is_same_v<Into, NoTarget>)
            return ending(history.output ? history.output.view() : OutputView{});
        else
            return ending(into);
    }
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
