#pragma once

#include <baselines/pixel_under.hpp>
#include <quell/blur/trajectory/trajectory.hpp>
#include <quell/filter/filter_kernel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Pre-filter: averages a moving pixel with samples from far along its trajectory that pass it as well, up to 18 of them: two random places
/// on the trajectories of each of the 3x3 pixels around (MB section 4.2). Static and slow pixels keep their value.
/// @tparam Trajectories StraightTrajectories or BentTrajectories, whose bend is ignored
template <class Trajectories = StraightTrajectories> struct SampleCollector {
    static constexpr auto name = "sample collector";
    using parts = Parts<Trajectories>;
    int samples = 2;        ///< random places per trajectory, at most 8
    int radius = 1;         ///< pixels; neighbours whose trajectories are used: 1 is MB's 3x3
    float threshold = 2.5f; ///< pixels; samples that pass nearer count, all with weight 1
    float min_length = 3.f; ///< pixels; shorter sweeps are skipped
    float jitter = 1.5f;    ///< largest offset of a place from the trajectory, in x and in y, in pixels

    template <class Px> QUELL_KERNEL auto filter(Px const& px) const {
        using Real = typename Px::Real;
        auto const wanted = both(Trajectories::here(px).squared >= Real(min_length * min_length), invert(px.missing()));
        auto sum = px.signal();
        if (!any(wanted)) return sum;
        Real count(1.f);
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                for (int k = 0; k < samples; ++k) {
                    auto const neighbour = px.at(dx, dy);
                    PixelUnder<Px> const there(px, place(neighbour, k));
                    auto const [value, missing] = px.signal_elsewhere(there.place);
                    auto const counts = both(wanted, neighbour.inside(), there.inside, invert(missing), passes(px, there));
                    sum = add_scaled(sum, value, masked(counts, Real(1.f)));
                    count = count + masked(counts, Real(1.f));
                }
        return scale(sum, 1.f / count);
    }

private:
    template <class Px> QUELL_KERNEL vec2<typename Px::Real> place(Px const& px, int k) const {
        using Real = typename Px::Real;
        auto const path = Trajectories::here(px);
        auto const p = px.position();
        auto const when = px.random_uniforms(2 * k).first;
        auto const [jx, jy] = px.random_uniforms(2 * k + 1);
        auto const since = when - path.time;
        // fma fixes the rounding, which decides which pixel is visited.
        return {fma(path.sweep.x, since, fma(jx, Real(2.f * jitter), p.x - jitter)),
                fma(path.sweep.y, since, fma(jy, Real(2.f * jitter), p.y - jitter))};
    }
    template <class Px> QUELL_KERNEL auto passes(Px const& px, PixelUnder<Px> const& there) const {
        using Real = typename Px::Real;
        auto const centre = px.position();
        auto const path = Trajectories::there(px, there.place);
        auto const passing = path.passing({centre.x - there.column - 0.5f, centre.y - there.row - 0.5f});
        return both(path.moves(), passing.in_time(), passing.distance < Real(threshold));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
