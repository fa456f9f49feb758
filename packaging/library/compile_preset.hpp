#pragma once

#include "compiled_preset.hpp"
#include "strips.hpp"

#include <quell/diagnose/debug_images.hpp>
#include <quell/diagnose/inspect.hpp>
#include <quell/motion/invert_motion.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/two_sided.hpp>
#include <quell/pipeline/warm_up.hpp>
#include <quell/presets/named.hpp>
#include <quell/quell.hpp>

#include <algorithm>

// Compiles presets: what generated files, and programs with presets of their own, instantiate.
namespace quell_library {

/// Copies an image of quell's to the caller's.
template <class From, class To> struct CopyJob {
    static constexpr auto name = "copy";
    From from;
    To to;

    template <class Real> QUELL_KERNEL void operator()(quell::AtOnce<Real>, int x, int y, int count) const {
        quell::detail::store_pixels<Real>(to, x, y, quell::detail::load_pixels<Real>(from, x, y), count);
    }
};

/// The channels that a pipeline keeps, or that all pipelines of a composite keep.
template <class P> struct KeptChannels { using type = typename P::keeps; };
template <class... Ps> struct KeptChannels<quell::Composite<Ps...>> { using type = quell::union_of<typename Ps::keeps...>; };

/// The guides that a pipeline accumulates; of composites none.
template <class P> struct GuidesOf {
    using type = quell::common_to<quell::Channels<quell::MeanAlbedo, quell::MeanNormal>, typename P::keeps>;
};
template <class... Ps> struct GuidesOf<quell::Composite<Ps...>> { using type = quell::Channels<>; };

/// Whether it is a pipeline, with a history, and no composite.
template <class P> inline constexpr bool has_one_history = false;
template <quell::ChannelTag S, class... Parts>
inline constexpr bool has_one_history<quell::Pipeline<S, Parts...>> = quell::Pipeline<S, Parts...>::has_temporal;
template <class P> inline constexpr bool is_composite = false;
template <class... Ps> inline constexpr bool is_composite<quell::Composite<Ps...>> = true;

/// Whether passes write the output where the caller wants it. Effects do not: their kernels are then those of the composite that puts them
/// together.
template <class P>
inline constexpr bool writes_output =
    is_composite<P> || std::is_same_v<typename P::Output, quell::Radiance> || std::is_same_v<typename P::Output, quell::RadianceAlpha>;

/// Whether pixels without a sample of a channel have that of their block: of what its ray has hit.
template <class C> inline constexpr bool repeats_samples = quell::Subsampled<quell::half_size, quell::Channels<C>>::template repeats<C>;

/// What all compiled denoisers have in common: where their memory lies, their threads, and how they write what comes out.
template <class P> class DenoiserBase : public CompiledDenoiser {
    Memory memory;

protected:
    P pipeline;
    StripPool strips;
    Strips executor;

    DenoiserBase(P const& p, Parallel const& parallel, Memory const& m) : memory(m), pipeline(p), executor{parallel, &strips} {
        use_memory();
    }
    /// From now on images that this thread makes lie in the caller's memory.
    void use_memory() const { CallersMemory::current() = memory; }

    template <int N = P::Output::components> static auto target_of(Image const& image, quell::Extent size) {
        return HostTarget<N>{image.data, size, image.component_stride, image.pixel_stride, image.row_stride, image.is_half};
    }
    template <quell::ImageView From> void copy(From const& from, Image const& output) const {
        auto const to = target_of<From::components>(output, from.size);
        executor.for_each_pixel({0, 0, from.size.width, from.size.height}, CopyJob<From, std::remove_const_t<decltype(to)>>{from, to});
    }
    /// Makes a frame of the caller's images.
    /// @param is_whole is_whole(channel): whether an image has to be there as a whole
    /// @throws quell::Error for one without memory that is not optional
    template <class Optional, class Set>
    void take(quell::Frame<Set, HostImages>& frame, FrameImages const& given, auto const& is_whole) const {
        if (!(frame.size == given.size)) frame = quell::Frame<Set, HostImages>(given.size);
        std::size_t next = 0;
        for_each_channel(Set{}, [&]<class C>(C c) {
            auto image = given.channels[next++];
            image.samples.repeats = repeats_samples<C>;
            if (image.data == nullptr && !Optional::template has<C>)
                throw quell::Error("channel '" + std::string(c.name) + "'", "no memory", "point it at its pixels");
            if (frame[c].refer_to(image) && (c.fraction > 1 || is_whole(c))) frame[c].take_whole(executor.parallel);
        });
        frame.camera = given.camera, frame.number = given.number, frame.shutter = given.shutter;
    }
    static constexpr auto all = [](auto) { return true; };
    template <class Set> static std::size_t bytes_of(quell::Frame<Set, HostImages> const& frame) {
        std::size_t sum = 0;
        for_each_channel(Set{}, [&](auto c) { sum += frame[c].bytes(); });
        return sum;
    }
};

/// A preset in real time.
/// @tparam Storage of its history
template <class P, quell::ImageStorage Storage = OwnImages> class OneSided final : public DenoiserBase<P> {
    using Base = DenoiserBase<P>;
    quell::Frame<typename P::reads, HostImages> frame;
    quell::History<P, Storage> history;
    std::vector<std::string_view> whole; ///< channels that are copied where they are not planes of floats in padded rows

public:
    using reads = typename P::reads;
    using Optional = quell::Channels<>;
    using Guides = typename GuidesOf<P>::type;

    OneSided(P const& p, quell::Extent size, Parallel const& parallel, Memory const& m)
        : Base(p, parallel, m), frame(size), history(size, p, Storage{}), whole(read_from_afar(quell::plan_of(p))) {}

    void run(std::span<FrameImages const> window, Image const& output) override {
        this->use_memory();
        this->template take<Optional>(frame, window.front(),
                                      [&](auto channel) { return std::ranges::find(whole, channel.name) != whole.end(); });
        if constexpr (writes_output<P>)
            run_into(this->target_of(output, frame.size), this->pipeline, frame, history, this->executor);
        else
            this->copy(quell::run(this->pipeline, frame, history, this->executor), output);
    }
    void forget() override { history.forget(); }
    void release_scratch() override {
        frame = decltype(frame)({1, 1});
        this->strips.release();
        history.release_scratch();
    }
    [[nodiscard]] quell::Statistics statistics() const override { return history.statistics(); }
    [[nodiscard]] std::size_t bytes() const override { return history.bytes() + this->bytes_of(frame) + this->strips.bytes(); }
    [[nodiscard]] quell::detail::Observation observe(FrameImages const& given) override {
        this->use_memory();
        this->template take<Optional>(frame, given, this->all);
        quell::detail::check_frame<P>(frame);
        return quell::detail::observe<P>(frame, history);
    }
    [[nodiscard]] bool has_debug_view(std::string_view view) const override {
        bool has = false;
        for_each_channel(quell::common_to<quell::DebugChannels, typename KeptChannels<P>::type>{},
                         [&](auto channel) { has = has || view == channel.name; });
        return has;
    }
    [[nodiscard]] std::vector<quell::DebugImage> debug_images(std::string_view view) override {
        std::vector<quell::DebugImage> images;
        for_each_channel(quell::common_to<quell::DebugChannels, typename KeptChannels<P>::type>{}, [&](auto channel) {
            if (view == channel.name) images = quell::debug_images(channel, history);
        });
        return images;
    }
    bool copy_guide([[maybe_unused]] std::string_view name, [[maybe_unused]] Image const& output) override {
        bool found = false;
        if (history.statistics().frames > 0)
            for_each_channel(Guides{}, [&](auto guide) {
                if (name == guide.name) this->copy(history[guide], output), found = true;
            });
        return found;
    }
    [[nodiscard]] std::optional<quell::HistoryContents> remembered() const override {
        if constexpr (has_one_history<P>)
            return contents_of(history);
        else
            return std::nullopt;
    }
    void remember([[maybe_unused]] quell::HistoryContents const& contents) override {
        this->use_memory();
        if constexpr (has_one_history<P>) put_contents(history, contents);
    }
    void tell(quell::detail::KnownPast& to) const override {
        if constexpr (has_one_history<P>)
            quell::detail::OpenHistory::images(history).tell(to);
        else
            to.drop();
    }
    void learn([[maybe_unused]] quell::detail::KnownPast const& past) override {
        if constexpr (has_one_history<P>) quell::detail::OpenHistory::images(history).learn(past);
    }
};

/// A preset that uses the frames after each as well. Frames may lack what renderers leave out: then each is one sample, and motion to the
/// next frame is that of the next frame turned round.
template <class P> class TwoSidedDenoiser final : public DenoiserBase<P> {
    using Base = DenoiserBase<P>;

public:
    using reads = typename quell::TwoSided<P>::reads;
    using Optional = quell::Channels<quell::MotionNext, quell::SampleCount, quell::SampleVariance>;
    using Guides = quell::Channels<>;

private:
    using OneFrame = quell::Frame<reads, HostImages>;

    quell::TwoSided<P> denoiser;
    quell::History<quell::TwoSided<P>, OwnImages> history;
    std::vector<OneFrame> window;

public:
    TwoSidedDenoiser(quell::TwoSided<P> const& d, quell::Extent size, Parallel const& parallel, Memory const& m)
        : Base(d.pipeline, parallel, m), denoiser(d), history(size, d, OwnImages{}) {}

    void run(std::span<FrameImages const> given, Image const& output) override {
        this->use_memory();
        while (window.size() > given.size()) window.pop_back();
        bool has_next = true; // whether the frame before says where its pixels go
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (i == window.size()) window.emplace_back(given[i].size);
            bool const last_has_next = std::exchange(has_next, take_frame(window[i], given[i]));
            if (!last_has_next) put_motion_next(window[i - 1], window[i]);
        }
        this->copy(quell::run(denoiser, window, history, this->executor), output);
    }
    void forget() override { history.forget(); }
    void release_scratch() override {
        window.clear();
        history.release_scratch();
    }
    [[nodiscard]] quell::Statistics statistics() const override { return history.statistics(); }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = history.bytes();
        for (auto const& frame : window) sum += this->bytes_of(frame);
        return sum;
    }
    [[nodiscard]] quell::detail::Observation observe(FrameImages const& given) override {
        this->use_memory();
        if (window.empty()) window.emplace_back(given.size);
        take_frame(window.front(), given);
        quell::detail::check_frame<P>(window.front());
        return quell::detail::observe<P>(window.front(), history.before);
    }
    [[nodiscard]] bool has_debug_view(std::string_view) const override { return false; }
    [[nodiscard]] std::vector<quell::DebugImage> debug_images(std::string_view) override { return {}; }
    [[nodiscard]] std::optional<quell::HistoryContents> remembered() const override { return contents_of(history.before); }
    void remember(quell::HistoryContents const& contents) override {
        this->use_memory();
        put_contents(history.before, contents);
    }
    void tell(quell::detail::KnownPast& to) const override { quell::detail::OpenHistory::images(history.before).tell(to); }
    void learn(quell::detail::KnownPast const& past) override { quell::detail::OpenHistory::images(history.before).learn(past); }

private:
    /// Returns whether the frame says where its pixels go in the next one.
    bool take_frame(OneFrame& frame, FrameImages const& given) const {
        this->template take<Optional>(frame, given, this->all);
        bool const has_next = frame[quell::motion_next].has_memory();
        fill_missing(frame[quell::sample_count], 1.f);
        fill_missing(frame[quell::sample_variance], 0.f);
        fill_missing(frame[quell::motion_next], std::numeric_limits<float>::quiet_NaN());
        return has_next;
    }
    static void fill_missing(auto& image, float value) {
        if (image.has_memory()) return;
        auto const pixels = image.make();
        for (int y = 0; y < pixels.size.height; ++y)
            for (int x = 0; x < pixels.size.width; ++x)
                for (int c = 0; c < pixels.components; ++c) pixels.set(c, x, y, value);
    }
    static void put_motion_next(OneFrame& frame, OneFrame const& next) {
        if (frame.size == next.size)
            quell::invert_motion(frame[quell::motion_next].make(), next[quell::motion].view(), next[quell::depth].view());
    }
};

/// The names of its passes, and its plan.
template <class Make> void describe(Way& way) {
    way.plan = [] { return to_string(plan_of(Make{}())); };
    way.passes = [] {
        std::vector<std::string> names;
        for (auto const& pass : plan_of(Make{}()).passes) names.emplace_back(pass.name);
        return names;
    };
}
template <class Made, class P> Way way_of() {
    Way way{.output_components = P::Output::components, .needs_camera = P::needs_camera};
    if constexpr (has_one_history<P>) way.signal = P::Output::name;
    quell::for_each_channel(typename Made::reads{}, [&]<class C>(C c) {
        way.channels.push_back({std::string(c.name), c.components, c.fraction, Made::Optional::template has<C>, c.is_guide});
    });
    quell::for_each_channel(typename Made::Guides{}, [&](auto guide) {
        way.guides.push_back({std::string(guide.name), guide.components});
    });
    return way;
}

/// A pipeline from a function without state, in real time: one_sided([] { return presets::atrous(radiance); }).
template <quell::ImageStorage Storage = OwnImages, class Make> Way one_sided(Make) {
    using P = std::remove_const_t<decltype(Make{}())>;
    auto way = way_of<OneSided<P, Storage>, P>();
    describe<Make>(way);
    way.make = [](quell::Extent size, Parallel const& parallel, Memory const& memory) -> std::unique_ptr<CompiledDenoiser> {
        return std::make_unique<OneSided<P, Storage>>(Make{}(), size, parallel, memory);
    };
    return way;
}
/// One that uses later frames, from functions that make its pipeline, and the one that joins both sides.
template <class Make, class Join> Way two_sided(Make, Join) {
    using P = std::remove_const_t<decltype(Make{}())>;
    auto way = way_of<TwoSidedDenoiser<P>, P>();
    describe<Make>(way);
    way.make = [](quell::Extent size, Parallel const& parallel, Memory const& memory) -> std::unique_ptr<CompiledDenoiser> {
        return std::make_unique<TwoSidedDenoiser<P>>(quell::TwoSided{Make{}(), Join{}()}, size, parallel, memory);
    };
    return way;
}

/// Whether a preset denoises one part of the picture.
template <class Signal> inline constexpr bool is_effect = quell::ChannelTag<Signal> && !std::is_same_v<Signal, quell::Radiance>;
/// Debug images are of one pipeline with a history, of colours and not of cones.
template <class P> inline constexpr bool has_debug_images = false;
template <quell::ChannelTag S, class... Parts>
inline constexpr bool has_debug_images<quell::Pipeline<S, Parts...>> =
    quell::Pipeline<S, Parts...>::has_temporal&& std::is_same_v<typename quell::Pipeline<S, Parts...>::Signal, S>;

/// What a pipeline denoises, or the pipelines of a composite.
template <quell::ChannelTag S, class... Parts> std::vector<SignalOfPreset> signals_of(quell::Pipeline<S, Parts...> const&) {
    return {{std::string(S::name), S::components}};
}
template <class... Ps> std::vector<SignalOfPreset> signals_of(quell::Composite<Ps...> const&) {
    return {{std::string(Ps::Output::name), Ps::Output::components}...};
}

/// All that is compiled of a preset.
template <class Named> CompiledPreset compiled(Named const& named) {
    using P = std::remove_const_t<decltype(Named::usual())>;
    CompiledPreset made{.name = std::string(named.name), .group = named.group, .judge = named.judge, .stages = named.stages};
    auto const picture = [] {
        if constexpr (is_effect<typename Named::signal_type>)
            return quell::Composite{Named::usual()};
        else
            return Named::usual();
    };
    made.usual = one_sided([] { return Named::usual(); });
    if constexpr (is_effect<typename Named::signal_type>) made.picture = one_sided(picture);
    if constexpr (has_debug_images<P>) made.watched = one_sided([] { return quell::watched(decltype(picture){}()); });
    if constexpr (Named::is_two_sided) {
        using quell::KnownSamples;
        made.two_sided = two_sided([] { return Named::usual(KnownSamples{}); }, [] { return Named::usual_joining(KnownSamples{}); });
        made.two_sided_alpha =
            two_sided([] { return decltype(Named::make){}(quell::radiance_alpha, quell::Demodulate{}, KnownSamples{}); },
                      [] { return decltype(Named::join){}(quell::radiance_alpha, quell::Demodulate{}, KnownSamples{}); });
    }
    constexpr auto pipeline = Named::usual();
    made.of_signals = signals_of(pipeline);
    made.warm_up = warm_up_frames(pipeline); // joining both sides begins anew in each frame
    made.by_albedo = std::is_same_v<typename Named::signal_type, quell::AnySignal> && P::reads::template has<quell::Albedo>;
    made.wants_sharp_picture = quell::blur_input<P> == quell::BlurInput::picture;
    return made;
}

} // namespace quell_library
