#pragma once

#include <quell/motion/surface_motion.hpp>

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

namespace detail {
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
} // namespace detail

/// SurfaceMotion for a host whose vectors follow another convention, converted at compile time:
///     Supplied<MotionConvention{.points = MotionConvention::Points::from_previous, .unit = MotionConvention::Unit::uv}>
/// Past this type nothing knows another convention.
template <MotionConvention convention, class Test = AllOf<SameDepth, SameNormal>> struct Supplied {
    using reads = decltype(Channels<Motion>{} | reads_of<Test>{});
    using remembers = remembers_of<Test>;
    Test test{};

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const p = px.position(), m = px[motion];
        auto const scale = detail::to_pixels(convention, px.size());
        auto const jitter = offset(px);
        return detail::TestedReprojection<Real, decltype(test.around(px))>{
            {p.x + m.x * scale.x + jitter.x, p.y + m.y * scale.y + jitter.y}, Real(1.f), test.around(px)};
    }

private:
    /// A sample offset by +jitter shows the image shifted by -jitter, so a vector between jittered images is off by the change of jitter.
    QUELL_KERNEL static glm::vec2 offset(auto const& px) {
        if constexpr (convention.jitter == MotionConvention::Jitter::left_out)
            return {0.f, 0.f};
        else
            return px.jitter_then() - px.jitter_now();
    }
};

} // namespace quell
