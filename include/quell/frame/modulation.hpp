#pragma once

#include <quell/frame/cursor/probe.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Converts the signal before denoising and back after it. A modulation has
///
///     template <ChannelTag S> using Signal = ...;                    // the channel that is denoised in place of S
///     auto inward(auto px, auto const& sample) const;                // from the host's sample, which is light, to the signal
///     auto outward(auto px, auto const& value) const;                // from the denoised signal to the host's output
///
/// Models: Demodulate, NoModulation.
template <class M>
concept Modulation = std::is_trivially_copyable_v<M> && requires {
    typename M::template Signal<Radiance>;
};

namespace detail {
/// Whether a modulation has both functions.
template <class M>
concept Converts = requires(M const& m, Probe<M> px, vec3<float> sample) {
    m.outward(px, m.inward(px, sample));
};
} // namespace detail

/// Divides the signal's colour by the albedo before denoising and multiplies by the same divisor afterwards, so texture is not filtered.
/// Black surfaces and invalid albedos (a component negative or not finite) have the divisor 1.
struct Demodulate {
    using reads = Channels<Albedo>; ///< of this frame
    static constexpr int farthest_tap = 0;
    template <ChannelTag S> using Signal = S; ///< the same channel
    float min_divisor = 0.02f;                ///< least divisor of a component; a surface with a luminance below it counts as black

    /// sample / divisor; alpha stays as it is.
    QUELL_KERNEL auto inward(auto const& px, auto const& sample) const {
        return of_colour([](auto a, auto d) QUELL_INLINED { return a / d; }, sample, divisor(px));
    }
    /// value * divisor; alpha stays as it is.
    QUELL_KERNEL auto outward(auto const& px, auto const& value) const {
        return of_colour([](auto a, auto d) QUELL_INLINED { return a * d; }, value, divisor(px));
    }

private:
    template <class V, class D> QUELL_KERNEL static V of_colour(auto&& f, V const& value, D const& by) {
        return make_value<components_of<V>, real_of<V>>([&](auto c) QUELL_INLINED {
            if constexpr (c < components_of<D>)
                return f(component<c>(value), component<c>(by));
            else
                return component<c>(value);
        });
    }
    QUELL_KERNEL auto divisor(auto const& px) const {
        using Real = typename std::remove_cvref_t<decltype(px)>::Real;
        auto const a = px[albedo];
        auto const colour =
            map([&](auto c) QUELL_INLINED { return select(is_finite(c), clamp(c, Real(min_divisor), Real(1e4f)), Real(1.f)); }, a);
        // A negative component is invalid too: clamped to the least divisor, it would turn the sample into bright light.
        auto const albedo_like =
            fold([](auto sofar, auto c) QUELL_INLINED { return both(sofar, is_finite(c), c >= Real(0.f)); }, Real(0.f) == Real(0.f), a);
        auto const black = either(invert(albedo_like), luminance(a) < Real(min_divisor));
        return select(black, splat<decltype(a + a)>(Real(1.f)), colour);
    }
};

/// A part of a pipeline for hosts that supply SampleCount and SampleVariance. RunningMean then weighs each frame by its number of samples,
/// and WithMoments and WithVariance use the variance of the samples. Without it every frame counts as one sample per pixel.
struct KnownSamples {
    using reads = Channels<SampleCount, SampleVariance>; ///< of this frame
};

/// Leaves the signal unchanged.
struct NoModulation {
    static constexpr int farthest_tap = 0;
    /// @cond
    template <ChannelTag S> using Signal = S;
    QUELL_KERNEL auto inward(auto const&, auto const& sample) const { return sample; }
    QUELL_KERNEL auto outward(auto const&, auto const& value) const { return value; }
    /// @endcond
};

static_assert(Modulation<Demodulate> && Modulation<NoModulation>);

} // namespace quell::inline QUELL_INSTRUCTION_SET
