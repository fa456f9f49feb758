#pragma once

#include "external.hpp"

#include <quell/execute/threads.hpp>
#include <quell/quell.hpp>
#include <quell/resolve/resolved.hpp>
#include <support/median.hpp>
#include <tracer/trace_frame.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <tuple>

namespace quell::bench {

/// A pipeline's picture is its effect's share of the image: direct * visibility, glossy, or albedo * indirect. Several make the image.
template <class... Ps> constexpr Composite<Ps...> whole(Composite<Ps...> const& pipelines) { return pipelines; }
template <ChannelTag S, class... Parts> constexpr Composite<Pipeline<S, Parts...>> whole(Pipeline<S, Parts...> const& pipeline) {
    return Composite<Pipeline<S, Parts...>>(pipeline);
}
template <class P, class Policy> constexpr auto whole(Resolved<P, Policy> const& resolved) {
    return Resolved{whole(resolved.pipeline), resolved.resolve};
}

/// A pipeline to chart, by the name that its row has.
template <class P> struct Charted {
    using Whole = decltype(whole(std::declval<P>()));
    std::string name;
    P pipeline;
    bool competes = true;
};
template <class P> Charted(char const*, P) -> Charted<P>;
template <class P> Charted(std::string, P) -> Charted<P>;

/// Methods, and how the frames are rendered that they get.
template <class... Methods> struct Feed {
    using reads = reads_of<typename Methods::Whole...>;
    tracer::RenderSettings rendered; ///< but for the frame's number
    std::tuple<Methods...> methods;
    bool scored_frames_only = false; ///< for what has no history and whose time doesn't matter
};
template <class... Methods> Feed(tracer::RenderSettings, std::tuple<Methods...>, bool = false) -> Feed<Methods...>;

/// A feed's methods at work, and how they do.
template <class FrameT> class Contest {
public:
    tracer::RenderSettings rendered;
    bool scored_frames_only;

    template <class... Methods>
    Contest(ChartOptions const& options, Feed<Methods...> const& feed)
        : rendered(feed.rendered), scored_frames_only(feed.scored_frames_only) {
        std::apply([&](auto const&... named) { (add(named, options), ...); }, feed.methods);
    }

    void render(tracer::PreparedScene& scene, int number, FrameT& frame) const {
        auto settings = rendered;
        settings.frame = number;
        tracer::trace_frame(scene, settings, frame);
    }

    /// Lets the methods denoise a frame, one after the other; without a judge nobody looks at the pictures.
    void run(FrameT const& frame, Judge const* judge) {
        std::vector<metrics::Picture> pictures;
        for (auto& method : methods) {
            auto picture = method.run(frame, method.milliseconds);
            if (judge) pictures.push_back(std::move(picture));
        }
        if (judge) judge->measure(*frame.number, entries, pictures);
    }

    void put_rows(Judge const& judge, std::vector<Row>& rows) const {
        for (std::size_t m = 0; m < methods.size(); ++m)
            rows.push_back(judge.row_of(entries[m], examples::median(methods[m].milliseconds), methods[m].bytes_per_pixel()));
    }

private:
    struct Method {
        std::function<metrics::Picture(FrameT const&, std::vector<double>& milliseconds)> run;
        std::function<double()> bytes_per_pixel;
        std::vector<double> milliseconds{}; ///< from first_timed on
    };
    std::vector<Method> methods;
    std::vector<Entry> entries;

    template <class P> void add(Charted<P> const& named, ChartOptions const& options) {
        check_differ(options.externals, named.name);
        auto const pipeline = whole(named.pipeline);
        auto const history = std::make_shared<History<typename Charted<P>::Whole>>(options.size, pipeline);
        Threads<> const threads{.count = options.threads};
        auto const run = [=](FrameT const& frame, std::vector<double>& milliseconds) {
            auto const begin = std::chrono::steady_clock::now();
            auto const view = quell::run(pipeline, frame, *history, threads);
            std::chrono::duration<double, std::milli> const taken = std::chrono::steady_clock::now() - begin;
            if (frame.number >= ChartOptions::first_timed) milliseconds.push_back(taken.count());
            return metrics::picture_of(view);
        };
        methods.push_back({run, [history] { return history->bytes_per_pixel(); }});
        entries.push_back({named.name, named.competes});
    }
};

} // namespace quell::bench
