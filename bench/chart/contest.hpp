#pragma once

#include "external.hpp"
#include "method.hpp"

#include <tracer/trace_frame.hpp>

#include <tuple>

namespace quell::bench {

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
        for (auto const& method : methods) {
            auto picture = method->run(frame);
            if (judge) pictures.push_back(std::move(picture));
        }
        if (judge) judge->measure(*frame.number, entries, pictures);
    }

    void put_rows(Judge const& judge, std::vector<Row>& rows) const {
        for (std::size_t m = 0; m < methods.size(); ++m)
            rows.push_back(judge.row_of(entries[m], methods[m]->ms_per_frame(), methods[m]->bytes_per_pixel()));
    }

private:
    std::vector<std::unique_ptr<Method<FrameT>>> methods;
    std::vector<Entry> entries;

    template <class P> void add(Charted<P> const& named, ChartOptions const& options) {
        check_differ(options.externals, named.name);
        methods.push_back(std::make_unique<MethodOf<FrameT, typename Charted<P>::Whole>>(whole(named.pipeline), options));
        entries.push_back({named.name, named.competes});
    }
};

} // namespace quell::bench
