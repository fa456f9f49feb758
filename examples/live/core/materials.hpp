#pragma once

#include "vector.hpp"

namespace quell::live {

/// What is drawn on a surface.
enum class Pattern { plain, checker, planks, bricks, room };

/// How a surface looks: it emits, is metal, or scatters light below a coat.
struct Material {
    Vector colour{0.8f, 0.8f, 0.8f};  ///< reflectance
    Vector second{};                  ///< the pattern's other colour
    Pattern pattern = Pattern::plain; ///< what is drawn with both
    float scale = 1;                  ///< how often a pattern repeats in a unit
    bool is_metal = false;            ///< it reflects alone, in its colour
    float roughness = 0;              ///< how far reflections scatter, 0 to 1
    float coat = 0;                   ///< reflectance of the coat at normal incidence; 0: none
    Vector emission{};                ///< radiance; such surfaces reflect nothing
};

QUELL_LIVE bool emits(Material const& m) { return m.emission.x + m.emission.y + m.emission.z > 0; }

/// A coordinate of a pattern: which repetition, and where in it, 0 to 1.
struct Repeated {
    float number; ///< whole
    float rest;   ///< 0 to 1

    QUELL_LIVE explicit Repeated(float a) : number(floorf(a)), rest(a - floorf(a)) {}
};

QUELL_LIVE bool is_odd(float whole) { return whole - 2 * floorf(whole / 2) > 0.5f; }
/// A number from 0 to 1 that looks random.
QUELL_LIVE float scrambled(float a, float b) {
    float const s = sinf(a * 12.9898f + b * 78.233f) * 437.58545f;
    return s - floorf(s);
}

QUELL_LIVE Vector planks(Material const& m, float u, float v) {
    Repeated const across(u * m.scale), along(v * m.scale / 6 + 0.37f * across.number);
    bool const is_gap = across.rest < 0.03f || along.rest < 0.006f;
    return m.colour * (is_gap ? 0.45f : 0.75f + 0.5f * scrambled(across.number, along.number));
}

QUELL_LIVE Vector bricks(Material const& m, float u, float v) {
    Repeated const up(v * m.scale), along(u * m.scale / 2.6f + (is_odd(up.number) ? 0.5f : 0));
    if (up.rest < 0.1f || along.rest < 0.04f) return m.second;
    return m.colour * (0.8f + 0.4f * scrambled(up.number, along.number));
}

/// The room's walls, each another way: `m.colour` is what they are not said to be.
QUELL_LIVE Vector room_walls(Material const& m, Vector p, Vector normal) {
    if (normal.x < -0.5f) return {0.72f, 0.1f, 0.07f};
    if (normal.x > 0.5f) return {0.1f, 0.42f, 0.5f};
    if (normal.z < -0.5f) return bricks({.colour = {0.62f, 0.5f, 0.4f}, .second = {0.66f, 0.63f, 0.58f}, .scale = 5}, p.x, p.y);
    return m.colour;
}

/// The reflectance at a point of the surface; point and normal are in the shape's own space.
QUELL_LIVE Vector colour_at(Material const& m, Vector p, Vector normal) {
    if (m.pattern == Pattern::plain) return m.colour;
    if (m.pattern == Pattern::room) return room_walls(m, p, normal);
    bool const is_flat = fabsf(normal.y) > 0.5f, faces_x = fabsf(normal.x) > 0.5f;
    float const u = faces_x ? p.z : p.x, v = is_flat ? p.z : p.y;
    if (m.pattern == Pattern::planks) return planks(m, u, v);
    if (m.pattern == Pattern::bricks) return bricks(m, u, v);
    return is_odd(floorf(u * m.scale) + floorf(v * m.scale)) ? m.second : m.colour;
}

} // namespace quell::live
