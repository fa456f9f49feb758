#pragma once

// Embree 3 and 4 differ in the header's folder and in how a ray is handed over; everything else that is used here is the same in both.
#if QUELL_TRACER_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace quell::tracer {

struct ReleaseEmbree {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

/// Owns one reference to an Embree object.
template <class Handle> using EmbreePointer = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseEmbree>;

/// Closest hit.
inline void embree_intersect(RTCScene scene, RTCRayHit& ray) {
#if QUELL_TRACER_EMBREE == 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

/// Any hit: `ray.tfar` becomes -inf where there is one.
inline void embree_occluded(RTCScene scene, RTCRay& ray) {
#if QUELL_TRACER_EMBREE == 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

} // namespace quell::tracer
