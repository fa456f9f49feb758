#pragma once

#include <quell/blur/inpainted_layer.hpp>
#include <quell/blur/two_motions/layer_classifier.hpp>
#include <quell/blur/two_motions/line_of_pixels.hpp>
#include <quell/blur/two_motions/row_tiles.hpp>
#include <quell/blur/two_motions/stratified_mean.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gathers the samples that pass each pixel while the shutter is open into a foreground and a background layer. The foreground's coverage
/// is the share of all samples along its velocity that show it, and the background is averaged over the rest of the time. Each sample is
/// tested by its own trajectory and weighted by the time it takes to cross a pixel, as a faster surface is seen in more pixels. A sample
/// stands for half a pixel of its trajectory, and counts half if it passes just as the shutter opens or closes; a longer footprint would
/// have less noise and more blur than the motion has. A static pixel keeps its value bit by bit. Emits ForegroundLayer, ForegroundSweep,
/// BackgroundLayer, and MeanSweep of the background: 0 if static, 4096 in both components if unknown. Needs a PairGuide before it.
/// @tparam S the pipeline's signal
/// @tparam Trajectories the PairGuide's
template <ChannelTag S, class Trajectories = StraightTrajectories> struct PairGather {
    using Signal = S;
    static constexpr auto name = "pair gather";
    static constexpr bool leaves_signal = true;
    using reads = Channels<LayerMotions<Trajectories>, SampleTrajectory<Trajectories>>;
    using emits = Channels<ForegroundLayer<Signal>, ForegroundSweep, BackgroundLayer<Signal>, MeanSweep>;
    static constexpr int max_samples = detail::LineOfPixels<>::max_steps; ///< largest useful `count`
    static constexpr int max_lanes = 8;                                   ///< largest useful SIMD width: a tile's
    static constexpr bool two_rows = true;                                ///< rows that share a pair look along the same lines
    int count = 64;      ///< samples per pixel, up to `max_samples`; with two velocities, half along each
    float reach = 0.65f; ///< how far to look along a sweep, as a fraction of it: samples farther away rarely pass in time
    float width = 1.f;   ///< pixels, above 0; distance of closest approach at which a sample's weight reaches 0; less for sweeps under 2
    float bend_influence = 0.1f;   ///< increase of `width` per pixel of bend, up to twice: bends are known less exactly
    float depth_tolerance = 0.02f; ///< relative difference of depth from which on a surface is behind another
    /// Pixels of a row, at least 1, that share their lines: neighbours' samples are then neighbours in memory. See max_lanes for wider
    /// packs.
    int tile_width = 8;

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        Work<Px> work(*this, px);
        if (any(either(work.of.two, work.back_moves)))
            tiles().for_each(px, [&](auto tile, int k) QUELL_INLINED { work.gather(px, tile, k); });
        return work.result(px);
    }

    /// @cond
    QUELL_KERNEL detail::RowTiles tiles() const { return {tile_width}; }
    /// Where a line looks for samples, or one of two lines.
    template <class Lane, class Mask>
    QUELL_KERNEL detail::LineOfPixels<Lane> line(vec2<Lane> const& speed, vec2<Lane> const& bend, Mask is_one_of_two) const {
        int const all = count < max_samples ? count : max_samples;
        return {speed, bend, reach, select(is_one_of_two, Lane(static_cast<float>(all / 2)), Lane(static_cast<float>(all)))};
    }
    /// @endcond

private:
    template <class Px> struct Work {
        using Real = typename Px::Real;
        using Mask = decltype(Real(0.f) < Real(0.f));
        using Lane = detail::LaneOf<Real>;
        using Colour = typename Px::Signal;
        using ScreenMotion = detail::ScreenMotion<Trajectories, Real>;
        PairGather const& settings;
        detail::UsableSample<Trajectories, Real> own;
        detail::LayerClassifier<Trajectories, Real> of;
        Mask own_in_front, own_still, back_moves;
        Real front_per_length;
        Real front_per_width, back_per_width; ///< inverse match radius of each layer, per pixel
        detail::StratifiedMean<Value<Signal::components + 1, Real>, max_samples + 1> in_front; ///< signal and coverage
        detail::StratifiedMean<Colour, max_samples + 1> behind;
        /// Weighted mean of sweeps, in pixels; 0 where no sample counted.
        struct Swept {
            /// @cond
            vec2<Real> sum{Real(0.f), Real(0.f)};
            Real weight = Real(0.f);
            QUELL_KERNEL void add(vec2<Real> const& of_sample, Real w) { sum = add_scaled(sum, of_sample, w), weight = weight + w; }
            QUELL_KERNEL auto known() const { return weight > Real(0.f); }
            QUELL_KERNEL auto mean() const { return scale(sum, 1.f / max(weight, Real(1e-12f))); }
            /// @endcond
        } front_swept, back_swept;
        Real samples = Real(0.f);

        QUELL_KERNEL Work(PairGather const& g, Px const& px)
            : settings(g), own(detail::usable_sample<Trajectories>(px)),
              of(px.elsewhere(g.tiles().shared(px), LayerMotions<Trajectories>{})), own_in_front(of.is_front(own.screen_motion())),
              own_still(detail::squared_speed(own.screen_motion()) <= Real(detail::still_squared)),
              back_moves(detail::squared_speed(of.back) > Real(detail::still_squared)),
              front_per_length(1.f / max(speed(of.front), Real(Trajectory<float>::min_length))), front_per_width(per_width(of.front)),
              back_per_width(per_width(of.back)), in_front(speed(of.front)), behind(speed(of.back)) {}

        /// One tile, by the velocities of lane k.
        QUELL_KERNEL void gather(Px const& px, Mask tile, int k) {
            in_front.restart(), behind.restart();
            if constexpr (Trajectories::bent && !records<Real>)
                if (lane(detail::sagitta_of(of.front), k) == 0.f && lane(detail::sagitta_of(of.back), k) == 0.f)
                    return gather_as<StraightTrajectories>(px, tile, k);
            gather_as<Trajectories>(px, tile, k);
        }
        /// @tparam As the model of trajectories: StraightTrajectories where nothing bends, which is cheaper
        template <class As> QUELL_KERNEL void gather_as(Px const& px, Mask tile, int k) {
            auto const behind_speed = detail::in_lane(detail::speed_of(of.back), k);
            auto const moves = dot(behind_speed, behind_speed) > Lane(detail::still_squared);
            auto const two = lane(detail::inverse_depth_of(of.front), k) > Lane(0.f);
            auto const shared = both(two, moves);
            if constexpr (records<Real>) {
                gather_along<As>(ForBoth{}, px, k, tile, of.front, shared, two, two);
                // The foreground's line had the pixel itself.
                gather_along<As>(ForBack{}, px, k, tile, of.back, shared, moves, both(moves, invert(two)));
            } else if (two) {
                gather_along<As>(ForBoth{}, px, k, tile, of.front, shared, true, true);
                if (moves) gather_along<As>(ForBack{}, px, k, tile, of.back, shared, true, false);
            } else if (moves)
                gather_along<As>(OnlyOne{}, px, k, tile, of.back, shared, true, true);
        }
        /// All lanes follow lane k's line, whatever each finds on it.
        /// @param shared whether two lines share the samples @param wanted whether there is this line @param itself and on it the pixel
        template <class As, class What, class LaneMask>
        QUELL_KERNEL void gather_along(What what, Px const& px, int k, Mask tile, ScreenMotion const& screen_motion, LaneMask shared,
                                       LaneMask wanted, LaneMask itself) {
            auto const speed = detail::in_lane(detail::speed_of(screen_motion), k),
                       bend = detail::in_lane(detail::bend_of(screen_motion), k);
            auto line = settings.line(speed, bend, shared);
            if constexpr (records<Real>) line.steps = masked(wanted, line.steps);
            line.for_each_with(
                itself, [&](auto dx, auto dy, auto... counts) QUELL_INLINED { add<As>(what, px, dx, dy, both(tile, counts...)); }, in_front,
                behind, front_swept, back_swept, samples);
        }

        // What a line collects: samples of both layers, of the background, or of the only layer.
        struct ForBoth {};
        struct ForBack {};
        struct OnlyOne {};

        /// Adds the sample at an offset to its layer.
        template <class As, class What> QUELL_KERNEL void add(What, Px const& px, auto dx, auto dy, Mask wanted) {
            auto const there = px.at(dx, dy);
            if (!there.any_row_inside()) return;
            auto sample = detail::usable_sample<Trajectories>(there).template as<As>();
            // Recorded, there is no other model where neither surface bends.
            if constexpr (Trajectories::bent && records<Real>)
                sample = sample.bent_where(either(detail::sagitta_of(of.front) != Real(0.f), detail::sagitta_of(of.back) != Real(0.f)));
            auto const usable = both(wanted, there.inside(), sample.known());
            vec2<Real> const away{Real(to_real(-dx)), Real(to_real(-dy))};
            auto for_back = both(usable, sample.moves());
            if constexpr (!std::is_same_v<What, OnlyOne>) {
                auto const shows_front = of.is_front(sample.screen_motion());
                for_back = both(for_back, invert(shows_front));
                if constexpr (std::is_same_v<What, ForBoth>)
                    if (any(usable)) add_front(there.signal(), sample, away, shows_front, usable);
            }
            if (any(for_back)) add_back(there.signal(), sample, away, for_back);
        }
        /// A sample that does not show the foreground is tested with the foreground's velocity: the number of samples must not depend on
        /// what they show.
        template <class Sample>
        QUELL_KERNEL void add_front(Colour const& value, Sample const& sample, vec2<Real> const& away, Mask shows_front, Mask counts) {
            auto const like_front = Sample::at_speed(of.front, front_per_length, sample, away);
            auto const looked_at = Sample{select(shows_front, sample.at, like_front.at)};
            auto const passing = looked_at.passing(away);
            auto const close = weight(counts, passing, looked_at, front_per_width);
            auto const w = close * looked_at.time_per_pixel();
            auto const hidden = both(own_still, invert(own_in_front), settings.is_behind(sample.inverse_depth(), own.inverse_depth()));
            auto const seen = masked(both(shows_front, invert(hidden)), w);
            // A sample that passes while the shutter is closed counts for the mean only if no other does.
            front_swept.add(sample.sweep(), seen + masked(both(shows_front, counts), Real(1e-4f)));
            in_front.add(detail::layer_of(scale(value, seen), seen), w, passing.when);
        }
        template <class Sample> QUELL_KERNEL void add_back(Colour const& value, Sample const& sample, vec2<Real> const& away, Mask counts) {
            auto const passing = sample.passing_in_motion(away);
            auto const close = weight(counts, passing, sample, back_per_width);
            auto const w = close * sample.time_per_pixel();
            behind.add(scale(value, w), w, passing.when);
            back_swept.add(sample.sweep(), w);
            samples = samples + close;
        }
        QUELL_KERNEL static Real weight(Mask counts, auto const& passing, auto const& sample, Real per_width) {
            // A sweep of less than a pixel counts as one pixel.
            auto const pixels_inside = min(passing.when, 1.f - passing.when) * max(sample.length(), Real(1.f));
            auto const open = clamp(fma(pixels_inside, Real(2.f), Real(0.5f)), Real(0.f), Real(1.f));
            return masked(counts, open * max(fma(passing.distance, -per_width, Real(1.f)), Real(0.f)));
        }
        QUELL_KERNEL Real per_width(ScreenMotion const& screen_motion) const {
            auto const bend = detail::bend_of(screen_motion);
            auto const bent = sqrt(fma(bend.x, bend.x, bend.y * bend.y));
            // A sweep of less than two pixels needs no more than the samples that it passes; others soften it.
            auto const pixels = settings.width * clamp(speed(screen_motion) * 0.5f, Real(0.25f), Real(1.f));
            return 1.f / fma(pixels, min(bent * settings.bend_influence, Real(1.f)), pixels);
        }
        QUELL_KERNEL static Real speed(ScreenMotion const& screen_motion) { return sqrt(detail::squared_speed(screen_motion)); }

        /// The background's mean over the time in which the foreground does not cover the pixel: what shows of it. Only where both layers
        /// have all strata, which are the same times then; with fewer there are too few samples in each to tell.
        QUELL_KERNEL Colour mean_behind(Real coverage) const {
            constexpr float fast = decltype(behind)::pixels_for_all;
            auto const certain = clamp(min(speed(of.front), speed(of.back)) * (1.f / fast) - 1.f, Real(0.f), Real(1.f));
            auto const hides = both(of.two, certain > Real(0.f));
            if (!any(hides)) return behind.mean();
            auto exposed = in_front.last_component();
            QUELL_UNROLL_ON_DEVICE
            for (auto& e : exposed.at) e = 1.f - masked(hides, mix(coverage, min(e, Real(1.f)), certain));
            return behind.mean(exposed);
        }
        QUELL_KERNEL auto result(Px const& px) const {
            auto const front_mean = in_front.mean();
            constexpr float beyond = 4.f * Trajectory<float>::longest;
            vec2<Real> const nowhere{Real(beyond), Real(beyond)};
            auto const still_here = both(own.known(), own_still, invert(own_in_front));
            auto const found = both(invert(still_here), back_swept.known());
            auto back = detail::layer_of(select(still_here, px.signal(), mean_behind(component<Signal::components>(front_mean))),
                                         select(still_here, Real(BackgroundLayer<Signal>::certain), masked(found, samples)));
            auto back_sweep = select(found, back_swept.mean(), zero<vec2<Real>>());
            auto const covered = invert(either(still_here, found));
            if (any(covered)) {
                back = select(covered, guessed(px), back);
                auto const nothing = both(covered, detail::weight_of(back) <= Real(0.f));
                back_sweep = select(both(covered, back_moves), detail::speed_of(of.back), back_sweep);
                back_sweep = select(nothing, nowhere, back_sweep);
            }
            // The number of samples is the sweep's length in pixels.
            auto const front = detail::layer_of(front_mean, masked(of.two, max(speed(of.front), Real(1.f))));
            auto const front_moves = select(front_swept.known(), front_swept.mean(), detail::speed_of(of.front));
            return emitted<Real>(ForegroundLayer<Signal>{}, front)
                .with(foreground_sweep, select(of.two, front_moves, nowhere))
                .with(BackgroundLayer<Signal>{}, back)
                .with(mean_sweep, back_sweep);
        }
        /// The background where no sample of it passes: from neighbours that show it.
        QUELL_KERNEL auto guessed(Px const& px) const {
            return detail::inpainted_layer(px, BackgroundLayer<Signal>::guessed, [&](auto const& neighbour) QUELL_INLINED {
                auto const there = detail::usable_sample<Trajectories>(neighbour);
                auto const still = both(invert(there.moves()), invert(settings.is_behind(own.inverse_depth(), there.inverse_depth())));
                auto const moving = both(there.known(), invert(of.is_front(there.screen_motion())));
                return either(both(back_moves, moving), both(invert(back_moves), still));
            });
        }
    };

    /// By inverse depth.
    template <class Real> QUELL_KERNEL auto is_behind(Real inverse_depth, Real before) const {
        return inverse_depth * (1.f + depth_tolerance) < before;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
