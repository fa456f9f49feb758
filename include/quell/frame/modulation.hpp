#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell {

/// What a signal's values are while they are denoised. A modulation has
///     template <ChannelTag S> using Signal = ...                     the channel that stands for the signal inside the pipeline
///     auto inward(auto px, auto const& sample) const                 from a sample, which is finite and not negative, to the signal's
///     value auto outward(auto px, auto const& value) const                 from the final value to what the host gets
/// Models: Demodulate, Cones (quell/radiance/cones.hpp), and NoModulation.
template <class M>
concept Modulation = std::is_trivially_copyable_v<M> && requires {
    typename M::template Signal<Radiance>;
};

/// Divides the signal by the albedo before anything else sees it and multiplies the result by the same divisor at the end, so that texture
/// is not filtered. The divisor is never small: a black surface and a miss (whose albedo hosts leave at anything) pass through unchanged.
struct Demodulate {
    using reads = Channels<Albedo>;
    template <ChannelTag S> using Signal = S;
    float least = 0.02f; ///< a component's divisor is at least this; a surface whose luminance is less divides by 1

    QUELL_KERNEL auto inward(auto const& px, auto const& sample) const {
        return map([](auto a, auto d) QUELL_INLINED { return a / d; }, sample, divisor(px));
    }
    QUELL_KERNEL auto outward(auto const& px, auto const& value) const {
        return map([](auto a, auto d) QUELL_INLINED { return a * d; }, value, divisor(px));
    }

private:
    QUELL_KERNEL auto divisor(auto const& px) const {
        using Real = typename std::remove_cvref_t<decltype(px)>::Real;
        auto const a = px[albedo];
        auto const colour =
            map([&](auto c) QUELL_INLINED { return select(is_finite(c), clamp(c, Real(least), Real(1e4f)), Real(1.f)); }, a);
        // A component below 0 is as little an albedo as one that isn't finite: the least divisor would make it bright light.
        auto const albedo_like =
            fold([](auto sofar, auto c) QUELL_INLINED { return both(sofar, is_finite(c), c >= Real(0.f)); }, Real(0.f) == Real(0.f), a);
        auto const black = either(invert(albedo_like), luminance(a) < Real(least));
        return select(black, splat<decltype(a + a)>(Real(1.f)), colour);
    }
};

/// A part of a pipeline for hosts that say, for each pixel, how many samples its value is the mean of, and how much one of them varies:
/// RunningMean then weighs each frame by its samples, and WithMoments and WithVariance know of the variance among them. Without it every
/// frame of every pixel counts as one sample.
struct KnownSamples {
    using reads = Channels<SampleCount, SampleVariance>;
};

/// Leaves the signal as it is.
struct NoModulation {
    template <ChannelTag S> using Signal = S;
    QUELL_KERNEL auto inward(auto const&, auto const& sample) const { return sample; }
    QUELL_KERNEL auto outward(auto const&, auto const& value) const { return value; }
};

static_assert(Modulation<Demodulate> && Modulation<NoModulation>);

} // namespace quell
