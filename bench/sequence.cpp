#include "sequence.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace quell::bench {
namespace {

constexpr int frames = sequence_frames;
constexpr float miss = std::numeric_limits<float>::infinity();

/// A surface seen in a pixel. The camera looks along +z and never turns, so a ray's parameter is its depth.
struct Seen {
    float depth = miss;
    glm::vec3 normal{0.f, 0.f, -1.f};
    glm::vec3 albedo{1.f};
};

struct Ray {
    glm::vec3 from, along;
    glm::vec3 at(float depth) const { return from + along * depth; }
};

void keep_nearer(Seen& seen, float depth, glm::vec3 normal, glm::vec3 albedo) {
    if (depth > 0.1f && depth < seen.depth) seen = {depth, normal, albedo};
}

glm::vec3 checkered(float u, float v) {
    int const field = static_cast<int>(std::floor(u * 4.f)) + static_cast<int>(std::floor(v * 4.f));
    return field % 2 == 0 ? glm::vec3(0.7f, 0.6f, 0.5f) : glm::vec3(0.2f, 0.25f, 0.3f);
}

void add_room(Seen& seen, Ray const& ray) {
    float const floor_depth = (-1.2f - ray.from.y) / ray.along.y;
    if (ray.along.y < 0.f) keep_nearer(seen, floor_depth, {0.f, 1.f, 0.f}, checkered(ray.at(floor_depth).x, ray.at(floor_depth).z));
    float const side_depth = (-4.f - ray.from.x) / ray.along.x;
    if (ray.along.x < 0.f) keep_nearer(seen, side_depth, {1.f, 0.f, 0.f}, {0.6f, 0.1f, 0.1f});
    auto const back = ray.at(14.f);
    if (back.y < 3.f) keep_nearer(seen, 14.f, {0.f, 0.f, -1.f}, checkered(back.x * 0.5f, back.y * 0.5f));
}

/// Thin things before a far background: nearly every pack of pixels near them straddles an edge.
void add_posts(Seen& seen, Ray const& ray) {
    auto const p = ray.at(5.f);
    float const beside = p.x - std::round(p.x / 0.8f) * 0.8f;
    if (std::abs(beside) < 0.03f && p.y < 1.f) keep_nearer(seen, 5.f, {0.f, 0.f, -1.f}, {0.8f, 0.8f, 0.2f});
}

void add_sphere(Seen& seen, Ray const& ray, glm::vec3 centre, float radius) {
    auto const to = centre - ray.from;
    float const a = glm::dot(ray.along, ray.along), b = glm::dot(to, ray.along), c = glm::dot(to, to) - radius * radius;
    float const inside = b * b - a * c;
    if (inside < 0.f) return;
    float const depth = (b - std::sqrt(inside)) / a;
    keep_nearer(seen, depth, (ray.at(depth) - centre) / radius, {0.3f, 0.6f, 0.4f});
}

Seen look(Ray const& ray) {
    Seen seen;
    add_room(seen, ray);
    add_posts(seen, ray);
    for (int i = 0; i < 6; ++i) {
        auto const place = static_cast<float>(i);
        add_sphere(seen, ray, {1.3f * place - 3.2f, -0.5f + 0.3f * place, 6.f + static_cast<float>(i % 3) * 2.f}, 0.7f);
    }
    return seen;
}

/// Light of one sample: right on average, as far off as an exponential variable is.
glm::vec3 lit(Seen const& seen, Ray const& ray, std::uint32_t& random) {
    if (seen.depth == miss) return glm::vec3(0.5f, 0.7f, 1.f);
    random = random * 747796405u + 2891336453u;
    auto const mixed = ((random >> ((random >> 28) + 4u)) ^ random) * 277803737u;
    float const uniform = (static_cast<float>(mixed >> 8) + 0.5f) * 0x1p-24f;
    auto const p = ray.at(seen.depth);
    float const light = 0.3f + std::max(0.f, glm::dot(seen.normal, glm::vec3(0.5f, 0.7f, -0.5f))) * (p.x + p.z > 8.f ? 1.f : 0.2f);
    return seen.albedo * (light * -std::log(uniform));
}

glm::vec3 camera_at(int frame, float reach) {
    float const angle = 6.2831853f * static_cast<float>(frame) / static_cast<float>(frames);
    return {reach * std::cos(angle), reach * std::sin(angle), 0.f};
}

Input make_frame(Extent size, int number) {
    Input made(size);
    auto const width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    // Two pixels' width of way at depth 1: at the scene's depths a frame moves the image by 0.2 to 0.7 pixels.
    auto const eye = camera_at(number, 2.f / width), eye_before = camera_at(number + frames - 1, 2.f / width);
    auto random = static_cast<std::uint32_t>(number) * 9781u + 1u;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const across = (static_cast<float>(x) + 0.5f - 0.5f * width) / width;
            float const up = (0.5f * height - static_cast<float>(y) - 0.5f) / width;
            Ray const ray{eye, {across, up, 1.f}};
            auto const seen = look(ray);
            made[radiance].set(x, y, lit(seen, ray, random));
            made[depth].set(x, y, seen.depth);
            made[normal].set(x, y, seen.normal);
            made[albedo].set(x, y, seen.albedo);
            auto const shift = (eye - eye_before) * (width / seen.depth);
            made[motion].set(x, y, {shift.x, -shift.y});
        }
    return made;
}

} // namespace

std::vector<Input> const& sequence(Extent size) {
    static std::vector<Input> made;
    if (made.empty() || !(made.front().size == size)) {
        made.clear();
        for (int i = 0; i < frames; ++i) made.push_back(make_frame(size, i));
    }
    return made;
}

} // namespace quell::bench
