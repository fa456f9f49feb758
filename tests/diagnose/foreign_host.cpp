#include "foreign_host.hpp"

#include "../jitter.hpp"

#include <cstdint>
#include <numbers>

namespace quell::tests {

namespace {

constexpr float none = std::numeric_limits<float>::infinity();

/// Random numbers of a pixel and frame (PCG).
struct Random {
    std::uint32_t state;

    Random(int x, int y, int number)
        : state(static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^
                static_cast<std::uint32_t>(number) * 83492791u) {
        static_cast<void>(next()), static_cast<void>(next());
    }
    float next() {
        state = state * 747796405u + 2891336453u;
        auto const word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
        return static_cast<float>(((word >> 22u) ^ word) >> 8u) / 16777216.f;
    }
    glm::vec2 pair() {
        float const x = next();
        return {x, next()};
    }
};

/// A ball or a box, which may move and turn about the vertical.
struct Solid {
    bool round;
    glm::vec3 half, at;
    glm::vec3 one, other; ///< colours of the checks
    float check = 1.f;    ///< their size
    float angle = 0.f, spin = 0.f;
    glm::vec3 speed{0.f};
    float gloss = 0.f; ///< part of the light that it mirrors
    float glows = 0.f;

    [[nodiscard]] glm::vec3 at_frame(int number) const { return at + speed * static_cast<float>(number); }
    [[nodiscard]] float turn_at(int number) const { return angle + spin * static_cast<float>(number); }
};

glm::vec3 turned(glm::vec3 v, float by) {
    float const s = std::sin(by), c = std::cos(by);
    return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
}

struct Hit {
    float distance = none; ///< in lengths of the ray
    glm::vec3 p{}, normal{}, albedo{1.f};
    Solid const* of = nullptr;
};

/// Where a ray meets it, in its own frame: distance and normal.
std::pair<float, glm::vec3> meets(Solid const& solid, glm::vec3 eye, glm::vec3 ray) {
    if (solid.round) {
        float const a = glm::dot(ray, ray), b = glm::dot(ray, eye), c = glm::dot(eye, eye) - solid.half.x * solid.half.x;
        float const root = b * b - a * c;
        if (root < 0.f) return {none, {}};
        float const t = (-b - std::sqrt(root)) / a;
        return {t > 1e-3f ? t : none, (eye + ray * t) / solid.half.x};
    }
    float enters = -none, leaves = none;
    glm::vec3 front{}, back{};
    for (int a = 0; a < 3; ++a) {
        float const one = (-solid.half[a] - eye[a]) / ray[a], other = (solid.half[a] - eye[a]) / ray[a];
        float const sign = ray[a] > 0.f ? -1.f : 1.f;
        if (std::min(one, other) > enters) enters = std::min(one, other), front = {}, front[a] = sign;
        if (std::max(one, other) < leaves) leaves = std::max(one, other), back = {}, back[a] = sign;
    }
    if (enters > leaves || leaves < 1e-3f) return {none, {}};
    return enters > 1e-3f ? std::pair(enters, front) : std::pair(leaves, back);
}

struct World {
    std::vector<Solid> solids;
    glm::vec3 sky{0.f};
    glm::vec3 sun{0.f};  ///< towards it; 0 without one
    glm::vec3 lamp{0.f}; ///< centre of a square lamp that shines down; 0 without one
    float lamp_half = 0.f, lamp_power = 0.f;

    [[nodiscard]] Hit along(glm::vec3 eye, glm::vec3 ray, int number) const {
        Hit hit;
        glm::vec3 local{}, normal{};
        for (auto const& solid : solids) {
            float const by = -solid.turn_at(number);
            auto const from = turned(eye - solid.at_frame(number), by), way = turned(ray, by);
            auto const [t, n] = meets(solid, from, way);
            if (t < hit.distance) hit.distance = t, hit.of = &solid, local = from + way * t, normal = n;
        }
        if (!hit.of) return hit;
        auto const cell = glm::floor(local / hit.of->check + 0.37f);
        bool const even = (static_cast<int>(cell.x) + static_cast<int>(cell.y) + static_cast<int>(cell.z)) % 2 == 0;
        hit.albedo = even ? hit.of->one : hit.of->other;
        hit.p = eye + ray * hit.distance, hit.normal = turned(normal, hit.of->turn_at(number));
        return hit;
    }
    [[nodiscard]] bool reaches(glm::vec3 from, glm::vec3 way, int number, float up_to) const {
        return !(along(from, way, number).distance < up_to);
    }
    /// Light that falls on a point directly, over pi: one sample of the lamp and of the sun.
    [[nodiscard]] float direct(Hit const& hit, int number, Random& random) const {
        float sum = 0.f;
        auto const from = hit.p + 1e-3f * hit.normal;
        if (lamp_power > 0.f) {
            auto const u = (random.pair() * 2.f - 1.f) * lamp_half;
            auto const way = lamp + glm::vec3(u.x, 0.f, u.y) - from;
            float const squared = glm::dot(way, way), here = glm::dot(way, hit.normal), there = way.y;
            if (here > 0.f && there > 0.f && reaches(from, way, number, 0.995f)) sum += lamp_power * here * there / (squared * squared);
        }
        if (glm::length(sun) > 0.f) {
            auto const way = glm::normalize(sun + 0.06f * glm::vec3(random.pair() * 2.f - 1.f, 0.f));
            float const here = glm::dot(way, hit.normal);
            if (here > 0.f && reaches(from, way, number, none)) sum += 1.4f * here;
        }
        return sum;
    }
    /// A direction of the half space above a surface, as likely as its cosine.
    static glm::vec3 scattered(glm::vec3 normal, Random& random) {
        auto const u = random.pair();
        float const z = 1.f - 2.f * u.x, r = std::sqrt(std::max(0.f, 1.f - z * z)), a = 2.f * std::numbers::pi_v<float> * u.y;
        return normal + 0.999f * glm::vec3(r * std::cos(a), r * std::sin(a), z);
    }
    /// One path.
    [[nodiscard]] glm::vec3 light(Hit const& hit, glm::vec3 ray, int number, Random& random) const {
        if (!hit.of) return sky;
        if (hit.of->glows > 0.f) return glm::vec3(hit.of->glows);
        auto const from = hit.p + 1e-3f * hit.normal;
        bool const mirrors = random.next() < hit.of->gloss;
        auto const way = mirrors ? glm::reflect(ray, hit.normal) : scattered(hit.normal, random);
        auto const next = along(from, way, number);
        glm::vec3 const seen = !next.of               ? sky
                               : next.of->glows > 0.f ? (mirrors ? glm::vec3(next.of->glows) : glm::vec3(0.f))
                                                      : next.albedo * direct(next, number, random);
        return mirrors ? seen : hit.albedo * (direct(hit, number, random) + seen);
    }
};

/// A room with a lamp: coarse and fine checks, things that stand, roll and turn.
World studio() {
    World world;
    world.lamp = {0.f, 2.98f, -0.5f}, world.lamp_half = 0.6f, world.lamp_power = 1.6f;
    world.solids = {
        {false, {4.f, 1.5f, 5.f}, {0.f, 1.5f, 0.f}, {0.75f, 0.7f, 0.6f}, {0.3f, 0.34f, 0.45f}, 0.5f},
        {false, {0.6f, 0.02f, 0.6f}, {0.f, 3.f, -0.5f}, glm::vec3(1.f), glm::vec3(1.f), 1.f, 0.f, 0.f, glm::vec3(0.f), 0.f, 9.f},
        {false, {0.6f, 0.5f, 0.4f}, {-1.4f, 0.5f, -2.f}, {0.8f, 0.2f, 0.15f}, {0.4f, 0.1f, 0.1f}, 0.12f, 0.5f},
        {false, {0.35f, 0.9f, 0.35f}, {1.7f, 0.9f, -2.6f}, {0.2f, 0.6f, 0.3f}, {0.7f, 0.75f, 0.5f}, 0.09f, -0.3f},
        {true,
         glm::vec3(0.45f),
         {-0.6f, 0.45f, -0.8f},
         {0.9f, 0.85f, 0.3f},
         {0.3f, 0.3f, 0.75f},
         0.2f,
         0.f,
         0.f,
         {0.07f, 0.f, 0.01f},
         0.1f},
        {false, {0.3f, 0.3f, 0.3f}, {0.9f, 1.3f, -1.6f}, {0.6f, 0.3f, 0.6f}, {0.2f, 0.5f, 0.5f}, 0.15f, 0.2f, 0.03f, {-0.02f, 0.f, 0.f}},
    };
    return world;
}
/// A floor under the sky and the sun, with pillars, steps and a cart.
World plaza() {
    World world;
    world.sky = {0.45f, 0.6f, 0.9f}, world.sun = glm::normalize(glm::vec3(0.5f, 0.8f, 0.45f));
    world.solids = {
        {false, {60.f, 1.f, 60.f}, {0.f, -1.f, 0.f}, {0.5f, 0.48f, 0.42f}, {0.22f, 0.2f, 0.18f}, 0.4f, 0.3f, 0.f, glm::vec3(0.f), 0.06f}};
    for (int i = 0; i < 4; ++i)
        world.solids.push_back({false,
                                {0.25f, 1.3f, 0.25f},
                                {-2.6f + 1.7f * static_cast<float>(i), 1.3f, -3.5f - 0.5f * static_cast<float>(i)},
                                {0.75f, 0.7f, 0.62f},
                                {0.55f, 0.5f, 0.42f},
                                0.3f,
                                0.2f * static_cast<float>(i)});
    world.solids.push_back({false, {1.f, 0.15f, 0.6f}, {1.6f, 0.15f, -1.4f}, {0.6f, 0.25f, 0.2f}, {0.8f, 0.6f, 0.5f}, 0.1f, -0.4f});
    world.solids.push_back(
        {true, glm::vec3(0.4f), {-1.6f, 0.4f, -1.6f}, {0.15f, 0.3f, 0.7f}, {0.8f, 0.8f, 0.75f}, 0.16f, 0.f, 0.f, {0.07f, 0.f, -0.01f}});
    world.solids.push_back({false,
                            {0.35f, 0.25f, 0.3f},
                            {0.9f, 0.6f, -2.4f},
                            {0.8f, 0.5f, 0.1f},
                            {0.3f, 0.2f, 0.1f},
                            0.11f,
                            0.9f,
                            -0.02f,
                            {-0.03f, 0.f, 0.005f}});
    return world;
}
/// Walls that are turned, balls of all sizes and a sky, under a lamp and the sun.
World terrace() {
    World world;
    world.sky = {0.8f, 0.6f, 0.45f}, world.sun = glm::normalize(glm::vec3(-0.6f, 0.5f, 0.6f));
    world.lamp = {0.5f, 3.6f, -2.f}, world.lamp_half = 0.4f, world.lamp_power = 1.f;
    world.solids = {{false, {9.f, 0.5f, 6.f}, {0.f, -0.5f, -1.f}, {0.42f, 0.4f, 0.4f}, {0.62f, 0.55f, 0.5f}, 0.7f, 0.15f},
                    {false, {3.f, 1.1f, 0.1f}, {-2.f, 1.1f, -5.f}, {0.7f, 0.35f, 0.25f}, {0.55f, 0.2f, 0.15f}, 0.23f, 0.6f},
                    {false, {2.5f, 0.8f, 0.1f}, {3.2f, 0.8f, -4.4f}, {0.3f, 0.4f, 0.25f}, {0.15f, 0.25f, 0.12f}, 0.14f, -0.7f},
                    {false,
                     {0.9f, 0.4f, 0.5f},
                     {0.3f, 0.4f, -2.2f},
                     {0.5f, 0.45f, 0.3f},
                     {0.35f, 0.3f, 0.2f},
                     0.31f,
                     0.3f,
                     0.f,
                     glm::vec3(0.f),
                     0.04f}};
    for (int i = 0; i < 7; ++i) {
        float const t = static_cast<float>(i), r = 0.15f + 0.06f * static_cast<float>(i % 4);
        world.solids.push_back({true,
                                glm::vec3(r),
                                {-2.4f + 0.8f * t, r, -1.2f - 0.6f * static_cast<float>(i % 3)},
                                {0.2f + 0.1f * t, 0.8f - 0.08f * t, 0.5f},
                                {0.5f, 0.2f + 0.1f * t, 0.1f * t},
                                0.1f + 0.03f * t,
                                0.1f * t,
                                i % 2 ? 0.05f : 0.f,
                                i % 3 == 1 ? glm::vec3(0.03f, 0.f, 0.015f) : glm::vec3(0.f)});
    }
    return world;
}
World world_of(Set set) { return set == Set::studio ? studio() : set == Set::plaza ? plaza() : terrace(); }

} // namespace

Camera ForeignShot::camera_at(int number) const {
    auto const t = path == Path::still ? 0.f : static_cast<float>(number);
    glm::vec3 eye{0.5f, 1.35f, 3.f}, target{-0.2f, 0.7f, -2.f};
    if (path == Path::dolly || path == Path::jittered) {
        glm::vec3 const by = glm::vec3(0.02f, 0.004f, -0.05f) * t;
        eye += by, target += by;
    } else if (path == Path::orbit) {
        target = {0.f, 0.7f, -1.6f}, eye = target + turned(eye - target, 0.1f - 0.018f * t);
    } else if (path == Path::pan) {
        target = eye + turned(target - eye, 0.15f - 0.016f * t) + glm::vec3(0.f, 0.02f * t, 0.f);
    }
    float const aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    Camera camera{glm::lookAt(eye, target, {0, 1, 0}), glm::perspective(0.9f, aspect, 0.05f, 200.f)};
    if (path == Path::jittered) camera.jitter = tests::jitter_of(number, 8);
    return camera;
}

Places render(GoodFrame& frame, ForeignShot const& shot, int number) {
    auto const world = world_of(shot.set);
    frame.camera = shot.camera_at(number), frame.number = number;
    auto const then = shot.camera_at(number - 1);
    PixelRays const rays(frame.camera, frame.size);
    auto const seen_at = [&](glm::vec2 place) { return world.along(rays.eye, rays.direction(place), number); };
    Places places;
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            Random random(x, y, shot.one_seed ? 0 : number);
            auto const centre = glm::vec2(x, y) + 0.5f + frame.camera.jitter, place = centre + random.pair() - 0.5f;
            auto const at_centre = seen_at(centre), at_sample = seen_at(place);
            frame[radiance].set(x, y, world.light(at_sample, rays.direction(place), number, random));
            auto const& material = shot.guides == GuidesOf::centre ? at_centre : at_sample;
            auto const& geometry = shot.guides == GuidesOf::sample ? at_sample : at_centre;
            places.of_guides.push_back(shot.guides == GuidesOf::sample ? place : centre), places.of_signal.push_back(place);
            frame[albedo].set(x, y, material.albedo), frame[normal].set(x, y, material.normal);
            frame[depth].set(x, y, geometry.distance);
            auto was = glm::vec3(glm::inverse(then.view)[3]) + rays.direction(places.of_guides.back());
            if (auto const* const of = geometry.of) {
                auto const local = turned(geometry.p - of->at_frame(number), of->turn_at(number - 1) - of->turn_at(number));
                was = local + of->at_frame(number - 1);
            }
            frame[motion].set(x, y, projected(then, was, frame.size) - places.of_guides.back());
        }
    return places;
}

} // namespace quell::tests
