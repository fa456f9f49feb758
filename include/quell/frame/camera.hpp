#pragma once

#include <quell/core/error.hpp>
#include <quell/image/extent.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace quell {

/// A host's camera. Column-major GLM matrices, column vectors: clip = projection * view * world.
/// The view looks down -z; the projection, a perspective one, maps to normalised device coordinates in [-1, 1] with y up (image row 0 is
/// y = +1). Whether its depth range is [0, 1], [-1, 1] or reversed makes no difference, as long as the matrix can be inverted.
struct Camera {
    glm::mat4 view{1.f};
    glm::mat4 projection{1.f}; ///< without jitter
    glm::vec2 jitter{0.f};     ///< sub-pixel offset of the sample from the pixel's centre, in pixels, y down

    [[nodiscard]] glm::mat4 clip_from_world() const { return projection * view; }
    friend bool operator==(Camera const&, Camera const&) = default;
};

namespace detail {
template <class P> constexpr bool needs_camera() {
    bool needed = false;
    if constexpr (requires { P::needs_camera; }) needed = P::needs_camera;
    // A combinator needs what its parts need.
    if constexpr (requires { P::motion; }) needed = needed || needs_camera<decltype(P::motion)>();
    if constexpr (requires { P::blending; }) needed = needed || needs_camera<decltype(P::blending)>();
    if constexpr (requires { P::kernel; }) needed = needed || needs_camera<decltype(P::kernel)>();
    if constexpr (requires { P::inner; }) needed = needed || needs_camera<decltype(P::inner)>();
    if constexpr (requires { P::first; }) needed = needed || needs_camera<decltype(P::first)>();
    if constexpr (requires { P::test; }) needed = needed || needs_camera<decltype(P::test)>();
    if constexpr (requires { P::source; }) needed = needed || needs_camera<decltype(P::source)>();
    if constexpr (requires { P::fetch; }) needed = needed || needs_camera<decltype(P::fetch)>();
    if constexpr (requires { P::width; }) needed = needed || needs_camera<decltype(P::width)>();
    if constexpr (requires { P::edge; }) needed = needed || needs_camera<decltype(P::edge)>();
    if constexpr (requires { P::rest; }) needed = needed || needs_camera<decltype(P::rest)>();
    return needed;
}
} // namespace detail

/// Whether a policy, or one that it is made of, says `static constexpr bool needs_camera = true`: then hosts must set frame.camera.
template <class P> inline constexpr bool needs_camera_of = detail::needs_camera<P>();

} // namespace quell
