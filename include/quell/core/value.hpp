#pragma once

#include <quell/core/channel.hpp>
#include <quell/core/real.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Two components: pixel coordinates, velocities.
template <class Real> using vec2 = glm::vec<2, Real>;
/// Three components: positions, directions, colours.
template <class Real> using vec3 = glm::vec<3, Real>;

/// A value of more than four components, which GLM's vectors cannot hold.
template <int N, class Real> struct Components {
    Real at[std::size_t{N}]; ///< component c is at[c]
};

namespace detail {
template <int N, class Real> struct ValueOf { using type = Components<N, Real>; };
template <class Real> struct ValueOf<1, Real> { using type = Real; };
template <int N, class Real>
    requires(N > 1 && N < 5)
struct ValueOf<N, Real> {
    using type = glm::vec<N, Real>;
};

template <class V> struct Shape {
    static constexpr int components = 1;
    using real = V;
};
template <int N, class Real> struct Shape<glm::vec<N, Real>> {
    static constexpr int components = N;
    using real = Real;
};
template <int N, class Real> struct Shape<Components<N, Real>> {
    static constexpr int components = N;
    using real = Real;
};
} // namespace detail

/// The type of a pixel of N components: Real (1), a GLM vector (2 to 4), or Components.
template <int N, class Real> using Value = typename detail::ValueOf<N, Real>::type;

/// The number of components of a value's type.
template <class V> inline constexpr int components_of = detail::Shape<V>::components;
/// The Real of a value's type: float or a pack.
template <class V> using real_of = typename detail::Shape<V>::real;

/// Component `c` of a value. `c` is a template argument, since g++ 12.2 miscompiles loops over GLM's operator[].
template <int c, class V> QUELL_KERNEL auto component(V const& v) {
    constexpr int n = components_of<V>;
    if constexpr (n == 1)
        return v;
    else if constexpr (n > 4)
        return v.at[c];
    else if constexpr (c == 0)
        return v.x;
    else if constexpr (c == 1)
        return v.y;
    else if constexpr (c == 2)
        return v.z;
    else
        return v.w;
}

/// Makes a value with components f(integral_constant<c>).
template <int N, class Real, class F> QUELL_KERNEL Value<N, Real> make_value(F&& f) {
    return [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED { return Value<N, Real>{f(std::integral_constant<int, c>{})...}; }
    (std::make_integer_sequence<int, N>{});
}

/// Applies f to each component of one value, or of several values of the same shape.
template <class F, class V, class... Vs> QUELL_KERNEL auto map(F&& f, V const& v, Vs const&... vs) {
    using Result = decltype(f(component<0>(v), component<0>(vs)...));
    return make_value<components_of<V>, Result>([&](auto c) QUELL_INLINED { return f(component<c>(v), component<c>(vs)...); });
}

/// Folds the components of a value: f(f(f(first, c0), c1), c2)...
template <class F, class V, class R> QUELL_KERNEL R fold(F&& f, R first, V const& v) {
    [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED { ((first = f(first, component<c>(v))), ...); }
    (std::make_integer_sequence<int, components_of<V>>{});
    return first;
}

/// A value with every component `a`.
template <class V> QUELL_KERNEL V splat(real_of<V> a) {
    return make_value<components_of<V>, real_of<V>>([&](auto) QUELL_INLINED { return a; });
}
/// A value with every component 0.
template <class V> QUELL_KERNEL V zero() { return splat<V>(real_of<V>(0.f)); }

/// A host's vector in every lane.
template <class Real> QUELL_KERNEL vec3<Real> broadcast(glm::vec3 const& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }

/// sum + v * weight.
template <class V> QUELL_KERNEL V add_scaled(V const& sum, V const& v, real_of<V> weight) {
    return map([&](auto s, auto a) QUELL_INLINED { return fma(a, weight, s); }, sum, v);
}
/// v * factor.
template <class V> QUELL_KERNEL V scale(V const& v, real_of<V> factor) {
    return map([&](auto a) QUELL_INLINED { return a * factor; }, v);
}
/// a + (b - a) * t.
template <class V> QUELL_KERNEL V mix(V const& a, V const& b, real_of<V> t) {
    return map([&](auto x, auto y) QUELL_INLINED { return fma(y - x, t, x); }, a, b);
}
/// a where the mask is true, else b.
template <class Mask, class V>
    requires(components_of<V> > 1)
QUELL_KERNEL V select(Mask mask, V const& a, V const& b) {
    return map([&](auto x, auto y) QUELL_INLINED { return quell::select(mask, x, y); }, a, b);
}
/// True where every component is finite.
template <class V> QUELL_KERNEL auto all_finite(V const& v) {
    // A test of the sum would be wrong: large finite values overflow.
    return fold([](auto sofar, auto a) QUELL_INLINED { return both(sofar, is_finite(a)); }, is_finite(component<0>(v)), v);
}
/// The dot product.
template <class Real> QUELL_KERNEL Real dot(vec3<Real> const& a, vec3<Real> const& b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

/// luminance(v) + more, in as many operations as luminance(v).
template <class V> QUELL_KERNEL auto luminance_plus(V const& v, real_of<V> more) {
    using Real = real_of<V>;
    if constexpr (components_of<V> == 3 || components_of<V> == 4)
        return fma(component<0>(v), Real(0.2126f), fma(component<1>(v), Real(0.7152f), fma(component<2>(v), Real(0.0722f), more)));
    else
        return fma(fold([](auto sofar, auto a) QUELL_INLINED { return sofar + a; }, Real(0.f), v), Real(1.f / components_of<V>), more);
}

/// Rec. 709 luminance of a colour: three components, or four with alpha, which does not count. For other shapes, the mean of the
/// components.
template <class V> QUELL_KERNEL auto luminance(V const& v) { return luminance_plus(v, real_of<V>(0.f)); }

} // namespace quell::inline QUELL_INSTRUCTION_SET
