#pragma once

#include <quell/core/half.hpp>

#include <concepts>
#include <cstddef>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A Real whose lane i is f(i).
template <class Real, class F> QUELL_KERNEL Real generate(F&& f) {
    if constexpr (width_of<Real> == 1)
        return f(0);
    else
        return [&]<int... i>(std::integer_sequence<int, i...>) QUELL_INLINED { return Real(typename Real::register_type{f(i)...}); }
    (std::make_integer_sequence<int, width_of<Real>>{});
}

/// How one component of a pixel lies in memory. A format reads and writes one Element, a pack of adjacent Elements, or gathers a pack.
/// Models: Float32, Float16.
template <class F>
concept ComponentFormat = requires(typename F::Element* to, typename F::Element const* from) {
    { F::get(from) } -> std::same_as<float>;
    F::set(to, 1.f);
    { F::template load<float>(from) } -> std::same_as<float>;
    F::template store<float>(to, 1.f);
    { F::template gather<float>(from, 0) } -> std::same_as<float>;
    requires std::same_as<typename F::Squares::Element, typename F::Element>;
};

/// Stores components as 32-bit floats.
struct Float32 {
    using Element = float;                ///< what memory holds
    using Squares = Float32;              ///< the format for channels that are `squared`
    static constexpr auto name = "float"; ///< for messages

    QUELL_KERNEL static float get(Element const* p) { return *p; } ///< reads one component
    QUELL_KERNEL static void set(Element* p, float a) { *p = a; }  ///< writes one component

    /// Loads width_of<Real> adjacent components; no alignment is needed.
    template <class Real> QUELL_KERNEL static Real load(Element const* p) {
        if constexpr (width_of<Real> == 1)
            return *p;
        else
            return Real::load_unaligned(p);
    }
    /// Stores width_of<Real> adjacent components; no alignment is needed.
    template <class Real> QUELL_KERNEL static void store(Element* p, Real a) {
        if constexpr (width_of<Real> == 1)
            *p = a;
        else
            a.store_unaligned(p);
    }
    /// Lane i is the component at p[at[i]].
    template <class Real> QUELL_KERNEL static Real gather(Element const* p, Index<Real> at) {
        if constexpr (width_of<Real> == 1)
            return p[at];
        else {
            // xsimd 8 makes a call here, which spills all registers. vgatherdps is slower as well, on AMD's Zen 3.
            alignas(64) std::int32_t lanes[width_of<Real>];
            at.store_aligned(lanes);
            return generate<Real>([&](int i) QUELL_INLINED { return p[lanes[i]]; });
        }
    }
};

struct SquaredFloat16;

/// Stores components as 16-bit floats (IEEE binary16). Kernels compute in 32 bits.
struct Float16 {
    // The same members as Float32.
    /// @cond
    using Element = std::uint16_t;
    using Squares = SquaredFloat16;
    static constexpr auto name = "half";

    QUELL_KERNEL static float get(Element const* p) { return float_from_half(*p); }
    QUELL_KERNEL static void set(Element* p, float a) { *p = half_from_float(a); }

    template <class Real> QUELL_KERNEL static Real load(Element const* p) { return load_half<Real>(p); }
    template <class Real> QUELL_KERNEL static void store(Element* p, Real a) { store_half(p, a); }
    template <class Real> QUELL_KERNEL static Real gather(Element const* p, Index<Real> at) {
        if constexpr (width_of<Real> == 1)
            return float_from_half(p[at]);
        else {
            alignas(64) Element lane_bits[width_of<Real>];
            for (int i = 0; i < width_of<Real>; ++i) lane_bits[i] = p[lane(at, i)];
            return load_half<Real>(lane_bits);
        }
    }
    /// @endcond
};

/// Stores variances by their square roots in 16 bits. A variance stored directly in half would end at a standard deviation of 256.
struct SquaredFloat16 {
    // The same members as Float32.
    /// @cond
    using Element = Float16::Element;
    using Squares = SquaredFloat16;
    static constexpr auto name = "squared half";

    QUELL_KERNEL static float get(Element const* p) { return square(Float16::get(p)); }
    QUELL_KERNEL static void set(Element* p, float a) { Float16::set(p, sqrt(max(a, 0.f))); }

    template <class Real> QUELL_KERNEL static Real load(Element const* p) { return square(Float16::load<Real>(p)); }
    template <class Real> QUELL_KERNEL static void store(Element* p, Real a) { Float16::store(p, sqrt(max(a, Real(0.f)))); }
    template <class Real> QUELL_KERNEL static Real gather(Element const* p, Index<Real> at) { return square(Float16::gather<Real>(p, at)); }

private:
    template <class Real> QUELL_KERNEL static Real square(Real a) { return a * a; }
    /// @endcond
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
