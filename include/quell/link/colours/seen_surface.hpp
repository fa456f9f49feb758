#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A surface of a pixel: what of it is seen in the 3x3 around, and the samples of its colour.
template <class Real> struct SeenSurface {
    Real nearest = Real(1e38f), farthest = Real(0.f); ///< distances of its samples
    Real least = Real(1e38f), most = Real(-1e38f);    ///< of its colours, as mark_of() says
    vec2<Real> motion = zero<vec2<Real>>(), motion_next = zero<vec2<Real>>();
    vec3<Real> colours = zero<vec3<Real>>(), lights = zero<vec3<Real>>();
    Real weights = Real(0.f), lit = Real(0.f); ///< of the colours, of the lights
    Real behind = Real(1e38f);                 ///< distance from which on a sample is of the other surface

    /// A number that differs where colours do, but for a few. Not the luminance, which textures may have in common on purpose. It is
    /// finite where all components are.
    QUELL_KERNEL static Real mark_of(vec3<Real> const& c) { return fma(c.x, Real(0.43f), fma(c.y, Real(0.71f), c.z * 0.29f)); }

    /// @param inside whether there is a pixel of the surface
    QUELL_KERNEL void add_own(auto inside, Real distance, vec3<Real> const& colour, Real weight) {
        nearest = select(inside, min(nearest, distance), nearest), farthest = select(inside, max(farthest, distance), farthest);
        auto const mark = mark_of(colour);
        auto const known = both(inside, is_finite(mark));
        least = select(known, min(least, mark), least), most = select(known, max(most, mark), most);
        auto const w = masked(known, weight);
        colours = add_scaled(colours, select(known, colour, zero<vec3<Real>>()), w);
        weights = weights + w;
    }
    QUELL_KERNEL void add_light(auto inside, vec3<Real> const& light, Real weight) {
        auto const w = masked(inside, weight);
        lights = add_scaled(lights, select(inside, light, zero<vec3<Real>>()), w);
        lit = lit + w;
    }
    [[nodiscard]] QUELL_KERNEL auto is_seen() const { return least <= most; }
    /// Whether its colours differ by more than can be seen.
    [[nodiscard]] QUELL_KERNEL auto varies() const { return most - least > abs(most) * (1.f / 256.f); }
    QUELL_KERNEL void drop_own() { colours = zero<vec3<Real>>(), weights = Real(0.f); }
    /// Adds the colours that another one has seen.
    QUELL_KERNEL void add_sums(SeenSurface const& other) {
        colours = add_scaled(colours, other.colours, Real(1.f)), weights = weights + other.weights;
    }
    [[nodiscard]] QUELL_KERNEL vec3<Real> colour() const { return scale(colours, 1.f / max(weights, Real(1e-20f))); }
    [[nodiscard]] QUELL_KERNEL vec3<Real> light() const { return scale(lights, 1.f / max(lit, Real(1e-20f))); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
