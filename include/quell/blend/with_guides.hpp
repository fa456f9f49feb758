#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/frame/repair.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Also keeps mean albedo and mean normal, updated with the inner policy's alpha. For a denoiser behind quell that is guided by them, such
/// as a network: `history[mean_albedo]`, `history[mean_normal]` of the frame that was run last. Guides of one ray per pixel are ragged at
/// edges; their means show how much of a pixel each surface covers, as far as rays hit different places of it. A missing sample has guides
/// all the same: where there is no history, they are those of the frame. A normal that is not of length 1, which a host may leave where
/// nothing is seen, counts as none: 0.
///
///     Temporal{SurfaceMotion{}, WithGuides{RunningMean{}}}
///
/// @tparam Inner a BlendPolicy
template <class Inner> struct WithGuides {
    static_assert(BlendPolicy<Inner>, "WithGuides{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<Albedo, Normal>;
    using keeps = Channels<MeanAlbedo, MeanNormal>;
    static constexpr int farthest_tap = 0;
    Inner inner{};    ///< blends, and says alpha
    float cap = 24.f; ///< in frames, at least 1: guides are the mean of no more. Fewer: textures stay sharper, and what turns lags less

    /// The inner result, with mean_albedo and mean_normal.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const alpha = max(result.alpha, Real(1.f / cap));
        return result.with(mean_albedo, joined(past[mean_albedo], px[albedo], alpha))
            .with(mean_normal, joined(past[mean_normal], normal_of(px), alpha));
    }

private:
    /// Guides are repaired where something is seen only.
    template <class Px> QUELL_KERNEL static auto normal_of(Px const& px) {
        auto const n = px[normal];
        using V = std::remove_const_t<decltype(n)>;
        return select(detail::Repair<Normal>::possible(n), n, zero<V>());
    }
    /// The guide itself for an alpha of 1: mix() would round.
    template <class V, class Real> QUELL_KERNEL static V joined(V const& then, V const& now, Real alpha) {
        return select(alpha >= Real(1.f), now, mix(then, now, alpha));
    }
};
template <class Inner> WithGuides(Inner) -> WithGuides<Inner>;
template <class Inner> WithGuides(Inner, float) -> WithGuides<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
