#pragma once

#include <quell/link/residual/residual_levels.hpp>

/// The finest band of a residual: what its finest level has, and the next one has not.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The finest level of the residual: of a pixel's samples, and of the checkerboard's other half.
struct FinestLevel : ExactChannel<3> {
    static constexpr auto name = "finest_level";
};
struct FinestLevelOfOthers : ExactChannel<3> {
    static constexpr auto name = "finest_level_of_others";
};
struct FinestBand : ExactChannel<3> {
    static constexpr auto name = "finest_band";
};
struct FinestBandOfOthers : ExactChannel<3> {
    static constexpr auto name = "finest_band_of_others";
};
/// What the share of a band, or of all, is found by: the product of the residual and what others say, the square of what is given, and
/// that of the product. All by the residual's mean square.
struct BandProducts : ExactChannel<3> {
    static constexpr auto name = "band_products";
};
struct BandProductsOfRows : ExactChannel<3> {
    static constexpr auto name = "band_products_of_rows";
};

inline constexpr int band_radius = 6; ///< of the windows that its share is found in, in pixels

/// The products that a share is found by.
template <class Px, class Real> QUELL_KERNEL vec3<Real> products(Px const& px, vec3<Real> const& given, vec3<Real> const& of_others) {
    auto const own = px[SampleResidual{}];
    auto const per_square = own.w / max(px[MeanSquare{}], Real(1e-37f));
    auto const product = dot(colour_of(own), of_others) * per_square;
    return {product, dot(given, given) * per_square, product * product};
}

/// Keeps the finest level for the band between it and the next.
struct TakeFinestLevel {
    static constexpr auto name = "finest level";
    using reads = Channels<FirstHalf, SecondHalf>;
    using emits = Channels<FinestLevel, FinestLevelOfOthers>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        return emitted<typename decltype(px)::Real>(FinestLevel{}, smoothed(px)).with(FinestLevelOfOthers{}, smoothed_of_others(px));
    }
};
struct TakeFinestBand {
    static constexpr auto name = "finest band";
    using reads = Channels<FirstHalf, SecondHalf, FinestLevel, FinestLevelOfOthers, SampleResidual, MeanSquare>;
    using emits = Channels<FinestBand, FinestBandOfOthers, BandProducts>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        vec3<Real> const band = px[FinestLevel{}] - smoothed(px), of_others = px[FinestLevelOfOthers{}] - smoothed_of_others(px);
        return emitted<Real>(FinestBand{}, band)
            .with(FinestBandOfOthers{}, of_others)
            .with(BandProducts{}, products(px, of_others, of_others));
    }
};

/// How much of the finest band held-out samples have too, and how surely.
template <class Px> QUELL_KERNEL auto surely_held(Px const& px) {
    using Real = typename Px::Real;
    auto const sums = sum_along_column(px, BandProductsOfRows{}, band_radius);
    auto const deviation = sqrt(fma(sums.z, Real(2.f), Real(1e-20f)));
    return clamp(sums.x / max(sums.y, Real(1e-12f)), Real(0.f), Real(1.f)) * clamp(sums.x / deviation * (1.f / 3.f), Real(0.f), Real(1.f));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
