#pragma once

#include <quell/core/value.hpp>
#include <quell/image/extent.hpp>

namespace quell {

/// What a host's motion vectors mean. quell's own convention is the default: previous = current + motion, in pixels, y down, no jitter.
struct MotionConvention {
    enum class Unit { pixel, uv, ndc }; ///< uv: 1 is the image's size; ndc: 2 is
    enum class Points { to_previous, from_previous };
    enum class Y { down, up };
    enum class Jitter { left_out, left_in }; ///< left_in: the difference of the two frames' jitter is part of the vector

    Points points = Points::to_previous;
    Unit unit = Unit::pixel;
    Y y = Y::down;
    Jitter jitter = Jitter::left_out;
    friend constexpr bool operator==(MotionConvention, MotionConvention) = default;
};

/// For a host whose Motion channel follows another convention: a part of a pipeline, or of a preset, that goes before the stages.
///     presets::svgf(radiance, Demodulate{}, Supplied<MotionConvention{.unit = MotionConvention::Unit::uv}>{})
/// Vectors are converted where they are loaded; nothing past that knows another convention.
template <MotionConvention convention> struct Supplied {};

namespace detail {
template <class T> inline constexpr bool is_supplied = false;
template <MotionConvention convention> inline constexpr bool is_supplied<Supplied<convention>> = true;

/// What a vector of this convention is multiplied by to become one of quell's.
QUELL_KERNEL glm::vec2 to_pixels(MotionConvention convention, Extent size) {
    using C = MotionConvention;
    float const sign = convention.points == C::Points::to_previous ? 1.f : -1.f;
    float const flip = convention.y == C::Y::down ? 1.f : -1.f;
    float const part = convention.unit == C::Unit::ndc ? 0.5f : 1.f;
    float const width = convention.unit == C::Unit::pixel ? 1.f : part * static_cast<float>(size.width);
    float const height = convention.unit == C::Unit::pixel ? 1.f : part * static_cast<float>(size.height);
    return {sign * width, sign * flip * height};
}

/// Brings the vectors of one frame into quell's convention.
template <MotionConvention convention> struct VectorConversion {
    glm::vec2 scale{1.f}, offset{0.f};

    VectorConversion() = default;
    /// A sample offset by +jitter shows the image shifted by -jitter, so a vector between jittered images is off by the change of jitter.
    VectorConversion(Extent size, glm::vec2 jitter_now, glm::vec2 jitter_then) : scale(to_pixels(convention, size)) {
        if (convention.jitter == MotionConvention::Jitter::left_in) offset = jitter_then - jitter_now;
    }
    template <class Real> QUELL_KERNEL vec2<Real> operator()(vec2<Real> const& m) const {
        return {fma(m.x, Real(scale.x), Real(offset.x)), fma(m.y, Real(scale.y), Real(offset.y))};
    }
};
/// Of quell's own there is nothing to convert.
template <> struct VectorConversion<MotionConvention{}> {
    VectorConversion() = default;
    VectorConversion(Extent, glm::vec2, glm::vec2) {}
    template <class Real> QUELL_KERNEL vec2<Real> operator()(vec2<Real> const& m) const { return m; }
};
} // namespace detail

} // namespace quell
