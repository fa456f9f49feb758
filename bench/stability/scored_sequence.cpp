#include "scored_sequence.hpp"

#include <quell/io/frame_image.hpp>
#include <tracer/gltf/gltf.hpp>
#include <tracer/reference.hpp>
#include <tracer/trace_frame.hpp>

#include <algorithm>
#include <functional>

namespace quell::stability {
namespace {

/// Whatever any preset reads.
using Traced = tracer::TracedChannels;
using TracedFrame = Frame<Traced>;

metrics::Picture times(metrics::Picture a, metrics::Picture const& b) {
    std::ranges::transform(a.pixels, b.pixels, a.pixels.begin(), std::multiplies{});
    return a;
}

metrics::Picture white(Extent size) { return {size, std::vector(static_cast<std::size_t>(size.pixels()), glm::vec3{1})}; }

void fill(TracedFrame& frame, auto channel, metrics::Picture const& from) {
    for (int y = 0; y < from.size.height; ++y)
        for (int x = 0; x < from.size.width; ++x) frame[channel].set(x, y, from.pixels[static_cast<std::size_t>(y * from.size.width + x)]);
}

metrics::Picture picture(TracedFrame const& frame, auto channel) { return metrics::picture_of(frame[channel].view()); }

/// What a signal is multiplied by on its way into the picture.
metrics::Picture factor(TracedFrame const& frame, Signal signal) {
    if (signal == Signal::shadow) return picture(frame, direct);
    return signal == Signal::glossy ? white(frame.size) : picture(frame, albedo);
}

void keep_share(TracedFrame& frame, Signal signal) {
    auto const scale = factor(frame, signal);
    if (signal == Signal::shadow) fill(frame, radiance, times(picture(frame, visibility), scale));
    if (signal == Signal::glossy) fill(frame, radiance, picture(frame, glossy));
    if (signal == Signal::indirect) fill(frame, radiance, times(picture(frame, indirect), scale));
    if (signal != Signal::whole) fill(frame, albedo, scale);
}

metrics::Picture share(tracer::PreparedScene& scene, tracer::RenderSettings const& settings, Signal signal, Making const& making) {
    tracer::ReferenceSettings const how{.tolerance = making.tolerance, .max_samples = making.max_samples};
    auto const of = [&](auto channel) { return tracer::reference<Channels<decltype(channel)>>(scene, settings, how); };
    switch (signal) {
    case Signal::shadow: {
        auto const found = of(visibility);
        return times(found[visibility], found[direct]);
    }
    case Signal::indirect: {
        auto const found = of(indirect);
        return times(found[indirect], found[albedo]);
    }
    case Signal::glossy:
        return of(glossy)[glossy];
    case Signal::whole:
        break;
    }
    return of(radiance)[radiance];
}

io::ExrImage frame_of(tracer::PreparedScene& scene, tracer::RenderSettings const& settings, Signal signal) {
    TracedFrame frame(settings.size);
    tracer::trace_frame(scene, settings, frame);
    keep_share(frame, signal);
    return io::image_of(frame);
}

} // namespace

ScoredSequence traced(Shot const& shot, Making const& making) {
    auto description = tracer::open_scene(shot.scene);
    if (shot.change) shot.change(description);
    tracer::PreparedScene scene(std::move(description));
    ScoredSequence sequence{making.size, shot.first, shot.scored_from, {}, {}, {}};
    tracer::RenderSettings settings{.size = making.size, .seed = making.seed, .threads = making.threads, .shutter = shot.shutter};
    settings.guide_samples = shot.guide_samples;
    for (settings.frame = shot.first; settings.frame <= shot.last; ++settings.frame) {
        sequence.frames.push_back(frame_of(scene, settings, shot.signal));
        if (settings.frame < shot.scored_from) continue;
        auto converged = settings;
        converged.seed = 0; // the same for any noise
        sequence.references.push_back(share(scene, converged, shot.signal, making));
        if (shot.effect) sequence.masks.push_back(tracer::effect_mask(scene, converged, *shot.effect));
    }
    return sequence;
}

std::vector<float>& plane(io::ExrImage& image, std::string const& name) {
    static_cast<void>(image[name]); // complains, listing what there is
    return std::ranges::find(image.planes, name, &io::Plane::name)->values;
}

} // namespace quell::stability
