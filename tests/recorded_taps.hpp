#pragma once

#include <quell/pipeline/graph/job_in_scope.hpp>
#include <quell/pipeline/run.hpp>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

// An executor that records how far a pass looks around, to hold against what its policies declare.
namespace quell::tests {

/// How far a pass says that it looks, and how far it has looked, in pixels.
struct RecordedPass {
    std::string_view name;
    int declared = 0, found = 0;
};

/// The pixel that is computed, and the largest distance from it, along x or y, at which an image was read.
struct TapRecorder {
    int x = 0, y = 0, farthest = 0;

    /// @param fraction of the image that is read, and
    /// @param of_pass  of the pass; one is a multiple of the other
    void note(int column, int row, int fraction, int of_pass) {
        int const first[] = {column * fraction, row * fraction}, here[] = {x * of_pass, y * of_pass};
        for (int i = 0; i < 2; ++i) {
            // Rows or columns of the frame from the pixel to the nearest that the other one covers: 0 of a coarse one over it.
            int const before = here[i] - (first[i] + fraction - 1), behind = first[i] - (here[i] + of_pass - 1);
            farthest = std::max(farthest, (std::max(before, behind) + of_pass - 1) / of_pass);
        }
    }
};

/// A view that notes where it is read. It has `get` only, so all reads go through it.
template <class View> struct RecordedView {
    using Element = typename View::Element;
    static constexpr int components = View::components;
    Extent size{};
    View inner{};
    TapRecorder* recorder = nullptr;
    int fraction = 1, of_pass = 1;

    [[nodiscard]] float get(int c, int x, int y) const {
        recorder->note(x, y, fraction, of_pass);
        return inner.get(c, x, y);
    }
    void set(int c, int x, int y, float value) const { inner.set(c, x, y, value); }
};
template <class View> RecordedView<View> recorded(View const& view, TapRecorder& recorder, int fraction, int of_pass) {
    return {view.size, view, &recorder, fraction, of_pass};
}

/// Views<...> of which all are recorded.
template <class Inner, class Set> struct RecordedViewSet;
template <class Inner, class... Cs>
struct RecordedViewSet<Inner, Channels<Cs...>>
    : detail::Slot<Cs, RecordedView<std::remove_cvref_t<decltype(std::declval<Inner const&>().view(Cs{}))>>>... {
    using channels = Channels<Cs...>;
    template <ChannelTag C> auto const& view(C) const { return detail::slot<C>(*this); }
};
template <class Inner>
RecordedViewSet<Inner, typename Inner::channels> recorded_set(Inner const& views, TapRecorder& recorder, int of_pass) {
    return [&]<class... Cs>(Channels<Cs...>) {
        return RecordedViewSet<Inner, Channels<Cs...>>{{recorded(views.view(Cs{}), recorder, Cs::fraction, of_pass)}...};
    }(typename Inner::channels{});
}

/// Runs one pixel at a time, and records each pass's taps in images of this frame. Those of the last frame are complete, however far away.
struct RecordingExecutor {
    std::vector<RecordedPass>* passes;

    void for_each_pixel(Region region, auto const& job) const { Serial{}.for_each_pixel(region, job); }

    template <class Pass, class F, class M, class S, class PS, class K, class Then, PassTraits traits, class V, class SignalView,
              class Made, class Work, class Set, bool marks>
    void
    for_each_pixel(Region r,
                   detail::PassJob<Pass, Scope<F, M, S, PS, K, Then, traits, V>, SignalView, Made, Work, Set, marks> const& job) const {
        TapRecorder recorder;
        auto const& s = job.scope;
        using Recorded = Scope<RecordedViewSet<F, typename F::channels>, RecordedViewSet<M, typename M::channels>, RecordedView<S>, PS, K,
                               Then, traits, V>;
        Recorded const scope{.size = s.size,
                             .frame = recorded_set(s.frame, recorder, traits.fraction),
                             .made = recorded_set(s.made, recorder, traits.fraction),
                             .signal = recorded(s.signal, recorder, 1, traits.fraction),
                             .signal_then = s.signal_then,
                             .kept_then = s.kept_then,
                             .remembered = s.remembered,
                             .clip_from_world = s.clip_from_world,
                             .clip_from_world_then = s.clip_from_world_then,
                             .rays = s.rays,
                             .rays_then = s.rays_then,
                             .jitter = s.jitter,
                             .jitter_then = s.jitter_then,
                             .shutter = s.shutter,
                             .shutter_then = s.shutter_then,
                             .frame_index = s.frame_index,
                             .has_past = s.has_past,
                             .vectors = s.vectors};
        auto const recording = detail::job_in_scope(job, scope);
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                recorder.x = x, recorder.y = y;
                recording(at_once<float>, x, y, 1);
            }
        passes->push_back({job.name, detail::farthest_tap_of(job.pass), recorder.farthest});
    }
};

} // namespace quell::tests
