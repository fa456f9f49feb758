#pragma once

#include <quell/link/evidence/evidence.hpp>
#include <quell/link/residual/shared_noise.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The first of two estimates of a picture, such as one with its history. Of four components the last is alpha.
template <int n> struct FirstEstimate : Channel<n> {
    static constexpr auto name = "first_estimate"; ///< of the channel
};
/// The second one, such as one without.
template <int n> struct SecondEstimate : Channel<n> {
    static constexpr auto name = "second_estimate"; ///< of the channel
};
/// What judges the first estimate: it, or another one that is like it, made without the samples of pixels whose x + y is even.
template <int n> struct FirstWithoutEven : Channel<n> {
    static constexpr auto name = "first_without_even"; ///< of the channel
};
/// The same without those whose x + y is odd.
template <int n> struct FirstWithoutOdd : Channel<n> {
    static constexpr auto name = "first_without_odd"; ///< of the channel
};
/// What judges the second one, without the samples of pixels whose x + y is even.
template <int n> struct SecondWithoutEven : Channel<n> {
    static constexpr auto name = "second_without_even"; ///< of the channel
};
/// The same without those whose x + y is odd.
template <int n> struct SecondWithoutOdd : Channel<n> {
    static constexpr auto name = "second_without_odd"; ///< of the channel
};
/// The same with all samples: the second estimate, where that judges itself.
template <int n> struct SecondJudged : Channel<n> {
    static constexpr auto name = "second_judged"; ///< of the channel
};

namespace detail {

/// What a held-out sample says: the product of I - B and A - B, the square of A - B, the variance of the product, and what caution has
/// added to the first two.
struct EvidenceTerms : ExactChannel<4> {
    static constexpr auto name = "evidence_terms";
};
struct EvidenceTermsOfRows : ExactChannel<4> {
    static constexpr auto name = "evidence_terms_of_rows";
};
/// Samples less the first estimate; 0 where there is no sample.
struct SamplesLessEstimate : ExactChannel<3> {
    static constexpr auto name = "samples_less_estimate";
};

inline constexpr int evidence_radius = 12; ///< of the windows, in pixels

/// A pixel as a colour: one component stands for three that are the same, and alpha is left out.
template <class V> QUELL_KERNEL vec3<real_of<V>> as_colour(V const& v) {
    constexpr int last = components_of < V >> 1 ? 1 : 0;
    return {component<0>(v), component<last>(v), component<2 * last>(v)};
}

/// Looks at the samples.
template <ChannelTag Samples> struct LookAtSamples {
    static constexpr auto name = "evidence";
    static constexpr int n = Samples::components;
    using reads =
        union_of<Channels<Samples, FirstWithoutEven<n>, FirstWithoutOdd<n>, SecondWithoutEven<n>, SecondWithoutOdd<n>, SecondJudged<n>>,
                 FrameBrightness::whole>;
    using emits = Channels<EvidenceTerms, SamplesLessEstimate>;
    static constexpr int farthest_tap = 0;
    Evidence rule;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const given = px[Samples{}];
        auto const is_sample = is_light(given);
        auto const sample = as_colour(given);
        vec3<Real> const less = sample - as_colour(px.signal());
        return emitted<Real>(EvidenceTerms{}, terms(px, is_sample, sample))
            .with(SamplesLessEstimate{}, map([&](Real each) QUELL_INLINED { return masked(is_sample, each); }, less));
    }

private:
    template <class Px, class Mask, class Real>
    QUELL_KERNEL Value<4, Real> terms(Px const& px, Mask const& is_sample, vec3<Real> const& sample) const {
        auto const is_odd = checkerboard_half(px) > Real(.5f);
        auto const a = select(is_odd, as_colour(px[FirstWithoutOdd<n>{}]), as_colour(px[FirstWithoutEven<n>{}]));
        auto const b = select(is_odd, as_colour(px[SecondWithoutOdd<n>{}]), as_colour(px[SecondWithoutEven<n>{}]));
        auto const b_with = as_colour(px[SecondJudged<n>{}]);
        auto const unit = frame_brightness(px), bright = fma(unit, Real(rule.dark + 1e-6f), .5f * abs(luminance(a) + luminance(b)));
        auto const per = 1.f / bright;
        Real product(0.f), square(0.f), noise(0.f), cautious(0.f);
        map(
            [&](Real s, Real first, Real second, Real with) QUELL_INLINED {
                auto const its = min(s, bright * rule.most), off = (first - second) * per, own = (with - second) * per;
                auto const of_own = own * own * rule.caution;
                product = product + fma((its - second) * per, off, of_own), square = square + fma(off, off, of_own);
                noise = fma((its - .5f * (first + second)) * per, off, noise), cautious = cautious + of_own;
                return s;
            },
            sample, a, b, b_with);
        noise = noise * noise;
        auto const is_held_out = checkerboard_half(px) < Real(rule.both_halves ? 2.f : .5f);
        auto const counts = both(both(is_sample, is_held_out), both(is_finite(product), is_finite(square)), is_finite(noise));
        return {masked(counts, product), masked(counts, square), masked(counts, noise), masked(counts, cautious)};
    }
};

/// Puts both estimates together. Alpha is that of the first.
template <int n, bool reports> struct MixByEvidence {
    static constexpr auto name = "mix by evidence";
    using reads = union_of<Channels<SecondEstimate<n>, EvidenceTermsOfRows>, typename FindSharedNoise<SamplesLessEstimate>::whole>;
    using keeps = std::conditional_t<reports, Channels<NoiseIndependence>, Channels<>>;
    static constexpr int farthest_tap = evidence_radius;
    Evidence rule;

    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const sums = sum_along_column(px, EvidenceTermsOfRows{}, evidence_radius);
        auto const less = rule.doubt * (1.f - part(sums, Real(1.f)));
        auto const trust = independence(px);
        auto const of_second = trust * (1.f - part(sums, less));
        auto const first = px.signal();
        auto const second = px[SecondEstimate<n>{}];
        auto const mixed = make_value<n, Real>([&](auto c) QUELL_INLINED {
            auto const a = component<c>(first), b = component<c>(second);
            return c < 3 ? select(is_finite(b), fma(b - a, of_second, a), a) : a;
        });
        if constexpr (reports)
            return Result{mixed}.with(NoiseIndependence{}, trust);
        else
            return mixed;
    }

private:
    /// The part of the first that sums over a window speak for, with caution or without some of it.
    template <class V, class Real> QUELL_KERNEL Real part(V const& sums, Real of_caution) const {
        auto const before = fma(sums.z, Real(1.f / (rule.spread * rule.spread)), Real(1e-30f)), own = of_caution * sums.w;
        auto const product = sums.x - own, square = sums.y - own;
        return clamp(fma(product, square, before * rule.at_first) / fma(square, square, before), Real(0.f), Real(1.f));
    }
};

} // namespace detail

/// Puts two estimates of a picture together, as samples that neither has used speak for (Evidence):
///
///     constexpr auto choose = Pipeline{FirstEstimate<3>{}, Spatial{ChooseByEvidence<Radiance>{Evidence::of_samples(4.f)}}};
///     Frame frame{size, choose};      // the samples, both estimates, and three that judge them
///
/// presets::by_evidence() makes them of a pipeline with its history and without.
/// @tparam Samples the channel of one, three or four components that the estimates are made of, linear
/// @tparam reports whether the history keeps noise_independence
template <ChannelTag Samples = Radiance, bool reports = false> struct ChooseByEvidence {
    Evidence rule{};             ///< how
    SharedNoise of_neighbours{}; ///< where neighbours share their noise, samples are held out of nothing, and the first stays
    /// @cond
    using Differences = detail::SamplesLessEstimate;
    using Rows = detail::SumRows<detail::EvidenceTerms, detail::EvidenceTermsOfRows>;
    using Mix = detail::MixByEvidence<Samples::components, reports>;
    using parts = Parts<detail::FrameBrightness, detail::LookAtSamples<Samples>, detail::FindSharedNoise<Differences>, Rows, Mix>;
    /// @endcond

    /// Its passes.
    constexpr void for_each_pass(auto&& pass) const {
        detail::FrameBrightness{}.for_each_pass(pass);
        pass(detail::LookAtSamples<Samples>{rule});
        detail::FindSharedNoise<Differences>{of_neighbours}.for_each_pass(pass);
        pass(Rows{detail::evidence_radius}), pass(Mix{rule});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
