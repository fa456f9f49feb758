#pragma once

#include <denoise/denoiser.hpp>

#include <quell/diagnose/debug_images.hpp>
#include <quell/diagnose/diagnose.hpp>
#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/quell.hpp>

namespace quell::examples {

/// The channels that a pipeline keeps, or that all pipelines of a composite keep.
template <class P> struct KeptChannels { using type = typename P::keeps; };
template <class... Ps> struct KeptChannels<Composite<Ps...>> { using type = union_of<typename Ps::keeps...>; };

/// Whether it is a pipeline, with a history, and no composite.
template <class P> inline constexpr bool has_one_history = false;
template <ChannelTag S, class... Parts> inline constexpr bool has_one_history<Pipeline<S, Parts...>> = Pipeline<S, Parts...>::has_past;

/// @tparam Storage of the history
template <class P, class E = Threads<>, ImageStorage Storage = Planar<>> class DenoiserOf final : public Denoiser {
    P pipeline;
    Frame<typename P::reads> frame;
    History<P, Storage> history;
    E executor;
    std::vector<Finding> found;

public:
    DenoiserOf(P const& p, Extent size, E const& e) : pipeline(p), frame(size), history(size, p), executor(e) {}

    std::vector<std::string> planes(io::ChannelNames const& names) const override { return io::planes_of(typename P::reads{}, names); }

    metrics::Picture denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number) override {
        if (P::needs_camera && !io::camera_of(image))
            throw Error(image.name, "it has no camera, which this preset needs",
                        "write the 4x4 attributes quell:view and quell:projection, or choose another preset");
        if (!(frame.size == image.size)) frame = Frame<typename P::reads>(image.size);
        io::load(frame, image, names);
        frame.number = number;
        found = looks ? quell::diagnose(frame, history, names.motion, factor_in(image)) : checked(frame, names.motion);
        auto const view = [&] {
            Timer const timer(taken);
            return quell::run(pipeline, frame, history, executor);
        }();
        return picture_and_alpha(view);
    }
    bool needs_camera() const override { return P::needs_camera; }
    std::vector<Finding> const& findings() const override { return found; }
    bool has_debug_view(std::string const& view) const override {
        bool has = false;
        for_each_channel(common_to<DebugChannels, typename KeptChannels<P>::type>{},
                         [&](auto channel) { has = has || view == channel.name; });
        return has;
    }
    std::vector<DebugImage> debug_images(std::string const& view) override {
        std::vector<DebugImage> images;
        for_each_channel(DebugChannels{}, [&](auto channel) {
            if (view == channel.name) images = quell::debug_images(channel, history);
        });
        return images;
    }
    std::optional<HistoryContents> remembered() const override {
        if constexpr (has_one_history<P>)
            return contents_of(history);
        else
            return std::nullopt;
    }
    void remember(HistoryContents const& contents) override {
        if constexpr (has_one_history<P>) put_contents(history, contents);
    }
    void release_scratch() override {
        frame = Frame<typename P::reads>(Extent{1, 1});
        history.release_scratch();
        denoised_alpha = {};
    }
    Statistics statistics() const override { return history.statistics(); }
    std::string plan() const override { return to_string(plan_of(pipeline, Storage{})); }
    double bytes_per_pixel() const override { return history.bytes_per_pixel(); }
};

/// A preset from a function without state that makes its pipeline: preset("atrous", [] { return presets::atrous(radiance); }).
template <ImageStorage Storage = Planar<>, class Make> Preset preset(std::string name, Make) {
    return {std::move(name), [](Extent size, int threads) -> std::unique_ptr<Denoiser> {
                constexpr auto pipeline = Make{}();
                return std::make_unique<DenoiserOf<std::remove_const_t<decltype(pipeline)>, Threads<>, Storage>>(pipeline, size,
                                                                                                                 Threads<>{threads});
            }};
}
/// One with debug images. These are made pixel by pixel: packs would be as much again to compile, for what nobody waits for.
template <class Make> Preset watched_preset(std::string name, Make make) {
    auto result = preset(std::move(name), make);
    result.make_watched = [](Extent size) -> std::unique_ptr<Denoiser> {
        constexpr auto pipeline = watched(Make{}());
        return std::make_unique<DenoiserOf<std::remove_const_t<decltype(pipeline)>, Serial>>(pipeline, size, Serial{});
    };
    return result;
}

} // namespace quell::examples
