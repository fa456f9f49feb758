#pragma once

#include <quell/pipeline/ingest.hpp>
#include <quell/pipeline/run.hpp>

namespace quell {

namespace detail {
/// How a denoised signal enters the picture: times what, if anything.
template <ChannelTag C> struct Share { using factor = Channels<>; };
template <> struct Share<Visibility> { using factor = Channels<Direct>; };
template <> struct Share<Indirect> { using factor = Channels<Albedo>; };

template <ChannelTag... Signals> using FactorsOf = union_of<typename Share<Signals>::factor...>;

struct CompositeRun;
} // namespace detail

/// Several signals of one frame, each denoised by its own pipeline, and the picture that they make together:
///     direct * visibility + glossy + albedo * indirect + whatever else
/// A factor (direct, albedo) is denoised as well where there is a pipeline for it, and else taken from the frame as it is.
///     constexpr auto trmv = Composite{shadows, reflections, indirect_light};
///     Frame frame{size, trmv};    History history{size, trmv};    run(trmv, frame, history);
/// Any subset will do; what is not in it costs nothing. Used like a Pipeline.
template <class... Ps> struct Composite {
    static_assert(sizeof...(Ps) > 0, "Composite{pipelines...}: give at least one Pipeline");
    using Output = Radiance;
    using factors = without<detail::FactorsOf<typename Ps::Output...>, union_of<Channels<typename Ps::Output>...>>;
    using reads = decltype(reads_of<Ps...>{} | factors{});
    static constexpr MotionConvention motion_convention = [] {
        MotionConvention first;
        static_cast<void>(((first = Ps::motion_convention, first == MotionConvention{}) && ...));
        return first;
    }();
    static_assert(((!reads_of<Ps>::template has<Motion> || Ps::motion_convention == motion_convention) && ...),
                  "Composite{pipelines...}: one frame has vectors of one convention: give each pipeline the same Supplied<>");
    static constexpr bool needs_camera = (Ps::needs_camera || ...);

    std::tuple<Ps...> pipelines;

    constexpr explicit Composite(Ps const&... ps) : pipelines(ps...) {}
};

/// The histories of a composite's pipelines, and its picture.
template <class... Ps, ImageStorage Storage> class History<Composite<Ps...>, Storage> {
public:
    /// @throws Error for a size of no pixels
    explicit History(Extent size, Composite<Ps...> const&, Storage const& = {})
        : pool(std::make_shared<detail::ImagePool>(detail::checked(size))), parts(History<Ps, Storage>(pool)...), picture(size) {}

    /// Starts afresh at the next frame: for a scene cut or a teleport that the host knows of.
    void forget() {
        std::apply([](auto&... h) { (h.forget(), ...); }, parts);
    }
    /// The history of one of the pipelines, in the composite's order.
    template <std::size_t i> [[nodiscard]] auto const& part() const { return std::get<i>(parts); }
    /// Of all pipelines: missing samples and suppressed energy add up; frames and resets are those of the first.
    [[nodiscard]] Statistics statistics() const {
        Statistics sum = std::get<0>(parts).statistics();
        sum.missing_samples = std::apply([](auto const&... h) { return (h.statistics().missing_samples + ...); }, parts);
        sum.suppressed = std::apply([](auto const&... h) { return (h.statistics().suppressed + ...); }, parts);
        return sum;
    }
    [[nodiscard]] std::size_t bytes() const { return picture.bytes() + pool->bytes(); }
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(picture.size().pixels()); }

private:
    friend struct detail::CompositeRun;
    friend struct detail::Inspect;

    std::shared_ptr<detail::ImagePool> pool; ///< one for all parts: what one has used up is scratch for the next
    std::tuple<History<Ps, Storage>...> parts;
    ImageOf<Storage, Radiance> picture;
};

namespace detail {
/// Adds up what the pipelines have made.
template <class FrameViews, class OutputView, class... Parts> struct CompositeJob {
    static constexpr auto name = "composite";
    FrameViews frame;
    OutputView output;
    std::tuple<Parts...> parts;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        vec3<Real> sum{Real(0.f), Real(0.f), Real(0.f)};
        std::apply([&](auto const&... part) QUELL_INLINED { (add<Real>(sum, part, x, y), ...); }, parts);
        store_pixels<Real>(output, x, y, sum, count);
    }

private:
    using AllFactors = FactorsOf<typename Parts::Channel...>;

    template <class Real, class Part> QUELL_KERNEL void add(vec3<Real>& sum, Part const& part, int x, int y) const {
        if constexpr (!AllFactors::template has<typename Part::Channel>) {
            auto const value = load_pixels<Real>(part.view, x, y);
            vec3<Real> times{Real(1.f), Real(1.f), Real(1.f)};
            for_each_channel(typename Share<typename Part::Channel>::factor{},
                             [&]<class C>(C) QUELL_INLINED { times = usable(factor<Real, C>(x, y)); });
            if constexpr (components_of<std::remove_const_t<decltype(value)>> == 1)
                sum = add_scaled(sum, times, value);
            else
                sum = map([](auto s, auto f, auto v) QUELL_INLINED { return fma(f, v, s); }, sum, times, value);
        }
    }
    /// Denoised where there is a pipeline for it.
    template <class Real, class C> QUELL_KERNEL vec3<Real> factor(int x, int y) const {
        constexpr int which = index_of<C>();
        if constexpr (which < static_cast<int>(sizeof...(Parts)))
            return load_pixels<Real>(std::get<which>(parts).view, x, y);
        else
            return load_pixels<Real>(frame.view(C{}), x, y);
    }
    /// Of the part that makes a channel, or how many parts there are.
    template <class C> static constexpr int index_of() {
        int i = 0;
        static_cast<void>(((std::is_same_v<C, typename Parts::Channel> || (++i, false)) || ...));
        return i;
    }
    /// What a host leaves at anything else, at misses for instance, adds nothing.
    template <class Real> QUELL_KERNEL static vec3<Real> usable(vec3<Real> const& f) {
        return select(is_light(f), f, vec3<Real>{Real(0.f), Real(0.f), Real(0.f)});
    }
};
template <ChannelTag C, class View> struct CompositePart {
    using Channel = C;
    View view;
};
} // namespace detail

namespace detail {
struct CompositeRun {
    template <class... Ps, class F, class Storage, class E>
    static auto all(Composite<Ps...> const& composite, F const& frame, History<Composite<Ps...>, Storage>& history, E const& executor) {
        // Before any part runs: where one refused the frame, the others would have gone ahead of it.
        check_frame<Composite<Ps...>>(frame);
        if (!(history.picture.size() == frame.size)) history.picture = ImageOf<Storage, Radiance>(frame.size);
        auto const output = history.picture.view();
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            auto const factors = frame.views(typename Composite<Ps...>::factors{});
            auto const sum = [&](auto... parts) {
                CompositeJob<decltype(frame.views(typename Composite<Ps...>::factors{})), decltype(history.picture.view()),
                             decltype(parts)...> const job{factors, output, {parts...}};
                executor.for_each_pixel(Region{0, 0, frame.size.width, frame.size.height}, job);
            };
            // In braces the parts run in order.
            std::apply(sum, std::tuple{part<typename Ps::Output>(
                                run(std::get<i>(composite.pipelines), frame, std::get<i>(history.parts), executor))...});
        }
        (std::index_sequence_for<Ps...>{});
        return output;
    }

private:
    template <ChannelTag C, class View> static CompositePart<C, View> part(View const& view) { return {view}; }
};
} // namespace detail

/// Denoises one frame of several signals. Returns a view of the picture, which stays valid until the history's next run.
/// @throws Error as run() of a Pipeline does
template <class... Ps, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(Composite<Ps...> const& composite, Frame<Set, FrameStorage> const& frame, History<Composite<Ps...>, Storage>& history,
         E const& executor = {}) {
    static_assert(
        contained_in<typename Composite<Ps...>::reads, Set>,
        "run(composite, frame, ...): the frame lacks a channel that the composite reads; construct the frame with this composite");
    return detail::CompositeRun::all(composite, frame, history, executor);
}

} // namespace quell
