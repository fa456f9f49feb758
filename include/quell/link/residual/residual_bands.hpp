#pragma once

#include <quell/link/residual/lacking.hpp>

#include <array>
#include <cstddef>

/// Residuals of this frame and of those around, and their bands of frequencies, for RepeatedResidual.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The frames whose residuals are compared.
enum class Around { now, before, after };

/// What a frame around lacks, where its surfaces are now, in units of the frame's brightness; and 1 where that is known.
template <Around frame> struct ResidualThere : ExactChannel<4> {
    static constexpr auto name = frame == Around::before ? "residual_before" : "residual_after";
};
/// A residual smoothed by the two Gaussians between the bands: along rows, and in both directions.
template <Around frame> struct BlursOfRows : ExactChannel<6> {
    static constexpr auto name = frame == Around::now      ? "blurs_of_rows"
                                 : frame == Around::before ? "blurs_of_rows_before"
                                                           : "blurs_of_rows_after";
};
template <Around frame> struct Blurs : ExactChannel<6> {
    static constexpr auto name = frame == Around::now ? "blurs" : frame == Around::before ? "blurs_before" : "blurs_after";
};
/// How far a frame around counts, and where its samples are new.
template <Around frame> struct Witness : ExactChannel<2> {
    static constexpr auto name = frame == Around::before ? "witness_before" : "witness_after";
};

/// The residual of a frame, in units of the frame's brightness.
template <Around frame, class Px> QUELL_KERNEL auto residual_of(Px const& px) {
    using Real = typename Px::Real;
    if constexpr (frame == Around::now) {
        vec3<Real> const lacks = px[Lacking{}];
        return scale(lacks, 1.f / frame_brightness(px));
    } else
        return colour_of(px[ResidualThere<frame>{}]);
}
template <Around frame> using ResidualChannel = std::conditional_t<frame == Around::now, Lacking, ResidualThere<frame>>;

/// The weights of a Gaussian's taps, to one side. Farther than three deviations there are none.
struct BandGaussian {
    static constexpr int most = 6;
    std::array<float, most + 1> weights{};
    int radius;

    /// @param deviation in pixels, more than 0, at most 2
    constexpr explicit BandGaussian(float deviation) : radius(most) {
        for (int i = most; i >= 0; --i) {
            weights[static_cast<std::size_t>(i)] = decay(.5f * static_cast<float>(i * i) / (deviation * deviation));
            if (static_cast<float>(i) >= 3.f * deviation) radius = i;
        }
    }
    /// @param off in pixels, in either direction
    [[nodiscard]] constexpr float operator()(int off) const { return weights[static_cast<std::size_t>(off < 0 ? -off : off)]; }
    /// What a pixel has of itself in its mean, along rows and columns.
    [[nodiscard]] constexpr float of_own_pixel() const {
        float whole = 0.f;
        for (int i = -radius; i <= radius; ++i) whole += (*this)(i);
        return weights[0] * weights[0] / (whole * whole);
    }

private:
    /// exp(-a) for 0 to 40. The standard library's exponential is no constant expression.
    static constexpr float decay(float a) {
        double term = 1., sum = 1.;
        for (int i = 1; i < 150; ++i) sum += term *= static_cast<double>(a) / i;
        return static_cast<float>(1. / sum);
    }
};

/// The Gaussians between the bands.
inline constexpr BandGaussian finer_gaussian(.7f), wider_gaussian(2.f);

/// Means by both Gaussians along rows or columns, over what lies in the image.
template <ChannelTag From, ChannelTag To, bool along_rows> struct BlurLine {
    static constexpr auto name = along_rows ? "blur residual, rows" : "blur residual, columns";
    using reads = Channels<From>;
    using emits = Channels<To>;
    static constexpr int farthest_tap = BandGaussian::most;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto finer = zero<vec3<Real>>(), wider = zero<vec3<Real>>();
        Real finer_whole(0.f), wider_whole(0.f);
        for (int i = -wider_gaussian.radius; i <= wider_gaussian.radius; ++i) {
            auto const tap = along_rows ? px.at(i, 0) : px.at(0, i);
            auto const inside = masked(tap.inside(), Real(1.f));
            auto const value = tap[From{}];
            constexpr int second = along_rows ? 0 : 3; // of rows both are there
            auto const w = inside * wider_gaussian(i);
            wider = add_scaled(wider, part<second>(value), w), wider_whole = wider_whole + w;
            if (i < -finer_gaussian.radius || i > finer_gaussian.radius) continue;
            auto const f = inside * finer_gaussian(i);
            finer = add_scaled(finer, part<0>(value), f), finer_whole = finer_whole + f;
        }
        finer = scale(finer, 1.f / finer_whole), wider = scale(wider, 1.f / wider_whole);
        return emitted<Real>(To{}, Components<6, Real>{{finer.x, finer.y, finer.z, wider.x, wider.y, wider.z}});
    }

    /// Three components of a value, from one on.
    template <int first, class V> QUELL_KERNEL static vec3<real_of<V>> part(V const& v) {
        return {component<first>(v), component<first + 1>(v), component<first + 2>(v)};
    }
};
/// Both passes.
template <Around frame> struct BlurResidual {
    using Rows = BlurLine<ResidualChannel<frame>, BlursOfRows<frame>, true>;
    using Columns = BlurLine<BlursOfRows<frame>, Blurs<frame>, false>;
    using parts = Parts<Rows, Columns>;
    constexpr void for_each_pass(auto&& pass) const { pass(Rows{}), pass(Columns{}); }
};

/// The two blurs of a residual, in its own unit.
template <Around frame, class Px> QUELL_KERNEL auto blurs_of(Px const& px) {
    using Real = typename Px::Real;
    auto const value = px[Blurs<frame>{}];
    Real const per_unit = frame == Around::now ? 1.f / frame_brightness(px) : Real(1.f);
    using Line = typename BlurResidual<frame>::Rows;
    struct Both {
        vec3<Real> finer, wider;
    };
    return Both{scale(Line::template part<0>(value), per_unit), scale(Line::template part<3>(value), per_unit)};
}

/// The bands of a residual: what is finer than the first Gaussian, what lies between both, and what is wider.
template <class Real> struct ResidualBands { vec3<Real> of[3]; };
template <Around frame, class Px> QUELL_KERNEL auto bands_of(Px const& px) {
    auto const whole = residual_of<frame>(px);
    auto const [finer, wider] = blurs_of<frame>(px);
    return ResidualBands<typename Px::Real>{{whole - finer, finer - wider, wider}};
}
/// What bands_of() of a frame reads.
template <Around frame> using bands_reads = Channels<ResidualChannel<frame>, Blurs<frame>>;

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
