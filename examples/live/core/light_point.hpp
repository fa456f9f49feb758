#pragma once

#include "irradiance.hpp"

namespace quell::live {

/// A point in this frame and in the previous one, in the world; NaN where there is none.
struct Followed {
    Vector now{NAN, NAN, NAN}, before{NAN, NAN, NAN};
};
/// A point of a shape, which is given in the shape's own space.
QUELL_LIVE Followed followed(Shape const& shape, Vector local) { return {shape.now.to_world(local), shape.before.to_world(local)}; }

/// A weighted reservoir: keeps one of several things that come one by one, each as likely as its weight is of all.
struct Reservoir {
    float draw;    ///< a random number from 0 to 1; used up
    float sum = 0; ///< of all weights so far

    /// Whether the next thing takes the place of what was kept.
    QUELL_LIVE bool takes(float weight) {
        if (!(weight > 0)) return false;
        sum += weight;
        float const share = weight / sum;
        bool const is_taken = draw < share;
        draw = is_taken ? draw / share : (draw - share) / (1 - share);
        return is_taken;
    }
};

/// A point of a light, with what it adds to the light of a surface, in any unit.
struct LightPoint {
    Followed point{};
    float weight = 0;
};

/// A point of the lower side of a box.
QUELL_LIVE LightPoint point_of_rectangle(Shape const& shape, float u, float v, Vector from, Vector normal) {
    Vector const local{(2 * u - 1) * shape.half.x, -shape.half.y, (2 * v - 1) * shape.half.z};
    auto const point = followed(shape, local);
    auto const to = point.now - from;
    float const distance2 = dot(to, to);
    return {point, larger(0, to.y) * dot(to, normal) / (distance2 * distance2)};
}

/// Where a direction meets a sphere; beside it, the nearest point.
QUELL_LIVE Followed point_of_sphere(Shape const& shape, Vector from, Vector direction) {
    auto const to = shape.now.centre - from;
    float const along = dot(to, direction);
    auto const aside = to - direction * along;
    float const half_chord = sqrtf(larger(0, shape.half.x * shape.half.x - dot(aside, aside)));
    return followed(shape, shape.now.to_local(from + direction * (along - half_chord)));
}

/// A point far away for a direction to the sun.
QUELL_LIVE Followed point_of_sun(Sky const& sky, Vector from, Vector direction) {
    constexpr float distance = 1000;
    auto const before = normalized(direction + (sky.towards_sun_before - sky.towards_sun));
    return {from + direction * distance, from + before * distance};
}

/// A point of a light, as likely as what it adds to the light of a surface; none where nothing does. One of a few points is taken, so that
/// it's the same in the limit of many (Talbot et al. 2005).
QUELL_LIVE Followed light_point(Scene const& scene, Light const& light, Vector from, Vector normal, Random& random) {
    constexpr int candidates = 8;
    float const first_u = random.next(), first_v = random.next();
    Reservoir reservoir{random.next()};
    auto const cone = light.kind == LightKind::rectangle ? Cone{} : cone_of(scene, light, from);
    Followed chosen;
    for (int i = 0; i < candidates; ++i) {
        float const part = static_cast<float>(i) / candidates; // a lattice, which random numbers shift
        float const u = Repeated(first_u + part).rest, v = Repeated(first_v + 5 * part).rest;
        if (light.kind == LightKind::rectangle) {
            auto const next = point_of_rectangle(scene.shapes[light.shape], u, v, from, normal);
            if (reservoir.takes(next.weight)) chosen = next.point;
        } else {
            auto const direction = turned_away(cone.axis, 1 - u * (1 - cone.cosine), turn_by(v));
            if (!reservoir.takes(dot(direction, normal))) continue;
            chosen = light.kind == LightKind::sun ? point_of_sun(scene.sky, from, direction)
                                                  : point_of_sphere(scene.shapes[light.shape], from, direction);
        }
    }
    return chosen;
}

} // namespace quell::live
