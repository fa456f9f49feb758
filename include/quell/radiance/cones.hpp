#pragma once

#include <quell/motion/tangent_plane.hpp>

/// @file
/// Diffuse indirect light as incident radiance in six cones (TRMV section 4.3).
///
/// A shaded colour is only right for the normal that it was shaded with. Radiance in cones can move to a surface with another normal: each
/// of its cones takes from those that it overlaps. So a disoccluded pixel can use the history of a surface that faces another way.
///
///           from the side                      from above
///
///                 n                                     2            cone 0 lies along the normal n;
///                 | 0                             3                  cones 1 to 5 are 60 degrees from n, 72 degrees apart;
///         3 \     |     / 1                           0     1        each has the solid angle pi / 3:
///             \   |   /                           4                  half its apex angle is acos(5 / 6), 34 degrees
///               \ | /                                   5
///     ------------+------------  surface
///
/// They lie beside the signal, in the history only: `Temporal{motion, WithCones{blend}, ConeFetch{}}, Spatial{ConeGather{}},
/// Spatial{filter}`
///
///     pass          reads                                      writes
///     Temporal      sample, indirect_direction, normal;        signal: the mean colour of the samples;
///                   cone_luminance of the last frame           cone_luminance, which the history keeps   (ConeFetch, WithCones)
///     ConeGather    signal, cone_luminance of 3x3 pixels       signal: their mean, as bright as the sum of their cones shades to
///     filter        signal                                     signal: a filtered colour

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Incident luminance in six cones, beside a signal that has the colour. Component 2 k is the sum of cone k's samples, component 2 k + 1
/// their number; the numbers add up to 1. Memory holds, in half, the mean of a cone's samples over that of all in place of their sum: about
/// 1, whatever the signal's unit.
struct ConeLuminance : InternalChannel<12> {
    static constexpr auto name = "cone_luminance";
    static constexpr bool always_half = true; ///< memory holds numbers of about 1

    /// What a history fetch interpolates: the sums, in the units of the signal of the same pixel.
    template <class V> QUELL_KERNEL static V interpolated(V stored, auto const& signal) {
        auto const mean = luminance(signal);
        QUELL_UNROLL_ON_DEVICE
        for (int i = 0; i < components; i += 2) stored.at[i] = stored.at[i] * (stored.at[i + 1] * mean);
        return stored;
    }
    /// What memory holds of what a policy returns. A cone without light or without samples has the mean of all.
    template <class V> QUELL_KERNEL static V in_memory(V cones) {
        auto sum = cones.at[0], number = cones.at[1];
        QUELL_UNROLL_ON_DEVICE
        for (int i = 2; i < components; i += 2) sum = sum + cones.at[i], number = number + cones.at[i + 1];
        using Real = decltype(sum);
        auto const scale_by = masked(sum > Real(1e-30f), number / sum);
        QUELL_UNROLL_ON_DEVICE
        for (int i = 0; i < components; i += 2) {
            // Half ends at 65504.
            auto const relative = min(cones.at[i] * scale_by / max(cones.at[i + 1], Real(1e-6f)), Real(60000.f));
            cones.at[i] = select(both(scale_by > Real(0.f), cones.at[i + 1] > Real(1e-6f)), relative, Real(1.f));
        }
        return cones;
    }
};
inline constexpr ConeLuminance cone_luminance;

/// Geometry of the six cones. Directions are unit vectors in world space.
namespace cone {

inline constexpr int count = 6; ///< cones per pixel
/// Cosine of half the apex angle, for a solid angle of pi / 3.
inline constexpr float cosine = 5.f / 6.f;
// Parts of the cosine-weighted hemisphere that are nearest to each cone.
inline constexpr float middle_part = 0.27728066f, ///< of cone 0: (5 / 2 pi) atan(tan(36 deg) / 2)
    ring_part = (1.f - middle_part) / 5.f;        ///< of each other cone

/// Cone k's part of the cosine-weighted hemisphere; the six parts add up to 1.
constexpr float part(int k) { return k == 0 ? middle_part : ring_part; }

/// The axes of the six cones for a normal. They depend on the normal alone, without branches (Duff et al. 2017): equal normals have equal
/// cones.
template <class Real> struct Axes {
    vec3<Real> at[count]; ///< unit vectors in world space; at[0] is the normal

    /// @param n the normal, of length 1, in world space
    QUELL_KERNEL explicit Axes(vec3<Real> const& n) {
        auto const sign = select(n.z < Real(0.f), Real(-1.f), Real(1.f));
        auto const a = Real(-1.f) / (sign + n.z), b = n.x * n.y * a;
        vec3<Real> const tangent{fma(sign * n.x * n.x, a, Real(1.f)), sign * b, -(sign * n.x)};
        vec3<Real> const bitangent{b, fma(n.y * n.y, a, sign), -n.y};
        // 60 degrees off the normal: sin(60 deg) times cosine and sine of k * 72 degrees.
        constexpr float x[] = {0.8660254f, 0.26761657f, -0.70062927f, -0.70062927f, 0.26761657f};
        constexpr float y[] = {0.f, 0.82363910f, 0.50903696f, -0.50903696f, -0.82363910f};
        at[0] = n;
        QUELL_UNROLL_ON_DEVICE
        for (int k = 0; k < 5; ++k) at[k + 1] = add_scaled(add_scaled(scale(n, Real(0.5f)), tangent, Real(x[k])), bitangent, Real(y[k]));
    }
};

/// Part of a cone's solid angle that another cone overlaps, 0 to 1 (TRMV eqs. 9 and 10, after Mazonka 2012). A polynomial fit with an error
/// below 0.0006.
/// @param cosine_between cosine of the angle between their axes
template <class Real> QUELL_KERNEL Real overlap(Real cosine_between) {
    // u is 1 where the cones no longer touch.
    auto const u = sqrt(clamp((1.f - cosine_between) * (18.f / 11.f), Real(0.f), Real(1.f)));
    auto p = fma(u, Real(2.2148125f), Real(-5.7880353f));
    p = fma(u, p, Real(5.8774447f));
    p = fma(u, p, Real(-2.6784889f));
    p = fma(u, p, Real(0.58591863f));
    p = fma(u, p, Real(-1.2128017f));
    p = fma(u, p, Real(1.0005748f));
    return masked(u < Real(1.f), clamp(p, Real(0.f), Real(1.f)));
}

/// Moves radiance to the cones of another normal: each takes from all that it overlaps (36 pairs). Not inlined: it is large, and few pixels
/// need it.
/// @tparam n components: those of ConeLuminance, or 24 of colours
template <int n, class Real>
QUELL_OUTLINED constexpr Components<n, Real> transferred(Components<n, Real> const& from, vec3<Real> const& normal_from,
                                                         vec3<Real> const& normal_to) {
    constexpr int each = n / count;
    Axes<Real> const source(normal_from), target(normal_to);
    Components<n, Real> result{};
    QUELL_UNROLL_ON_DEVICE
    for (int j = 0; j < count; ++j) {
        Real sum[std::size_t{each}];
        for (int c = 0; c < each; ++c) sum[c] = Real(0.f);
        QUELL_UNROLL_ON_DEVICE
        for (int k = 0; k < count; ++k) {
            auto const common = overlap(dot(source.at[k], target.at[j]));
            for (int c = 0; c < each; ++c) sum[c] = fma(from.at[each * k + c], common, sum[c]);
        }
        for (int c = 0; c < each; ++c) result.at[each * j + c] = sum[c];
    }
    return result;
}

/// Whether two normals differ by less than 6 degrees. Then radiance passes from cone to cone: their apex angles are 67 degrees.
template <class Real> QUELL_KERNEL auto same_axes(vec3<Real> const& a, vec3<Real> const& b) { return dot(a, b) > Real(0.995f); }

/// One sample from `direction`, in the nearest cone.
/// @tparam V a luminance, which makes ConeLuminance, or a colour
template <class V, class Real> QUELL_KERNEL auto deposit(V const& sample, vec3<Real> const& direction, vec3<Real> const& normal) {
    constexpr int each = components_of<V> + 1;
    Axes<Real> const axes(normal);
    Real best(-2.f), nearest(0.f);
    QUELL_UNROLL_ON_DEVICE
    for (int k = 0; k < count; ++k) {
        auto const closeness = dot(direction, axes.at[k]);
        auto const nearer = closeness > best;
        best = select(nearer, closeness, best);
        nearest = select(nearer, Real(static_cast<float>(k)), nearest);
    }
    return make_value<each * count, Real>([&](auto i) QUELL_INLINED {
        auto const here = nearest == Real(static_cast<float>(i / each));
        if constexpr (i % each == each - 1)
            return masked(here, Real(1.f));
        else
            return masked(here, component<i % each>(sample));
    });
}

/// Number of samples in all cones together.
template <int n, class Real> QUELL_KERNEL Real samples(Components<n, Real> const& value) {
    constexpr int each = n / count;
    Real sum(0.f);
    QUELL_UNROLL_ON_DEVICE
    for (int k = 1; k <= count; ++k) sum = sum + value.at[each * k - 1];
    return sum;
}

/// The mean of all samples, whatever their cones: a colour or a luminance. 0 without samples.
template <int n, class Real> QUELL_KERNEL auto mean(Components<n, Real> const& value) {
    constexpr int each = n / count;
    auto const inverse = 1.f / max(samples(value), Real(1e-30f));
    return make_value<each - 1, Real>([&](auto c) QUELL_INLINED {
        Real all(0.f);
        QUELL_UNROLL_ON_DEVICE
        for (int k = 0; k < count; ++k) all = all + value.at[each * k + c];
        return all * inverse;
    });
}

/// Mean incident radiance, or luminance, weighted by the cosine: what a white diffuse surface reflects (TRMV eq. 11). Weights are cosine
/// integrals, so that constant light is preserved. A cone with hardly any samples takes the mean of all.
template <int n, class Real> QUELL_KERNEL auto shade(Components<n, Real> const& value) {
    constexpr int each = n / count;
    auto const of_all = mean(value);
    // Each cone borrows 1/1000 of all samples: little beside samples of its own.
    auto const lent = max(samples(value) * 1e-3f, Real(1e-30f));
    auto sum = zero<Value<each - 1, Real>>();
    QUELL_UNROLL_ON_DEVICE
    for (int k = 0; k < count; ++k) {
        auto const inverse = part(k) / (value.at[each * k + each - 1] + lent);
        sum = make_value<each - 1, Real>(
            [&](auto c) QUELL_INLINED { return fma(fma(component<c>(of_all), lent, value.at[each * k + c]), inverse, component<c>(sum)); });
    }
    return sum;
}

} // namespace cone

} // namespace quell::inline QUELL_INSTRUCTION_SET
