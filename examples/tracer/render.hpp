#pragma once

#include "effect_sweep.hpp"
#include "gradient.hpp"
#include "guides.hpp"
#include "render_settings.hpp"

#include <baselines/gradient_samples.hpp>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>

namespace quell::tracer {

/// Takes what was rendered: `sink.put(quell::normal, x, y, value)` with a float, glm::vec2 or glm::vec3 by the channel's components.
/// It is called from several threads at once, never twice for the same pixel and channel.
template <class S>
concept Sink = requires(S& sink, glm::vec3 value) {
    sink.put(quell::normal, 0, 0, value);
};

namespace detail {

/// Whether samples of a pixel see different places at one time too.
[[nodiscard]] inline bool places_differ(PreparedScene const& scene, RenderSettings const& settings) {
    return settings.jitter == Jitter::pixel || scene.spreads_primary_rays();
}
/// Whether all samples of a pixel see the same point, so that one primary ray serves them all.
[[nodiscard]] inline bool one_ray_per_pixel(PreparedScene const& scene, RenderSettings const& settings) {
    return !(settings.shutter > 0) && !places_differ(scene, settings);
}

/// For two numbers in [0, 1), a point in the unit disk.
[[nodiscard]] inline glm::vec2 disk_point(glm::vec2 uniform) {
    float const radius = std::sqrt(uniform.x), turn = 2 * pi * uniform.y;
    return {radius * std::cos(turn), radius * std::sin(turn)};
}

/// Renders one pixel after the other; nothing is shared between pixels, so order and thread make no difference.
template <class Wanted, Sink S> class PixelRenderer {
    using rays = Rays<Wanted>;

public:
    /// `earlier`: the scene standing one frame before, where gradients are wanted and there is one.
    PixelRenderer(PreparedScene const& scene_, PreparedScene const* earlier_, RenderSettings const& settings_, S& sink_, RayCounts& counts_)
        : scene(scene_), earlier(earlier_), settings(settings_), sink(sink_), counts(counts_),
          still(scene_.camera(0, When::now), settings_.size), halfway(scene_.camera(0.5f, When::now), settings_.size),
          closing(scene_.camera(1, When::now), settings_.size) {}

    /// Where all samples see the same point, one primary ray serves them. Else each has its own time, place in the pixel or on the lens, or
    /// goes through what others meet. What says where something is, is the first sample's, as a mean of places is no place; the other
    /// guides are means only if the samples' places differ.
    void render(int x, int y) {
        x_ = x, y_ = y;
        bool const one_ray = one_ray_per_pixel(scene, settings), means = places_differ(scene, settings);
        Signals mean;
        MeanGuides guides;
        Seen seen;
        glm::vec3 sum{0.f};
        for (int i = 0; i < settings.samples_per_pixel; ++i) {
            if (i == 0 || !one_ray) seen = look_for(i, i == 0 || means, guides);
            auto const signals = signals_of(seen, i);
            sum += composite(seen, signals);
            if (i > 0) {
                add_to_mean(mean, signals, i);
            } else {
                mean = signals;
                put_sweeps(seen, signals);
            }
        }
        // More samples for the guides alone.
        for (int i = settings.samples_per_pixel; means && i < settings.guide_samples; ++i) look_for(i, true, guides);
        put_guides(guides.value());
        put_signals(mean);
        put(radiance, one_ray ? composite(seen, mean) : sum / static_cast<float>(settings.samples_per_pixel));
    }

private:
    /// What a sample sees. The first one's place goes to the sink.
    Seen look_for(int sample, bool adds_guides, MeanGuides& guides) {
        float const time = time_of(sample);
        View const view{scene.camera(time, When::now), settings.size};
        auto const seen = look(view, sample, time);
        if (!adds_guides) return seen;
        View const before{scene.camera(time, When::before), settings.size};
        auto const of_sample = guides_of<Wanted>(scene, seen, view, before);
        guides.add(of_sample);
        if (sample > 0) return seen;
        put_place(seen, view, of_sample.previous);
        if constexpr (wants_gradients<Wanted>) put_gradients(seen, view, before);
        return seen;
    }

    [[nodiscard]] float time_of(int sample) const {
        if (!(settings.shutter > 0)) return 0;
        if (settings.frozen_at) return *settings.frozen_at;
        return settings.stratified_times ? sample_pair(key(sample), SampleUse::time).x : lone_sample(key(sample), SampleUse::time);
    }

    /// Where in the image a sample's primary ray goes through.
    [[nodiscard]] glm::vec2 place_in_image(int sample) const {
        glm::vec2 const centre{static_cast<float>(x_) + 0.5f, static_cast<float>(y_) + 0.5f};
        if (settings.jitter == Jitter::none) return centre;
        if (settings.jitter == Jitter::pixel) return centre + filter_offset(sample_pair(key(sample), SampleUse::pixel_filter));
        return centre + camera_jitter(settings.jitter, settings.frame);
    }

    static constexpr std::uint32_t guides_seed = 0x6d1de5u; ///< tells the sequence of guides' samples from the light's

    /// @param sample those from samples_per_pixel on are of guides alone
    [[nodiscard]] SampleKey key(int sample, int frames_ago = 0) const {
        // Frame after frame continues one sequence per pixel.
        int const frame = settings.frame - frames_ago;
        if (int const further = sample - settings.samples_per_pixel; further >= 0) {
            // That of the guides alone is another one: what follows here are the light's samples of the next frame.
            int const in_frame = settings.guide_samples - settings.samples_per_pixel;
            return {{x_, y_},
                    static_cast<std::uint32_t>(frame * in_frame + settings.first_sample + further),
                    combine(settings.seed, guides_seed)};
        }
        auto const index = static_cast<std::uint32_t>(frame * settings.samples_per_pixel + settings.first_sample + sample);
        return {{x_, y_}, index, settings.seed};
    }

    Seen look(View const& view, int sample, float time) {
        ++counts.primary;
        auto const on_lens = scene.has_lens() ? disk_point(sample_pair(key(sample), SampleUse::lens)) : glm::vec2{0.f};
        float const met = scene.has_partial_coverage() ? sample_pair(key(sample), SampleUse::see_through).x : 0.f;
        return seen_along(scene, view, view.ray(place_in_image(sample), on_lens, time), met);
    }

    Signals signals_of(Seen const& seen, int sample) {
        if (seen.hit) {
            PathContext const path{key(sample), seen.ray.time, &counts};
            return trace_signals<Wanted>(scene, seen.surface, -seen.ray.direction, path, still.pixel_angle());
        }
        Signals signals;
        signals.direct = scene.description().background.radiance(seen.ray.direction);
        signals.indirect_direction = seen.surface.normal;
        return signals;
    }

    static glm::vec3 composite(Seen const& seen, Signals const& signals) { return tracer::composite(seen.albedo(), signals); }

    template <class C, class Value> void put([[maybe_unused]] C channel, [[maybe_unused]] Value const& value) {
        if constexpr (Wanted::template has<C>) sink.put(channel, x_, y_, value);
    }

    void put_place(Seen const& seen, View const& view, glm::vec3 previous) {
        put(depth, seen.hit ? view.depth(seen.surface.position) : infinity);
        put(position, seen.surface.position);
        put(receiver_previous, previous);
        put(instance, static_cast<float>(seen.hit.instance + 1));
        put(time, seen.ray.time);
    }

    void put_guides(Guides const& guides) {
        put(normal, guides.normal);
        put(albedo, guides.albedo);
        put(roughness, guides.roughness);
        put(motion, guides.motion);
    }

    /// Where the image shows the point that was seen, or the direction of the sky, at a time of the open shutter.
    [[nodiscard]] glm::vec2 place_of(Seen const& seen, View const& view, float time) const {
        return seen.hit ? view.project(scene.point(seen.hit, time, When::now)) : view.project(seen.ray.direction, 0);
    }

    [[nodiscard]] glm::vec2 sweep_of(Seen const& seen) const { return place_of(seen, closing, 1) - place_of(seen, still, 0); }

    /// Of the first sample, which the signals belong to.
    void put_sweeps(Seen const& seen, Signals const& signals) {
        if constexpr (Wanted::template has<Sweep>) put(sweep, sweep_of(seen));
        if constexpr (Wanted::template has<SweepBend>)
            put(sweep_bend, place_of(seen, halfway, 0.5f) - (place_of(seen, still, 0) + place_of(seen, closing, 1)) * 0.5f);
        if constexpr (Wanted::template has<SweepOf<Visibility>>)
            put_effect_sweep(SweepOf<Visibility>{}, seen, [&](auto const& moment) { return shadow_place(moment, signals, seen.ray.time); });
        if constexpr (Wanted::template has<SweepOf<Glossy>>)
            put_effect_sweep(SweepOf<Glossy>{}, seen, [&](auto const& moment) { return reflection_place(moment, signals); });
    }

    /// `place` at the shutter's closing less that at its opening; where either isn't anywhere, the surface's own sweep.
    template <class C> void put_effect_sweep(C channel, Seen const& seen, auto const& place) {
        auto const way = place(ShutterMoment{scene, seen.hit, closing, 1}) - place(ShutterMoment{scene, seen.hit, still, 0});
        put(channel, std::isfinite(way.x + way.y) ? way : sweep_of(seen));
    }

    /// With the random numbers that this pixel's first sample had in the last frame.
    void put_gradients(Seen const& seen, View const& view, View const& before) {
        using signals = gradient_signals<Wanted>;
        GradientSamples const samples{settings.size, settings.frame, static_cast<std::int32_t>(settings.seed)};
        bool const chosen = seen.hit && earlier != nullptr && samples.has(x_, y_);
        if (chosen && shade_in_both_frames(seen, view, before)) return;
        for_each_channel(signals{}, [&]<class Signal>(Signal) { put(GradientOf<Signal>{}, glm::vec2{0.f}); });
    }

    bool shade_in_both_frames(Seen const& seen, View const& view, View const& before) {
        PathContext const path{key(0, 1), seen.ray.time, &counts};
        TwoFrames const frames{scene, *earlier, view, before, settings.size};
        return shade_twice<Wanted>(
            frames, seen.hit, path, [&](Surface const& a, Signals const& now, Surface const& b, Signals const& then) {
                for_each_channel(gradient_signals<Wanted>{}, [&]<class Signal>(Signal s) {
                    put(GradientOf<Signal>{}, GradientSamples::gradient(luminance_of(s, a, now), luminance_of(s, b, then)));
                });
            });
    }

    void put_signals(Signals const& signals) {
        put(direct, signals.direct);
        put(visibility, signals.visibility);
        put(light, signals.light);
        put(light_previous, signals.light_previous);
        put(blocker, signals.blocker);
        put(blocker_previous, signals.blocker_previous);
        put(glossy, signals.glossy);
        put(glossy_hit, signals.glossy_hit);
        put(glossy_hit_previous, signals.glossy_hit_previous);
        put(indirect, signals.indirect);
        put(indirect_direction, signals.indirect_direction);
    }

    PreparedScene const& scene;
    PreparedScene const* earlier;
    RenderSettings const& settings;
    S& sink;
    RayCounts& counts;
    View still, halfway, closing; // at the beginning of the open shutter, in its middle and at its end
    int x_ = 0, y_ = 0;
};

} // namespace detail

/// What this tracer can make: it knows nothing of the next frame, and its pixels all have the same number of samples.
using TracedChannels = without<AllChannels, Channels<MotionNext, SampleCount, SampleVariance>>;

/// Traces the channels in `Wanted`, exactly the rays that they need, and hands every pixel to the sink. Visibility, direct, glossy,
/// indirect and radiance are means over the samples. So are normal (at unit length), albedo, roughness and motion where Jitter::pixel sends
/// samples to different places; all other channels are those of the first sample, gradients too. Without it, primary rays go through one
/// place per pixel whatever the number of samples, so that signals always match the guides. Frame 0 has nothing before it: no gradients.
/// The picture doesn't depend on the number of threads.
template <class Wanted, Sink S> RayCounts render(PreparedScene& scene, RenderSettings const& settings, S& sink) {
    detail::check(settings);
    scene.move_to(static_cast<float>(settings.frame), settings.shutter, settings.shutter_keys);
    PreparedScene const* const earlier = wants_gradients<Wanted> && settings.frame > 0 ? &scene.one_frame_earlier() : nullptr;
    constexpr int tile = 16;
    RayCounts total;
    std::mutex mutex;
    tbb::task_arena arena{settings.threads > 0 ? settings.threads : tbb::task_arena::automatic};
    arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range2d<int>{0, settings.size.height, tile, 0, settings.size.width, tile}, [&](auto const& range) {
            RayCounts counts;
            detail::PixelRenderer<Wanted, S> renderer{scene, earlier, settings, sink, counts};
            for (int y = range.rows().begin(); y != range.rows().end(); ++y)
                for (int x = range.cols().begin(); x != range.cols().end(); ++x) renderer.render(x, y);
            std::lock_guard const lock{mutex};
            total += counts;
        });
    });
    return total;
}

} // namespace quell::tracer
