#pragma once

#include "lighting.hpp"

#include <quell/core/channel.hpp>
#include <quell/frame/channels.hpp>

namespace quell::tracer {

/// Which rays a set of channels takes. A channel that nobody wants costs nothing: what it alone would need isn't even compiled.
template <class Wanted> struct Rays {
    template <class... Cs> static constexpr bool any = (Wanted::template has<Cs> || ...);

    static constexpr bool blocker = any<Blocker, BlockerPrevious, SweepOf<Visibility>>;
    static constexpr bool shadow = blocker || any<Visibility, Radiance>;
    static constexpr bool light_channels = any<Light, LightPrevious>;
    static constexpr bool light_sample = shadow || light_channels;
    static constexpr bool direct = any<Direct, Radiance>;
    static constexpr bool reflected_radiance = any<Glossy, Radiance>;
    static constexpr bool glossy = reflected_radiance || any<GlossyHit, GlossyHitPrevious, SweepOf<Glossy>>;
    static constexpr bool indirect = any<Indirect, Radiance>;
    static constexpr bool indirect_direction = indirect || any<IndirectDirection>;
    static constexpr bool previous = any<Motion, ReceiverPrevious>;
};

/// The signals of one sample of one pixel. Positions are NaN where nothing was hit.
struct Signals {
    float visibility = 1;
    glm::vec3 direct{0.f}, glossy{0.f}, indirect{0.f};
    glm::vec3 light{not_a_number}, light_previous{not_a_number};
    glm::vec3 blocker{not_a_number}, blocker_previous{not_a_number};
    glm::vec3 glossy_hit{not_a_number}, glossy_hit_previous{not_a_number};
    glm::vec3 indirect_direction{0.f};
    Hit shadow_hit, glossy_ray_hit; ///< what the shadow ray and the reflected ray met
    std::size_t emitter = 0;        ///< the one that `light` lies on
};

/// Takes one more sample into the mean of `count` others. What tells of places remains that of the first one.
inline void add_to_mean(Signals& mean, Signals const& next, int count) {
    float const part = 1 / static_cast<float>(count + 1);
    mean.visibility += (next.visibility - mean.visibility) * part;
    mean.direct += (next.direct - mean.direct) * part;
    mean.glossy += (next.glossy - mean.glossy) * part;
    mean.indirect += (next.indirect - mean.indirect) * part;
}

/// The radiance that the signals make together.
inline glm::vec3 composite(glm::vec3 diffuse, Signals const& signals) {
    return signals.direct * signals.visibility + signals.glossy + diffuse * signals.indirect;
}

/// Traces the shadow ray towards `signals.light`; `find_blocker` also asks what is in the way (nearest to the receiver).
void trace_shadow(PreparedScene const& scene, Surface const& surface, PathContext const& path, bool find_blocker, Signals& signals);

/// Traces one reflected ray; `shade` asks for its radiance too.
void trace_glossy(PreparedScene const& scene, Surface const& surface, glm::vec3 to_viewer, PathContext const& path, float footprint_angle,
                  bool shade, Signals& signals);

/// Picks the direction of the indirect sample, and traces it if `shade`. Where the scene wants no such rays, the background's ambient light
/// takes the sample's place.
void trace_indirect(PreparedScene const& scene, Surface const& surface, PathContext const& path, bool shade, Signals& signals);

/// Light sample, shadow and unshadowed direct light.
template <class Wanted> void trace_direct(PreparedScene const& scene, Surface const& surface, PathContext const& path, Signals& signals) {
    using rays = Rays<Wanted>;
    auto const reflectance = surface.diffuse() * std::numbers::inv_pi_v<float>;
    bool const has_shadows = scene.description().secondary_rays;
    if (rays::light_channels || (rays::light_sample && has_shadows)) {
        auto const point = sample_pair(path.key, SampleUse::light_point);
        auto const lighting = sample_lighting(scene, surface, path.time, point, sample_pair(path.key, SampleUse::light_choice).x);
        signals.direct = reflectance * lighting.irradiance;
        signals.light = lighting.sample.position;
        signals.light_previous = lighting.sample.position_before;
        signals.emitter = lighting.sample.emitter;
        if constexpr (rays::shadow)
            if (lighting.sample.exists && has_shadows) trace_shadow(scene, surface, path, rays::blocker, signals);
    } else if (rays::direct) {
        signals.direct = reflectance * unshadowed_irradiance(scene, surface, path.time);
    }
}

/// Everything that `Wanted` asks for beyond the surface itself.
template <class Wanted>
Signals trace_signals(PreparedScene const& scene, Surface const& surface, glm::vec3 to_viewer, PathContext const& path,
                      float footprint_angle) {
    using rays = Rays<Wanted>;
    Signals signals;
    signals.indirect_direction = surface.normal;
    if (surface.is_emitter) {
        signals.direct = surface.emission;
        return signals;
    }
    trace_direct<Wanted>(scene, surface, path, signals);
    if constexpr (rays::glossy)
        if (surface.metallic > 0 && scene.description().secondary_rays)
            trace_glossy(scene, surface, to_viewer, path, footprint_angle, rays::reflected_radiance, signals);
    if constexpr (rays::indirect_direction) trace_indirect(scene, surface, path, rays::indirect, signals);
    return signals;
}

} // namespace quell::tracer
