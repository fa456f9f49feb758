#pragma once

#include <quell/core/value.hpp>
#include <quell/image/extent.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The meaning of a host's motion vectors. The default is quell's own convention: previous = current + motion, in pixels, y down, without
/// jitter.
struct MotionConvention {
    /// The unit of both components.
    enum class Unit {
        pixel, ///< pixels
        uv,    ///< the image is 1 wide and 1 high
        ndc    ///< the image is 2 wide and 2 high
    };
    /// The direction in time.
    enum class Points {
        to_previous,  ///< previous = current + motion
        from_previous ///< current = previous + motion
    };
    /// The direction of y.
    enum class Y {
        down, ///< row 0 is the top
        up    ///< y grows upwards
    };
    /// Whether the vectors contain the change of the camera's jitter.
    enum class Jitter {
        left_out, ///< vectors between unjittered positions
        left_in   ///< vectors between jittered positions
    };

    Points points = Points::to_previous; ///< direction in time
    Unit unit = Unit::pixel;             ///< unit of both components
    Y y = Y::down;                       ///< direction of y
    Jitter jitter = Jitter::left_out;    ///< whether jitter is contained

    /// Equal in all four.
    friend constexpr bool operator==(MotionConvention, MotionConvention) = default;
};

/// A part of a pipeline or preset for hosts whose Motion channel follows another convention. It stands before the stages.
///
///     presets::svgf(radiance, Demodulate{}, Supplied<MotionConvention{.unit = MotionConvention::Unit::uv}>{})
///
/// Vectors are converted on load, so policies see quell's convention only.
/// @tparam convention the host's
template <MotionConvention convention> struct Supplied {};

namespace detail {
template <class T> inline constexpr bool is_supplied = false;
template <MotionConvention convention> inline constexpr bool is_supplied<Supplied<convention>> = true;

/// The factors that convert a vector of this convention to quell's, apart from jitter.
QUELL_KERNEL glm::vec2 to_pixels(MotionConvention convention, Extent size) {
    using C = MotionConvention;
    float const sign = convention.points == C::Points::to_previous ? 1.f : -1.f;
    float const flip = convention.y == C::Y::down ? 1.f : -1.f;
    float const part = convention.unit == C::Unit::ndc ? 0.5f : 1.f;
    float const width = convention.unit == C::Unit::pixel ? 1.f : part * static_cast<float>(size.width);
    float const height = convention.unit == C::Unit::pixel ? 1.f : part * static_cast<float>(size.height);
    return {sign * width, sign * flip * height};
}

/// Converts the vectors of one frame to quell's convention.
template <MotionConvention convention> struct VectorConversion {
    glm::vec2 scale{1.f}, offset{0.f};

    VectorConversion() = default;
    /// A sample offset by +jitter shifts the image by -jitter. A vector between jittered images is therefore off by the change of jitter.
    VectorConversion(Extent size, glm::vec2 jitter_now, glm::vec2 jitter_then) : scale(to_pixels(convention, size)) {
        if (convention.jitter == MotionConvention::Jitter::left_in) offset = jitter_then - jitter_now;
    }
    template <class Real> QUELL_KERNEL vec2<Real> operator()(vec2<Real> const& m) const {
        return {fma(m.x, Real(scale.x), Real(offset.x)), fma(m.y, Real(scale.y), Real(offset.y))};
    }
};
/// quell's own convention needs no conversion.
template <> struct VectorConversion<MotionConvention{}> {
    VectorConversion() = default;
    VectorConversion(Extent, glm::vec2, glm::vec2) {}
    template <class Real> QUELL_KERNEL vec2<Real> operator()(vec2<Real> const& m) const { return m; }
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
