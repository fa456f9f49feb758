#pragma once

#include <quell/blur/pixel_under.hpp>
#include <quell/blur/trajectory/path.hpp>
#include <quell/filter/filter_kernel.hpp>

namespace quell {

/// Motion blur of a sharp picture: every pixel becomes the mean of what lies along its own sweep, half of it to either side (GPU Gems 3,
/// ch. 27). A baseline: what moves doesn't spread beyond its outline, since the pixels out there stand still themselves.
/// Wants a signal as it is in the middle of the open shutter, and reads Sweep. Where nothing moves, the signal keeps every bit.
struct GatherBlur {
    static constexpr auto name = "gather blur";
    using reads = Channels<Sweep>;
    int samples = 15; ///< along the sweep; at least 1

    template <class Px> QUELL_KERNEL typename Px::Signal filter(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = px.signal();
        auto const path = Path<Real>::of(px[sweep], Real(0.5f));
        auto const moves = path.moves();
        if (!any(moves)) return own;
        auto const p = px.position();
        auto sum = zero<typename Px::Signal>();
        Real weights(0.f);
        for (int i = 0; i < samples; ++i) {
            // From the middle of the shutter to that of the i-th of as many equal parts.
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

} // namespace quell
