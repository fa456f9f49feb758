#pragma once

#include "core/effects.hpp"

#include <quell/frame/camera.hpp>
#include <quell/frame/frame.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace quell::live {

/// What the tracer can give.
using TracedChannels =
    Channels<Radiance, Albedo, Normal, Depth, Motion, Position, ReceiverPrevious, Roughness, Direct, Visibility, quell::Light,
             LightPrevious, Blocker, BlockerPrevious, Glossy, GlossyHit, GlossyHitPrevious, Indirect, IndirectDirection>;

/// Which rays a set of channels takes.
template <class Set> struct Wanted {
    template <class... Cs> static constexpr bool any = (Set::template has<Cs> || ...);

    static constexpr bool direct = any<Direct, Visibility, quell::Light, LightPrevious, Blocker, BlockerPrevious>;
    static constexpr bool mirrored = any<Glossy, GlossyHit, GlossyHitPrevious>;
    static constexpr bool indirect = any<Indirect, IndirectDirection>;
    static constexpr bool parts = direct || mirrored || indirect || any<Roughness>; ///< whether light is in parts, and albedo is diffuse
};

/// Traces one pixel of a frame, for the channels that it has. What none of them wants is not traced.
/// @tparam FrameViews quell's Views, in memory that the running code reaches
template <class FrameViews> class TracedPixel {
    using Set = typename FrameViews::channels;
    using wanted = Wanted<Set>;
    static_assert(contained_in<Set, TracedChannels>, "the live page's tracer does not give all channels that this frame has");

    FrameViews const& frame;
    int x, y;

public:
    QUELL_LIVE TracedPixel(FrameViews const& f, int x_, int y_) : frame(f), x(x_), y(y_) {}

    QUELL_LIVE void trace(Scene const& scene, Cameras const& cameras, Tracing const& tracing) const {
        auto const seen = seen_at(scene, cameras, tracing, x, y);
        auto guides = guides_of(scene, cameras, seen);
        auto const reflectance = wanted::parts ? reflectance_of(scene, seen) : Reflectance{};
        if constexpr (wanted::parts) guides.albedo = reflectance.diffuse;
        put<Albedo>(guides.albedo), put<Normal>(guides.normal), put<Depth>(guides.depth), put<Motion>(guides.motion);
        auto const point = followed(scene, seen.hit);
        put<Position>(point.now), put<ReceiverPrevious>(point.before), put<Roughness>(reflectance.roughness());
        if constexpr (Set::template has<Radiance>) put<Radiance>(radiance_of(scene, seen, tracing, x, y));
        auto const random = [&](int part) { return Random(x, y, tracing.frame, -part); };
        if constexpr (wanted::direct) {
            auto const light = direct_light(scene, seen, reflectance, random(1));
            put<Direct>(light.direct), put<Visibility>(light.visibility);
            put<quell::Light>(light.light.now), put<LightPrevious>(light.light.before);
            put<Blocker>(light.blocker.now), put<BlockerPrevious>(light.blocker.before);
        }
        if constexpr (wanted::mirrored) {
            auto const light = mirrored_light(scene, seen, reflectance, tracing.surfaces, random(2));
            put<Glossy>(light.radiance), put<GlossyHit>(light.hit.now), put<GlossyHitPrevious>(light.hit.before);
        }
        if constexpr (wanted::indirect) {
            auto const light = indirect_light(scene, seen, reflectance, tracing.surfaces, random(3));
            put<Indirect>(light.radiance), put<IndirectDirection>(light.direction);
        }
    }

private:
    template <class C> QUELL_LIVE void put(float a) const {
        if constexpr (Set::template has<C>) frame.view(C{}).set(0, x, y, a);
    }
    template <class C> QUELL_LIVE void put(ScreenPoint a) const {
        if constexpr (Set::template has<C>) frame.view(C{}).set(0, x, y, a.x), frame.view(C{}).set(1, x, y, a.y);
    }
    template <class C> QUELL_LIVE void put(Vector a) const {
        if constexpr (Set::template has<C>) {
            auto const& view = frame.view(C{});
            view.set(0, x, y, a.x), view.set(1, x, y, a.y), view.set(2, x, y, a.z);
        }
    }
};

/// A camera as quell has it.
inline quell::Camera matrices_of(Camera const& camera) {
    auto const vector = [](Vector a) { return glm::vec3(a.x, a.y, a.z); };
    auto const eye = vector(camera.eye);
    float const across = camera.half_width_at_1, up = camera.half_height_at_1;
    return {.view = glm::lookAt(eye, eye + vector(camera.forward), vector(camera.up)),
            .projection = glm::frustum(-across, across, -up, up, 1.f, 100.f)};
}

} // namespace quell::live
