#pragma once

#include <baselines/pixel_under.hpp>
#include <quell/blur/trajectory/trajectory.hpp>
#include <quell/filter/filter_kernel.hpp>

/// @file
/// Contract of post_process/: motion blur of a sharp picture, which shows the middle of the open shutter. They keep no layers and no
/// history.
///
///     GatherBlur     signal, Sweep -> signal
///
///     TileMaxBlur    Sweep
///                      v   LongestSweep along x, then y: log(tile) passes -> DominantSweep
///                      v   TileMaxGather: signal, Sweep, Depth
///                    signal
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Motion blur of a sharp picture: the mean of the pixels along each pixel's own sweep, half of it to either side (GPU Gems 3, ch. 27). A
/// moving surface does not spread beyond its outline, since the pixels there are static themselves. Needs the signal at the middle of the
/// open shutter. Where nothing moves, the signal keeps every bit.
struct GatherBlur {
    static constexpr auto name = "gather blur";
    using reads = Channels<Sweep>;
    int samples = 15; ///< samples along the sweep; at least 1

    template <class Px> QUELL_KERNEL typename Px::Signal filter(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = px.signal();
        auto const path = Trajectory<Real>::of(px[sweep], Real(0.5f));
        auto const moves = path.moves();
        if (!any(moves)) return own;
        auto const p = px.position();
        auto sum = zero<typename Px::Signal>();
        Real weights(0.f);
        for (int i = 0; i < samples; ++i) {
            // From the middle of the shutter to the middle of the i-th stratum.
            Real const part(static_cast<float>(2 * i + 1 - samples) / static_cast<float>(2 * samples));
            PixelUnder<Px> const there(px, {fma(path.sweep.x, part, p.x), fma(path.sweep.y, part, p.y)});
            auto const [value, missing] = px.signal_elsewhere(there.place);
            auto const w = masked(both(there.inside, invert(missing)), Real(1.f));
            sum = add_scaled(sum, value, w);
            weights = weights + w;
        }
        return select(both(moves, weights > Real(0.f)), scale(sum, 1.f / max(weights, Real(1.f))), own);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
