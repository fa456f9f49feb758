#pragma once

#include <gauntlet/random.hpp>
#include <gauntlet/view.hpp>

#include <vector>

// A world whose light is known at each point, without its noise: every quantity has a formula.
namespace quell::gauntlet {

struct Material {
    Vec3 one{0.7}, other{0.3}; ///< colours of the checks
    double check = 0.5;        ///< their size
    double film = 0;           ///< how far the checks go along the surface in a frame
    bool flickers = false;     ///< each check has another colour in each frame
    double glow = 0;           ///< light that the colour sends out by itself
    double gloss = 0;          ///< part of the light that it mirrors
    double roughness = 0;      ///< how far a mirrored ray may be off
    bool is_clear = false;     ///< a pane: all that it does is to stand before what is behind it
    bool operator==(Material const&) const = default;
};

enum class Shape { floor, ball, box };

/// A thing that may move, turn about the vertical and grow.
struct Thing {
    Shape shape = Shape::ball;
    Vec3 at{0.}, half{0.5}; ///< a ball's radius is the first
    Material material{};
    Vec3 speed{0.}; ///< in a frame
    double angle = 0, spin = 0;
    double breath = 0;     ///< how much larger and smaller it becomes
    int appears = -100;    ///< the time from which on it is there
    bool is_apart = false; ///< what a situation breaks is broken on this thing alone
    bool operator==(Thing const&) const = default;

    [[nodiscard]] double growth(double time) const;
    /// Where a point of the thing is at a time. @param local its place in the thing
    [[nodiscard]] Vec3 place_of(Vec3 local, double time) const;
};

/// Light in a ball of air, which covers nothing.
struct Flame {
    Vec3 at{0.}, colour{1.};
    double radius = 0.3;
    Vec3 speed{0.};
    bool operator==(Flame const&) const = default;
};

struct Lamp {
    Vec3 at{-2, 4, 1}, colour{14.}, speed{0.};
    double radius = 0.7; ///< makes edges of shadows soft
    bool operator==(Lamp const&) const = default;
};

struct Sky {
    Vec3 low{0.5, 0.55, 0.6}, high{0.25, 0.4, 0.8};
    double detail = 0.6; ///< how strong its pattern is
    double spin = 0;     ///< of the pattern, in a frame
    bool operator==(Sky const&) const = default;
};

/// How bright everything is from frame to frame.
struct Exposure {
    double grows = 1;   ///< from a frame to the next
    int flash = -1;     ///< the frame that the lamp flashes in
    double flashes = 1; ///< how bright
    bool operator==(Exposure const&) const = default;
};

/// Where a ray meets something.
struct Hit {
    Thing const* of = nullptr; ///< null: the sky
    double distance = 1e10;    ///< in lengths of the ray
    Vec3 point{0.}, local{0.}, normal{0.}, colour{1.};
    int cell = 0; ///< which check, by a number that neighbours do not share
};

/// Light that falls on a point, over pi.
struct Falling {
    Vec3 direct{0.};    ///< of the lamp where nothing is before it
    double visible = 1; ///< part of the lamp
    Vec3 indirect{0.};
};

struct World {
    std::vector<Thing> things;
    std::vector<Flame> flames;
    Sky sky{};
    Lamp lamp{};
    Vec3 ambient{0.25, 0.27, 0.3};
    Exposure exposure{};
    double fog = 0; ///< part of the light that is lost in a length of 1
    Vec3 fog_light{0.35, 0.36, 0.4};
    bool operator==(World const&) const = default;

    [[nodiscard]] Hit along(Vec3 eye, Vec3 ray, double time, Thing const* but = nullptr) const;
    [[nodiscard]] Falling light_at(Hit const& hit, double time) const;
    [[nodiscard]] Vec3 sky_along(Vec3 ray, double time) const;
    /// Which part of the sky's pattern a ray meets.
    [[nodiscard]] int sky_cell(Vec3 ray, double time) const;
    /// Light of flames before a distance.
    [[nodiscard]] Vec3 flames_along(Vec3 eye, Vec3 ray, double time, double distance) const;
    [[nodiscard]] double brightness(double time) const;

private:
    [[nodiscard]] double visible_lamp(Vec3 point, Vec3 lamp_at, double time, Thing const* of) const;
};

} // namespace quell::gauntlet
