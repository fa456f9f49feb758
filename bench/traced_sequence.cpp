#include "traced_sequence.hpp"

#include <tracer/scenes/scenes.hpp>
#include <tracer/trace_frame.hpp>

namespace quell::bench {

template <bool open> std::vector<TracedInput<open>> const& traced_sequence(Extent size) {
    static std::vector<TracedInput<open>> made;
    if (!made.empty() && made.front().size == size) return made;
    made.clear();
    tracer::PreparedScene scene(tracer::built_in_scene(open ? "mixed" : "room"));
    tracer::RenderSettings settings{.size = size, .shutter = open ? 0.5f : 0.f};
    for (; settings.frame < sequence_frames; ++settings.frame) {
        tracer::trace_frame(scene, settings, made.emplace_back(size));
        made.back().number.reset(); // so that the first frame may follow the last
    }
    return made;
}

template std::vector<TracedInput<false>> const& traced_sequence<false>(Extent size);
template std::vector<TracedInput<true>> const& traced_sequence<true>(Extent size);

} // namespace quell::bench
