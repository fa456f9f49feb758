#pragma once

#include "effect_sweep.hpp"
#include "gradient.hpp"

#include <quell/core/error.hpp>
#include <quell/frame/gradient_samples.hpp>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <string>

namespace quell::tracer {

struct RenderSettings {
    Extent size{480, 270};
    int frame = 0;
    int samples_per_pixel = 1;
    std::uint32_t seed = 0;
    int threads = 0;                         ///< 0: as many as the machine has
    float shutter = 0;                       ///< part of the frame time during which the shutter is open; 0: a frozen moment
    int first_sample = 0;                    ///< number of the first sample, to continue an earlier rendering of the same frame
    int bounces = 1;                         ///< how often indirect light is scattered on its way
    int shutter_keys = default_shutter_keys; ///< moments of the open shutter between which all moves straight: 2 as in MB, more for arcs
    bool stratified_times = true;            ///< false: each sample's time takes no notice of the pixel's others, as in MB
    /// The time of every sample, in [0, 1] over the open shutter: a sharp picture, whose sweeps still last as long as the shutter is open.
    /// References are blurred nevertheless.
    std::optional<float> frozen_at{};
};

/// Takes what was rendered: `sink.put(quell::normal, x, y, value)` with a float, glm::vec2 or glm::vec3 by the channel's components.
/// It is called from several threads at once, never twice for the same pixel and channel.
template <class S>
concept Sink = requires(S& sink, glm::vec3 value) {
    sink.put(quell::normal, 0, 0, value);
};

namespace detail {

/// Renders one pixel after the other; nothing is shared between pixels, so order and thread make no difference.
template <class Wanted, Sink S> class PixelRenderer {
    using rays = Rays<Wanted>;

public:
    /// `earlier`: the scene standing one frame before, where gradients are wanted and there is one.
    PixelRenderer(PreparedScene const& scene_, PreparedScene const* earlier_, RenderSettings const& settings_, S& sink_, RayCounts& counts_)
        : scene(scene_), earlier(earlier_), settings(settings_), sink(sink_), counts(counts_),
          still(scene_.camera(0, When::now), settings_.size), still_before(scene_.camera(0, When::before), settings_.size),
          halfway(scene_.camera(0.5f, When::now), settings_.size), closing(scene_.camera(1, When::now), settings_.size) {}

    void render(int x, int y) {
        x_ = x, y_ = y;
        if (settings.shutter > 0)
            render_over_time();
        else
            render_frozen();
    }

private:
    struct Seen {
        Ray ray;
        Hit hit;
        Surface surface;
    };

    /// The scene stands still: one primary ray serves all samples.
    void render_frozen() {
        auto const seen = look(still, 0);
        put_guides(seen, still, still_before);
        if constexpr (wants_gradients<Wanted>) put_gradients(seen, still, still_before);
        Signals mean = signals_of(seen, 0);
        for (int i = 1; i < settings.samples_per_pixel; ++i) accumulate(mean, signals_of(seen, i), i);
        put_sweeps(seen, mean);
        put_signals(mean);
        put(radiance, composite(seen, mean));
    }

    /// Every sample has its own time, unless all are frozen at one, and so its own primary ray. Guides are those of the first one.
    void render_over_time() {
        Signals mean;
        glm::vec3 sum{0.f};
        for (int i = 0; i < settings.samples_per_pixel; ++i) {
            float const time = settings.frozen_at.value_or(time_of(key(i)));
            View const view{scene.camera(time, When::now), settings.size};
            auto const seen = look(view, time);
            if (i == 0) {
                View const before{scene.camera(time, When::before), settings.size};
                put_guides(seen, view, before);
                if constexpr (wants_gradients<Wanted>) put_gradients(seen, view, before);
            }
            auto const signals = signals_of(seen, i);
            if (i == 0) {
                mean = signals;
                put_sweeps(seen, signals);
            } else {
                accumulate(mean, signals, i);
            }
            sum += composite(seen, signals);
        }
        put_signals(mean);
        put(radiance, sum / static_cast<float>(settings.samples_per_pixel));
    }

    [[nodiscard]] float time_of(SampleKey const& sample) const {
        return settings.stratified_times ? sample_pair(sample, SampleUse::time).x : lone_sample(sample, SampleUse::time);
    }
    [[nodiscard]] glm::vec2 centre() const { return {static_cast<float>(x_) + 0.5f, static_cast<float>(y_) + 0.5f}; }

    [[nodiscard]] SampleKey key(int sample, int frames_ago = 0) const {
        // Frame after frame continues one sequence per pixel.
        int const frame = settings.frame - frames_ago;
        auto const index = static_cast<std::uint32_t>(frame * settings.samples_per_pixel + settings.first_sample + sample);
        return {{x_, y_}, index, settings.seed};
    }

    Seen look(View const& view, float time) {
        ++counts.primary;
        Seen seen{{view.eye(), view.direction(centre()), infinity, time}, {}, {}};
        seen.hit = scene.intersect(seen.ray);
        if (seen.hit)
            seen.surface = surface_at(scene, seen.ray, seen.hit, view.pixel_angle());
        else
            seen.surface.normal = -seen.ray.direction;
        return seen;
    }

    Signals signals_of(Seen const& seen, int sample) {
        if (seen.hit) {
            PathContext const path{key(sample), seen.ray.time, settings.bounces, &counts};
            return trace_signals<Wanted>(scene, seen.surface, -seen.ray.direction, path, still.pixel_angle());
        }
        Signals signals;
        signals.direct = scene.description().background.radiance(seen.ray.direction);
        signals.indirect_direction = seen.surface.normal;
        return signals;
    }

    static void accumulate(Signals& mean, Signals const& next, int count) {
        float const part = 1 / static_cast<float>(count + 1);
        mean.visibility += (next.visibility - mean.visibility) * part;
        mean.direct += (next.direct - mean.direct) * part;
        mean.glossy += (next.glossy - mean.glossy) * part;
        mean.indirect += (next.indirect - mean.indirect) * part;
    }

    static bool has_reflectance(Seen const& seen) { return seen.hit && !seen.surface.is_emitter; }
    static glm::vec3 albedo_of(Seen const& seen) { return has_reflectance(seen) ? seen.surface.diffuse() : glm::vec3{1.f}; }

    static glm::vec3 composite(glm::vec3 diffuse, Signals const& signals) {
        return signals.direct * signals.visibility + signals.glossy + diffuse * signals.indirect;
    }
    static glm::vec3 composite(Seen const& seen, Signals const& signals) { return composite(albedo_of(seen), signals); }

    template <class C, class Value> void put([[maybe_unused]] C channel, [[maybe_unused]] Value const& value) {
        if constexpr (Wanted::template has<C>) sink.put(channel, x_, y_, value);
    }

    void put_guides(Seen const& seen, View const& view, View const& before) {
        auto const& surface = seen.surface;
        put(depth, seen.hit ? view.depth(surface.position) : infinity);
        put(position, surface.position);
        put(normal, surface.normal);
        put(albedo, albedo_of(seen));
        put(roughness, has_reflectance(seen) ? surface.roughness : 1.f);
        put(instance, static_cast<float>(seen.hit.instance + 1));
        put(time, seen.ray.time);
        if constexpr (rays::previous) put_previous(seen, view, before);
    }

    void put_previous(Seen const& seen, View const& view, View const& before) {
        auto const previous = seen.hit ? scene.point(seen.hit, seen.ray.time, When::before) : glm::vec3{not_a_number};
        put(receiver_previous, previous);
        // Both ends are projected, so that rounding cancels and what stands still has a motion of exactly zero.
        if (seen.hit)
            put(motion, before.project(previous) - view.project(scene.point(seen.hit, seen.ray.time, When::now)));
        else
            put(motion, before.project(seen.ray.direction, 0) - view.project(seen.ray.direction, 0));
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

    template <class Signal> static float luminance_of(Signal, Surface const& surface, Signals const& signals) {
        if constexpr (std::is_same_v<Signal, Visibility>) return signals.visibility;
        if constexpr (std::is_same_v<Signal, Glossy>) return luminance(signals.glossy);
        if constexpr (std::is_same_v<Signal, Indirect>) return luminance(signals.indirect);
        if constexpr (std::is_same_v<Signal, Radiance>) return luminance(composite(surface.diffuse(), signals));
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
        PathContext const path{key(0, 1), seen.ray.time, settings.bounces, &counts};
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
    View still, still_before, halfway, closing; // at the beginning of the open shutter, a frame before, in its middle and at its end
    int x_ = 0, y_ = 0;
};

inline void check(RenderSettings const& settings) {
    if (settings.size.width <= 0 || settings.size.height <= 0)
        throw Error{"render size", to_string(settings.size), "give a width and a height of at least 1"};
    if (settings.samples_per_pixel <= 0) throw Error{"samples per pixel", std::to_string(settings.samples_per_pixel), "give at least 1"};
    if (!(settings.shutter >= 0 && settings.shutter <= 1))
        throw Error{"shutter", std::to_string(settings.shutter), "give a part of the frame time from 0 to 1"};
    if (settings.shutter_keys < 2 || settings.shutter_keys > most_shutter_keys)
        throw Error{"shutter keys", std::to_string(settings.shutter_keys), "give 2 to " + std::to_string(most_shutter_keys)};
    if (settings.frozen_at && !(*settings.frozen_at >= 0 && *settings.frozen_at <= 1))
        throw Error{"time of a frozen frame", std::to_string(*settings.frozen_at), "give a time from 0 to 1 over the open shutter"};
}

} // namespace detail

/// Traces the channels in `Wanted`, exactly the rays that they need, and hands every pixel to the sink. Primary rays go through pixel
/// centres whatever the number of samples per pixel, so signals always match the guides; visibility, direct, glossy, indirect and
/// radiance are means over the samples, all other channels are those of the first one. Frame 0 has nothing before it: no gradients. The
/// picture doesn't depend on the number of threads.
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
