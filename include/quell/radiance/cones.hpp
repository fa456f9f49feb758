#pragma once

#include <quell/frame/modulation.hpp>
#include <quell/motion/tangent_plane.hpp>

namespace quell {

/// Radiance that arrives in six cones of the hemisphere around the normal (TRMV section 4.3). Component 4 k + c is the sum of cone k's
/// samples of colour c, component 4 k + 3 how many there were: whatever mixes pixels linearly mixes these rightly, and a cone's radiance is
/// a quotient at the end. Cone 0 lies along the normal, the others at 60 degrees from it, 72 degrees apart, in the frame of the world.
struct ConeRadiance : MadeChannel<24> {
    static constexpr auto name = "cone_radiance";
};
inline constexpr ConeRadiance cone_radiance;

namespace cone {

inline constexpr int count = 6;
/// Half the apex angle of a cone of solid angle pi / 3 is acos(5 / 6).
inline constexpr float cosine = 5.f / 6.f;
/// What part of a cosine-weighted hemisphere lies nearest to the axis along the normal: (5 / 2 pi) atan(tan(36 deg) / 2), and to each
/// other.
inline constexpr float middle_part = 0.27728066f, ring_part = (1.f - middle_part) / 5.f;

constexpr float part(int k) { return k == 0 ? middle_part : ring_part; }

/// The axes in the world, for a normal. Built without branches from the normal alone (Duff et al. 2017), so that equal normals have equal
/// cones.
template <class Real> struct Axes {
    vec3<Real> at[count];

    QUELL_KERNEL explicit Axes(vec3<Real> const& n) {
        auto const sign = select(n.z < Real(0.f), Real(-1.f), Real(1.f));
        auto const a = Real(-1.f) / (sign + n.z), b = n.x * n.y * a;
        vec3<Real> const tangent{fma(sign * n.x * n.x, a, Real(1.f)), sign * b, -(sign * n.x)};
        vec3<Real> const bitangent{b, fma(n.y * n.y, a, sign), -n.y};
        // Half of cosines and sines of 72 degrees times k, times the square root of 3.
        constexpr float x[] = {0.8660254f, 0.26761657f, -0.70062927f, -0.70062927f, 0.26761657f};
        constexpr float y[] = {0.f, 0.82363910f, 0.50903696f, -0.50903696f, -0.82363910f};
        at[0] = n;
        for (int k = 0; k < 5; ++k) at[k + 1] = add_scaled(add_scaled(scale(n, Real(0.5f)), tangent, Real(x[k])), bitangent, Real(y[k]));
    }
};

/// How much two cones overlap, as a part of one, by the cosine between their axes: a polynomial whose error is below 0.0006
/// (TRMV eqs. 9 and 10, Mazonka 2012, with half angles acos(5/6)).
template <class Real> QUELL_KERNEL Real overlap(Real cosine_between) {
    // 1 where the cones no longer touch.
    auto const u = sqrt(clamp((1.f - cosine_between) * (18.f / 11.f), Real(0.f), Real(1.f)));
    auto p = fma(u, Real(2.2148125f), Real(-5.7880353f));
    p = fma(u, p, Real(5.8774447f));
    p = fma(u, p, Real(-2.6784889f));
    p = fma(u, p, Real(0.58591863f));
    p = fma(u, p, Real(-1.2128017f));
    p = fma(u, p, Real(1.0005748f));
    return masked(u < Real(1.f), clamp(p, Real(0.f), Real(1.f)));
}

/// The same radiance as another normal's cones see it: each takes what it overlaps with (36 pairs). A call of its own, since few pixels
/// need it and it is large.
template <class Real>
[[gnu::noinline]] constexpr Components<24, Real> transferred(Components<24, Real> const& from, vec3<Real> const& normal_from,
                                                             vec3<Real> const& normal_to) {
    Axes<Real> const source(normal_from), target(normal_to);
    Components<24, Real> result{};
    for (int j = 0; j < count; ++j) {
        Real sum[4] = {Real(0.f), Real(0.f), Real(0.f), Real(0.f)};
        for (int k = 0; k < count; ++k) {
            auto const common = overlap(dot(source.at[k], target.at[j]));
            for (int c = 0; c < 4; ++c) sum[c] = fma(from.at[4 * k + c], common, sum[c]);
        }
        for (int c = 0; c < 4; ++c) result.at[4 * j + c] = sum[c];
    }
    return result;
}

/// Whether two pixels have nearly the same cones (6 degrees are little beside the cones' 67), so that radiance passes from cone to cone as
/// it is.
template <class Real> QUELL_KERNEL auto same_axes(vec3<Real> const& a, vec3<Real> const& b) { return dot(a, b) > Real(0.995f); }

/// One sample from a direction: it falls into the nearest cone.
template <class Real>
QUELL_KERNEL Components<24, Real> deposit(vec3<Real> const& radiance, vec3<Real> const& direction, vec3<Real> const& normal) {
    Axes<Real> const axes(normal);
    Real best(-2.f), nearest(0.f);
    for (int k = 0; k < count; ++k) {
        auto const closeness = dot(direction, axes.at[k]);
        auto const nearer = closeness > best;
        best = select(nearer, closeness, best);
        nearest = select(nearer, Real(static_cast<float>(k)), nearest);
    }
    return make_value<24, Real>([&](auto i) QUELL_INLINED {
        auto const here = nearest == Real(static_cast<float>(i / 4));
        if constexpr (i % 4 == 3)
            return masked(here, Real(1.f));
        else
            return masked(here, component<i % 4>(radiance));
    });
}

/// How many samples there are in all cones together.
template <class Real> QUELL_KERNEL Real samples(Components<24, Real> const& value) {
    Real sum(0.f);
    for (int k = 0; k < count; ++k) sum = sum + value.at[4 * k + 3];
    return sum;
}

/// The mean of the radiance weighted by the cosine: what a white diffuse surface gives back (TRMV eq. 11, with cosine integrals for
/// weights, so that constant light is itself). A cone that has hardly a sample borrows from all of them together.
template <class Real> QUELL_KERNEL vec3<Real> shade(Components<24, Real> const& value) {
    vec3<Real> all{Real(0.f), Real(0.f), Real(0.f)};
    for (int k = 0; k < count; ++k) all = vec3<Real>{all.x + value.at[4 * k], all.y + value.at[4 * k + 1], all.z + value.at[4 * k + 2]};
    auto const there_are = samples(value);
    auto const mean = scale(all, 1.f / max(there_are, Real(1e-12f)));
    // A thousandth of the samples that there are: too little to weigh beside real ones.
    auto const lent = max(there_are * 1e-3f, Real(1e-12f));
    vec3<Real> sum{Real(0.f), Real(0.f), Real(0.f)};
    for (int k = 0; k < count; ++k) {
        auto const inverse = part(k) / (value.at[4 * k + 3] + lent);
        sum =
            vec3<Real>{fma(fma(mean.x, lent, value.at[4 * k]), inverse, sum.x), fma(fma(mean.y, lent, value.at[4 * k + 1]), inverse, sum.y),
                       fma(fma(mean.z, lent, value.at[4 * k + 2]), inverse, sum.z)};
    }
    return sum;
}

} // namespace cone

/// Denoises incident radiance in six cones instead of its shaded colour, so that pixels whose normals differ can share it: a modulation for
/// a signal that is one cosine-distributed sample of incident radiance, such as Indirect.
///     Pipeline{indirect, Cones{}, Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{}, ConeFetch{}}, Spatial{ConeAtrous{}}}
/// What comes out is the mean incident radiance weighted by the cosine; times the albedo, it is reflected radiance.
struct Cones {
    using reads = Channels<Normal, IndirectDirection>;
    template <ChannelTag S> using Signal = ConeRadiance;

    QUELL_KERNEL auto inward(auto const& px, auto const& sample) const { return cone::deposit(sample, px[indirect_direction], px[normal]); }
    QUELL_KERNEL auto outward(auto const&, auto const& value) const { return cone::shade(value); }
};

static_assert(Modulation<Cones>);

} // namespace quell
