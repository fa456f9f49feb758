#pragma once

#include <quell/frame/cursor/pixel.hpp>

/// Sums over the square around each pixel, by a pass along rows and one along columns. No sum is a difference of larger ones, so that what
/// is dark beside something bright stays exact.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The sum of a channel over pixels of a row around a pixel, as far as they lie in the image: 2 radius + 1 of them.
template <class Px, ChannelTag C> QUELL_KERNEL auto sum_along_row(Px const& px, C channel, int radius) {
    using Real = typename Px::Real;
    auto sum = zero<Value<C::components, Real>>();
    if constexpr (!records<Real>)
        if (px.x >= radius && px.x + Px::pack_width + radius <= px.size().width) { // most packs need no test of each tap
            for (int i = -radius; i <= radius; ++i)
                sum = map([](Real a, Real b) QUELL_INLINED { return a + b; }, sum, px.at(i, 0)[channel]);
            return sum;
        }
    for (int i = -radius; i <= radius; ++i) {
        auto const tap = px.at(i, 0);
        sum = add_scaled(sum, tap[channel], masked(tap.inside(), Real(1.f)));
    }
    return sum;
}
/// The same along its column.
template <class Px, ChannelTag C> QUELL_KERNEL auto sum_along_column(Px const& px, C channel, int radius) {
    using Real = typename Px::Real;
    auto sum = zero<Value<C::components, Real>>();
    for (int i = -radius; i <= radius; ++i) {
        auto const tap = px.at(0, i);
        if constexpr (records<Real>)
            sum = add_scaled(sum, tap[channel], masked(tap.row_inside, Real(1.f)));
        else if (tap.row_inside)
            sum = map([](Real a, Real b) QUELL_INLINED { return a + b; }, sum, tap[channel]);
    }
    return sum;
}
/// How many pixels the square around a pixel has in the image.
template <class Px> QUELL_KERNEL auto pixels_in_window(Px const& px, int radius) {
    using Real = typename Px::Real;
    auto const along = [&](Real const& at, Real const& length) QUELL_INLINED {
        auto const reach = static_cast<float>(radius);
        return min(at + reach, length - 1.f) - max(at - reach, Real(0.f)) + 1.f;
    };
    return along(px.columns(), Real(to_real(px.size().width))) * along(px.row_of_lanes(), Real(to_real(px.size().height)));
}

/// Makes a channel of the sums of another one along rows.
template <ChannelTag From, ChannelTag To> struct SumRows {
    static constexpr auto name = "sum rows";
    using reads = Channels<From>;
    using emits = Channels<To>;
    int radius;

    constexpr int farthest_tap() const { return radius; }

    QUELL_KERNEL auto emit_channels(auto px) const { return emitted<typename decltype(px)::Real>(To{}, sum_along_row(px, From{}, radius)); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
