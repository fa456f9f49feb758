#pragma once

#include <denoise/denoiser_of.hpp>

#include <quell/motion/invert_motion.hpp>
#include <quell/pipeline/two_sided.hpp>

#include <deque>

namespace quell::examples {

/// A pipeline that uses the frames after each as well, as far as it is shown them.
template <class P> class TwoSidedDenoiser final : public Denoiser {
    using OneFrame = Frame<decltype(typename P::reads{} | TwoSided::reads{})>;
    /// What a renderer may leave out: then every frame is one sample, and motion to the next frame is that of the next frame turned round.
    using Optional = Channels<MotionNext, SampleCount, SampleVariance>;
    using Needed = without<typename OneFrame::channels, Optional>;

    P pipeline, joining;
    TwoSidedHistory<P> history;
    Threads<> executor;
    std::deque<OneFrame> window;
    bool last_knows_next = false; ///< whether the window's last frame has its motion to the next one
    std::vector<Finding> found;

public:
    TwoSidedDenoiser(P const& p, P const& j, Extent size, Threads<> const& threads)
        : pipeline(p), joining(j), history(size, p), executor(threads) {}

    std::vector<std::string> planes(io::ChannelNames const& names) const override { return io::planes_of(Needed{}, names); }
    std::vector<std::string> optional_planes(io::ChannelNames const& names) const override { return io::planes_of(Optional{}, names); }

    void look_ahead(io::ExrImage const& image, io::ChannelNames const& names, long long number) override {
        if (!window.empty() && window.back().number >= number) return;
        OneFrame frame(image.size);
        io::load_channels(Needed{}, frame, image, names);
        frame.number = number;
        load_or(frame, sample_count, image, names, 1.f);
        load_or(frame, sample_variance, image, names, 0.f);
        bool const knows_next = load_or(frame, motion_next, image, names, std::numeric_limits<float>::quiet_NaN());
        if (!window.empty() && !last_knows_next && window.back().size == frame.size) {
            Timer const timer(taken);
            invert_motion(window.back()[motion_next].view(), frame[motion].view(), frame[depth].view());
        }
        window.push_back(std::move(frame));
        last_knows_next = knows_next;
    }

    void drop_ahead() override { window.clear(); }
    metrics::Picture denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number) override {
        while (!window.empty() && window.front().number != number) window.pop_front();
        if (window.empty()) look_ahead(image, names, number);
        found =
            looks ? quell::diagnose(window.front(), history.before, names.motion, factor_in(image)) : checked(window.front(), names.motion);
        auto const view = [&] {
            Timer const timer(taken);
            return run_two_sided(pipeline, joining, window, history, executor);
        }();
        return picture_and_alpha(view);
    }
    bool needs_camera() const override { return P::needs_camera; }
    std::vector<Finding> const& findings() const override { return found; }
    bool has_debug_view(std::string const&) const override { return false; }
    std::vector<DebugImage> debug_images(std::string const&) override { return {}; }
    std::optional<HistoryContents> remembered() const override { return contents_of(history.before); }
    void remember(HistoryContents const& contents) override { put_contents(history.before, contents); }
    void release_scratch() override {
        window.clear();
        history.release_scratch();
        denoised_alpha = {};
    }
    Statistics statistics() const override { return history.statistics(); }
    std::string plan() const override { return to_string(plan_of(pipeline)); }
    double bytes_per_pixel() const override { return history.before.bytes_per_pixel() + history.after.bytes_per_pixel(); }

private:
    /// Loads a channel, or fills it where the file doesn't have it. Returns whether it had.
    template <ChannelTag C>
    static bool load_or(OneFrame& frame, C channel, io::ExrImage const& image, io::ChannelNames const& names, float otherwise) {
        auto const planes = io::planes_of(Channels<C>{}, names);
        bool const there = std::ranges::all_of(planes, [&](auto const& plane) { return image.find(plane) != nullptr; });
        if (there)
            io::load_channels(Channels<C>{}, frame, image, names);
        else
            for (int c = 0; c < C::components; ++c)
                for (int y = 0; y < frame.size.height; ++y)
                    for (int x = 0; x < frame.size.width; ++x) frame[channel].view().set(c, x, y, otherwise);
        return there;
    }
};

/// A denoiser that uses later frames, from functions that make its pipeline, and the one that joins both sides.
template <class Make, class Join> std::unique_ptr<Denoiser> two_sided_denoiser(Extent size, int threads) {
    constexpr auto pipeline = Make{}(KnownSamples{});
    constexpr decltype(pipeline) joining = Join{}(KnownSamples{});
    return std::make_unique<TwoSidedDenoiser<std::remove_const_t<decltype(pipeline)>>>(pipeline, joining, size, Threads<>{threads});
}

/// A preset that uses later frames, from functions of further parts, for colour and for colour with alpha; with debug images, of the frames
/// before alone.
template <class Make, class Join, class MakeAlpha, class JoinAlpha>
Preset two_sided_preset(std::string name, Make, Join, MakeAlpha, JoinAlpha) {
    return {std::move(name), two_sided_denoiser<Make, Join>, two_sided_denoiser<MakeAlpha, JoinAlpha>,
            [](Extent size) -> std::unique_ptr<Denoiser> {
                constexpr auto pipeline = watched(Make{}());
                return std::make_unique<DenoiserOf<std::remove_const_t<decltype(pipeline)>, Serial>>(pipeline, size, Serial{});
            },
            true};
}

} // namespace quell::examples
