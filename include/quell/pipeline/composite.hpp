#pragma once

#include <quell/core/light.hpp>
#include <quell/pipeline/ingest.hpp>
#include <quell/pipeline/run.hpp>
#include <quell/pipeline/unfinished.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// What a denoised signal is multiplied by in the picture, if anything.
template <ChannelTag C> struct Share { using factor = Channels<>; };
template <> struct Share<Visibility> { using factor = Channels<Direct>; };
template <> struct Share<Indirect> { using factor = Channels<Albedo>; };

template <ChannelTag... Signals> using FactorsOf = union_of<typename Share<Signals>::factor...>;

struct CompositeRun;
} // namespace detail

/// Several signals of one frame, each with its own pipeline, and the picture that they add up to:
///
///     direct * visibility + glossy + albedo * indirect + further signals
///
/// Any subset will do. A factor (direct, albedo) comes from its own pipeline where there is one, else from the frame as it is. Used like a
/// Pipeline:
///
///     constexpr auto trmv = Composite{shadows, reflections, indirect_light};
///     Frame frame{size, trmv};    History history{size, trmv};    run(trmv, frame, history);
///
/// @tparam Ps pipelines of different signals
template <class... Ps> struct Composite {
    static_assert(sizeof...(Ps) > 0, "Composite{pipelines...}: give at least one Pipeline");
    using Output = Radiance; ///< the channel of the picture
    using factors = without<detail::FactorsOf<typename Ps::Output...>,
                            union_of<Channels<typename Ps::Output>...>>; ///< factors that come from the frame
    using reads = decltype(reads_of<Ps...>{} | factors{});               ///< channels that the host must supply
    /// What the host's motion vectors mean: see Supplied.
    static constexpr MotionConvention motion_convention = [] {
        MotionConvention first;
        static_cast<void>(((first = Ps::motion_convention, first == MotionConvention{}) && ...));
        return first;
    }();
    static_assert(((!reads_of<Ps>::template has<Motion> || Ps::motion_convention == motion_convention) && ...),
                  "Composite{pipelines...}: one frame has vectors of one convention: give each pipeline the same Supplied<>");
    static constexpr bool needs_camera = (Ps::needs_camera || ...);   ///< whether frame.camera must be set
    static constexpr bool checks_jitter = (Ps::checks_jitter || ...); ///< whether frame.camera.jitter must be in range

    std::tuple<Ps...> pipelines; ///< in the order given

    /// @param ps one Pipeline per signal
    constexpr explicit Composite(Ps const&... ps) : pipelines(ps...) {}
};

/// The histories of all pipelines of a Composite, and its picture. The pipelines share scratch memory.
template <class... Ps, ImageStorage Storage> class History<Composite<Ps...>, Storage> {
public:
    /// @throws Error for a size without pixels
    explicit History(Extent size, Composite<Ps...> const&, Storage const& = {})
        : pool(std::make_shared<detail::ImagePool>(detail::checked(size))), histories(History<Ps, Storage>(pool)...), picture(size) {}

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() {
        std::apply([](auto&... h) { (h.forget(), ...); }, histories);
    }
    /// Gives scratch back: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() {
        std::apply([](auto&... h) { (h.release_scratch(), ...); }, histories);
    }
    /// History of pipeline i, in the composite's order.
    template <std::size_t i> [[nodiscard]] auto const& of_pipeline() const { return std::get<i>(histories); }
    /// Missing samples and suppressed energy are sums over all pipelines, repaired guides the most that one has; frames and resets are
    /// those of the first.
    [[nodiscard]] Statistics statistics() const {
        Statistics sum = std::get<0>(histories).statistics();
        sum.missing_samples = std::apply([](auto const&... h) { return (h.statistics().missing_samples + ...); }, histories);
        sum.suppressed = std::apply([](auto const&... h) { return (h.statistics().suppressed + ...); }, histories);
        std::apply([&](auto const&... h) { (sum.repaired_guides.raise_to(h.statistics().repaired_guides), ...); }, histories);
        return sum;
    }
    /// Memory of history, scratch and picture, in bytes. Complete after the second frame, or when all frames that are kept are there.
    [[nodiscard]] std::size_t bytes() const { return picture.bytes() + pool->bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(picture.size().pixels()); }

private:
    friend struct detail::CompositeRun;
    friend struct detail::OpenHistory;
    friend struct detail::Inspect;

    std::shared_ptr<detail::ImagePool> pool; ///< shared: scratch of one pipeline is free for the next
    std::tuple<History<Ps, Storage>...> histories;
    ImageOf<Storage, Radiance> picture;
};

namespace detail {
/// Views of the denoised signals, numbered. Not a tuple, which is not trivially copyable.
template <class Numbers, class... Signals> struct NumberedSignals;
template <std::size_t... i, class... Signals>
struct NumberedSignals<std::index_sequence<i...>, Signals...> : Slot<std::integral_constant<std::size_t, i>, Signals>... {};
template <std::size_t i, class T> QUELL_KERNEL T const& numbered(Slot<std::integral_constant<std::size_t, i>, T> const& s) {
    return s.held;
}

/// Adds up the denoised signals.
template <class FrameViews, class OutputView, class... Signals> struct CompositeJob {
    static constexpr auto name = "composite";
    FrameViews frame;
    OutputView output;
    NumberedSignals<std::index_sequence_for<Signals...>, Signals...> denoised;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, Coordinate<Real> x, Coordinate<Real> y, int count) const {
        vec3<Real> sum{Real(0.f), Real(0.f), Real(0.f)};
        [&]<std::size_t... i>(std::index_sequence<i...>) QUELL_INLINED { (add<Real>(sum, numbered<i>(denoised), x, y), ...); }
        (std::index_sequence_for<Signals...>{});
        store_pixels<Real>(output, x, y, sum, count);
    }

private:
    using AllFactors = FactorsOf<typename Signals::Channel...>;

    template <class Real, class Signal>
    QUELL_KERNEL void add(vec3<Real>& sum, Signal const& signal, Coordinate<Real> x, Coordinate<Real> y) const {
        if constexpr (!AllFactors::template has<typename Signal::Channel>) {
            auto const value = load_pixels<Real>(signal.view, x, y);
            vec3<Real> times{Real(1.f), Real(1.f), Real(1.f)};
            for_each_channel(typename Share<typename Signal::Channel>::factor{},
                             [&]<class C>(C) QUELL_INLINED { times = usable(factor<Real, C>(x, y)); });
            if constexpr (components_of<std::remove_const_t<decltype(value)>> == 1)
                sum = add_scaled(sum, times, value);
            else
                sum = map([](auto s, auto f, auto v) QUELL_INLINED { return fma(f, v, s); }, sum, times, value);
        }
    }
    /// From its own pipeline where there is one, else from the frame.
    template <class Real, class C> QUELL_KERNEL vec3<Real> factor(Coordinate<Real> x, Coordinate<Real> y) const {
        constexpr int which = index_of<C>();
        if constexpr (which < static_cast<int>(sizeof...(Signals)))
            return load_pixels<Real>(numbered<std::size_t{which}>(denoised).view, x, y);
        else
            return of_frame<C>(load_pixels<Real>(frame.view(C{}), x, y));
    }
    template <class C, class V> QUELL_KERNEL static V of_frame(V const& value) {
        if constexpr (std::is_same_v<C, Albedo>)
            return Repair<Albedo>::repaired(value);
        else
            return value;
    }
    /// Index of the signal that a channel is; the number of signals if there is none.
    template <class C> static constexpr int index_of() {
        int i = 0;
        static_cast<void>(((std::is_same_v<C, typename Signals::Channel> || (++i, false)) || ...));
        return i;
    }
    /// Factors that are no light, as hosts may leave at misses, count as 0.
    template <class Real> QUELL_KERNEL static vec3<Real> usable(vec3<Real> const& f) {
        return select(is_light(f), f, vec3<Real>{Real(0.f), Real(0.f), Real(0.f)});
    }
};
template <ChannelTag C, class View> struct DenoisedSignal {
    using Channel = C;
    View view;
};
} // namespace detail

namespace detail {
template <class... Ps> inline constexpr int kept_frames_of<Composite<Ps...>> = std::max({kept_frames_of<Ps>...});
struct CompositeRun {
    template <class... Ps, class F, class Storage, class E>
    static auto all(Composite<Ps...> const& composite, F const& frame, History<Composite<Ps...>, Storage>& history, E const& executor) {
        // Checked before any pipeline runs: an error must leave all histories at the same frame.
        check_frame<Composite<Ps...>>(frame);
        Unfinished unfinished(history);
        follow_size(frame, history);
        auto const output = history.picture.view();
        into(output, composite, frame, history, executor);
        unfinished.finish();
        return output;
    }
    /// @param frame checked
    template <class Output, class... Ps, class F, class Storage, class E>
    static void into(Output const& output, Composite<Ps...> const& composite, F const& frame, History<Composite<Ps...>, Storage>& history,
                     E const& executor) {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            auto const factors = frame.views(typename Composite<Ps...>::factors{});
            auto const sum = [&](auto... denoised) {
                CompositeJob<decltype(frame.views(typename Composite<Ps...>::factors{})), Output, decltype(denoised)...> const job{
                    .frame = factors, .output = output, .denoised = {{denoised}...}};
                run_or_enqueue(executor, Region{0, 0, frame.size.width, frame.size.height}, job);
                submit_queue(executor);
            };
            // Initialiser lists are evaluated in order.
            std::apply(sum, std::tuple{denoised<typename Ps::Output>(
                                run(std::get<i>(composite.pipelines), frame, std::get<i>(history.histories), executor))...});
        }
        (std::index_sequence_for<Ps...>{});
    }

    template <class F, class H> static void follow_size(F const& frame, H& history) {
        if (!(history.picture.size() == frame.size)) history.picture = decltype(history.picture)(frame.size);
    }

private:
    template <ChannelTag C, class View> static DenoisedSignal<C, View> denoised(View const& view) { return {view}; }
};
} // namespace detail

/// Denoises one frame of several signals. Returns a view of the picture, valid until the next run with this history.
/// @throws Error as run() of a Pipeline does
template <class... Ps, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(Composite<Ps...> const& composite, Frame<Set, FrameStorage> const& frame, History<Composite<Ps...>, Storage>& history,
         E const& executor = {}) {
    static_assert(
        contained_in<typename Composite<Ps...>::reads, Set>,
        "run(composite, frame, ...): the frame lacks a channel that the composite reads; construct the frame with this composite");
    if constexpr (!contained_in<typename Composite<Ps...>::reads, Set>)
        return detail::NoOutput{};
    else
        return detail::CompositeRun::all(composite, frame, history, executor);
}

/// Like run(), but writes the picture through a view of the host's, as run_into() of a Pipeline does. The history keeps a picture of its
/// own nevertheless.
/// @throws Error as run() does, and for a target that is not of the frame's size
template <class... Ps, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, Composite<Ps...> const& composite, Frame<Set, FrameStorage> const& frame,
              History<Composite<Ps...>, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename Composite<Ps...>::reads, Set>, "run_into(target, composite, frame, ...): the frame lacks a channel "
                                                                       "that the composite reads; construct the frame with this composite");
    static_assert(Target::components == 3, "run_into(target, composite, frame, ...): the target must have three components");
    detail::check_target(target.size, frame.size);
    detail::check_frame<Composite<Ps...>>(frame);
    detail::Unfinished unfinished(history);
    detail::CompositeRun::follow_size(frame, history);
    detail::CompositeRun::into(target, composite, frame, history, executor);
    unfinished.finish();
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
