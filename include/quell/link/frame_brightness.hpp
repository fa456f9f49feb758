#pragma once

#include <quell/link/blocks.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Over blocks of the frame: the sum of the picture's luminance, whatever its sign, and of pixels.
template <int its_fraction> struct BrightnessSums : ExactChannel<2> {
    static constexpr auto name = "brightness_sums";
    static constexpr int fraction = its_fraction;
};

struct SumBrightness {
    static constexpr auto name = "brightness";
    static constexpr int fraction = blocks_side;
    using emits = Channels<BrightnessSums<fraction>>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real sum(0.f), pixels(0.f);
        for_each_finer(px, [&](int i, int j, Real weight)
                               QUELL_INLINED { sum = fma(abs(luminance(px.finer_signal(i, j))), weight, sum), pixels = pixels + weight; });
        return emitted<Real>(BrightnessSums<fraction>{}, vec2<Real>{sum, pixels});
    }
};

/// Passes that make the mean brightness of the picture. Those behind it count light in that unit, so that their numbers go with the
/// picture, in whatever unit its light is.
struct FrameBrightness {
    using parts = Parts<SumBrightness, SumFrame<BrightnessSums>>;
    using whole = Channels<BrightnessSums<whole_frame>>; ///< what those that count by it read
    constexpr void for_each_pass(auto&& pass) const {
        pass(SumBrightness{});
        SumFrame<BrightnessSums>{}.for_each_pass(pass);
    }
};

/// The mean brightness of the frame; 1 for a black picture.
template <class Px> QUELL_KERNEL auto frame_brightness(Px const& px) {
    using Real = typename Px::Real;
    auto const sums = px.coarser(BrightnessSums<whole_frame>{});
    auto const mean = sums.x / max(sums.y, Real(1.f));
    return select(mean > Real(1e-30f), mean, Real(1.f));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
