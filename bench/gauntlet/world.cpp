#include <gauntlet/arithmetic.hpp>
#include <gauntlet/world.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace quell::gauntlet {

namespace {

Vec3 turned(Vec3 v, double by) {
    if (by == 0) return v;
    double const s = sine(by), c = cosine(by);
    return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
}

struct Meeting {
    double distance = 1e10;
    Vec3 normal{0.};
};

/// A ball and a box of half a length of 1.
Meeting meets_ball(Vec3 eye, Vec3 ray) {
    double const a = glm::dot(ray, ray), b = glm::dot(ray, eye), root = b * b - a * (glm::dot(eye, eye) - 1);
    if (root < 0) return {};
    double const t = (-b - std::sqrt(root)) / a;
    return t > 1e-6 ? Meeting{t, eye + ray * t} : Meeting{};
}
Meeting meets_box(Vec3 eye, Vec3 ray, Vec3 half) {
    double enters = -1e10, leaves = 1e10;
    Vec3 front{0.};
    for (int a = 0; a < 3; ++a) {
        double const one = (-half[a] - eye[a]) / ray[a], other = (half[a] - eye[a]) / ray[a];
        if (std::min(one, other) > enters) enters = std::min(one, other), front = {}, front[a] = ray[a] > 0 ? -1 : 1;
        leaves = std::min(leaves, std::max(one, other));
    }
    return enters > 1e-6 && enters < leaves ? Meeting{enters, front} : Meeting{};
}
Meeting meets_floor(Vec3 eye, Vec3 ray) {
    double const t = -eye.y / ray.y;
    return t > 1e-6 && t < 80 ? Meeting{t, {0, 1, 0}} : Meeting{};
}

/// Whether a ray misses a ball around a thing by more than rounding: most rays do, and no turn is needed to know that.
bool is_missed(Vec3 eye, Vec3 ray, double square_of_radius) {
    double const a = glm::dot(ray, ray), b = glm::dot(ray, eye), c = glm::dot(eye, eye) - 1.001 * square_of_radius;
    return c > 0 && (b > 0 || b * b < a * c);
}

int cell_of(Vec3 place) {
    auto const cell = glm::floor(place);
    auto const whole = [&](int a) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[a])); };
    return static_cast<int>(mixed(whole(0) * 73856093u ^ whole(1) * 19349663u ^ whole(2) * 83492791u) >> 33);
}
bool is_even(Vec3 place) {
    auto const cell = glm::floor(place);
    return (std::abs(static_cast<long>(cell.x)) + std::abs(static_cast<long>(cell.y)) + std::abs(static_cast<long>(cell.z))) % 2 == 0;
}

/// Checks of a floor that are much smaller than a pixel show their mean.
void fade(Hit& hit) {
    double const far = smooth_step(5, 10, hit.distance);
    hit.colour += (0.5 * (hit.of->material.one + hit.of->material.other) - hit.colour) * far;
    if (far == 1) hit.cell = 0;
}

void colour(Hit& hit, double time) {
    auto const& material = hit.of->material;
    auto const place = hit.local / material.check + 0.37 + Vec3(material.film * time, material.film * time, 0);
    hit.cell = cell_of(place);
    hit.colour = is_even(place) ? material.one : material.other;
    if (hit.of->shape == Shape::floor) fade(hit);
    if (!material.flickers) return;
    auto const key = static_cast<std::uint64_t>(hit.cell) * 1000003u + static_cast<std::uint64_t>(std::floor(time));
    hit.colour *= 0.2 + 1.1 * fraction_of(key);
}

} // namespace

double Thing::growth(double time) const { return breath == 0 ? 1 : 1 + breath * sine(1.1 * time); }
Vec3 Thing::place_of(Vec3 local, double time) const { return at + speed * time + turned(local * growth(time), angle + spin * time); }

Hit World::along(Vec3 eye, Vec3 ray, double time, Thing const* but) const {
    Hit hit;
    Vec3 normal{0.};
    for (auto const& thing : things) {
        if (&thing == but || time < thing.appears) continue;
        double const by = -(thing.angle + thing.spin * time), growth = thing.growth(time);
        auto const to_eye = eye - thing.at - thing.speed * time;
        if (thing.shape != Shape::floor &&
            is_missed(to_eye, ray,
                      growth * growth * (thing.shape == Shape::ball ? thing.half.x * thing.half.x : glm::dot(thing.half, thing.half))))
            continue;
        auto const from = turned(to_eye, by) / growth, way = turned(ray, by) / growth;
        auto const met = thing.shape == Shape::floor ? meets_floor(from, way)
                         : thing.shape == Shape::box ? meets_box(from, way, thing.half)
                                                     : meets_ball(from / thing.half.x, way / thing.half.x);
        if (met.distance < hit.distance)
            hit.distance = met.distance, hit.of = &thing, hit.local = from + way * met.distance, normal = met.normal;
    }
    if (!hit.of) return hit;
    hit.point = eye + ray * hit.distance;
    hit.normal = turned(normal, hit.of->angle + hit.of->spin * time);
    colour(hit, time);
    return hit;
}

/// How much of a lamp things leave free: of each, as of a ball around it, by how far the way to the lamp's centre goes past it.
double World::visible_lamp(Vec3 point, Vec3 lamp_at, double time, Thing const* of) const {
    double visible = 1;
    auto const way = lamp_at - point;
    double const square = glm::dot(way, way);
    for (auto const& thing : things) {
        if (&thing == of || thing.shape == Shape::floor || thing.material.is_clear || time < thing.appears) continue;
        auto const to = thing.at + thing.speed * time - point;
        double const along = glm::dot(to, way) / square;
        if (along <= 0 || along >= 1) continue;
        auto const past = to - way * along;
        double const radius = thing.growth(time) * (thing.shape == Shape::ball ? thing.half.x : 0.8 * std::max(thing.half.x, thing.half.z));
        double const width = lamp.radius * along;
        visible *= smooth_step(radius - width, radius + width, std::sqrt(glm::dot(past, past)));
    }
    return visible;
}

double World::brightness(double time) const {
    double value = 1;
    for (int n = 0; n < static_cast<int>(time); ++n) value *= exposure.grows;
    return value;
}

Falling World::light_at(Hit const& hit, double time) const {
    auto const lamp_at = lamp.at + lamp.speed * time, way = lamp_at - hit.point;
    double const square = glm::dot(way, way), cosine = glm::dot(way, hit.normal) / std::sqrt(square), all = brightness(time);
    Falling falling;
    if (cosine > 0) {
        falling.direct = all * lamp.colour * (cosine / square);
        if (static_cast<int>(time) == exposure.flash) falling.direct *= exposure.flashes;
        falling.visible = visible_lamp(hit.point, lamp_at, time, hit.of);
    }
    falling.indirect = all * ambient * (0.7 + 0.3 * hit.normal.y);
    return falling;
}

int World::sky_cell(Vec3 ray, double time) const { return cell_of(7. * turned(glm::normalize(ray), sky.spin * time) + 0.31); }

Vec3 World::sky_along(Vec3 ray, double time) const {
    auto const way = turned(glm::normalize(ray), sky.spin * time);
    auto const plain = glm::mix(sky.low, sky.high, smooth_step(-0.1, 0.7, way.y));
    double const coarse = fraction_of(static_cast<std::uint64_t>(cell_of(7. * way + 0.31)));
    double const fine = sine(31 * way.x) * sine(29 * way.y + 17 * way.z);
    return brightness(time) * plain * (1 + sky.detail * (1.2 * coarse - 0.6 + 0.35 * fine));
}

Vec3 World::flames_along(Vec3 eye, Vec3 ray, double time, double distance) const {
    Vec3 sum{0.};
    for (auto const& flame : flames) {
        auto const to = flame.at + flame.speed * time - eye;
        double const along = glm::dot(to, ray) / glm::dot(ray, ray);
        if (along <= 0 || along >= distance) continue;
        auto const past = to - ray * along;
        double const inside = std::max(0., 1 - glm::dot(past, past) / (flame.radius * flame.radius));
        sum += flame.colour * (inside * inside);
    }
    return sum * brightness(time);
}

} // namespace quell::gauntlet
