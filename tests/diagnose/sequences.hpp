#pragma once

#include "../frames.hpp"

#include <quell/diagnose/diagnose.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>

// A good sequence to make mistakes in, and what diagnose says of one.
namespace quell::tests {

inline constexpr auto denoise = presets::surface(radiance, Demodulate{});
using GoodFrame = Frame<decltype(denoise)::reads>;

/// What is seen along a ray: a room from inside, and a ball in it that rolls.
struct Sight {
    float distance;
    glm::vec3 normal, moved; ///< how far that point moved since the last frame
};

inline glm::vec3 ball_at(int number) { return {-1.5f + 0.12f * static_cast<float>(number), 0.8f, -2.f}; }

inline Sight room_along(glm::vec3 eye, glm::vec3 ray) {
    glm::vec3 const low{-4, 0, -6}, high{4, 3, 5};
    Sight sight{1e9f, {}, {}};
    for (int a = 0; a < 3; ++a) {
        float const t = ((ray[a] > 0 ? high[a] : low[a]) - eye[a]) / ray[a];
        if (!(t > 0 && t < sight.distance)) continue;
        sight.distance = t, sight.normal = glm::vec3(0.f), sight.normal[a] = ray[a] > 0 ? -1.f : 1.f;
    }
    return sight;
}

/// A floor without end under the sky, and a pillar on it.
inline Sight yard_along(glm::vec3 eye, glm::vec3 ray) {
    Sight sight{std::numeric_limits<float>::infinity(), {}, {}};
    if (ray.y < 0 && -eye.y / ray.y < 60.f) sight = {-eye.y / ray.y, {0, 1, 0}, {}};
    glm::vec3 const low{0.8f, 0, -4}, high{2, 2.5f, -3};
    float enters = 0.f, leaves = sight.distance;
    glm::vec3 side{};
    for (int a = 0; a < 3; ++a) {
        float const one = (low[a] - eye[a]) / ray[a], other = (high[a] - eye[a]) / ray[a];
        if (std::min(one, other) > enters) enters = std::min(one, other), side = {}, side[a] = ray[a] > 0 ? -1.f : 1.f;
        leaves = std::min(leaves, std::max(one, other));
    }
    if (enters > 0.f && enters < leaves) sight = {enters, side, {}};
    return sight;
}

enum class Place { room, yard };

inline Sight sight_along(glm::vec3 eye, glm::vec3 ray, int number, Place where = Place::room) {
    auto sight = where == Place::room ? room_along(eye, ray) : yard_along(eye, ray);
    auto const to_ball = ball_at(number) - eye;
    float const a = glm::dot(ray, ray), b = glm::dot(ray, to_ball), c = glm::dot(to_ball, to_ball) - 0.64f, root = b * b - a * c;
    if (root < 0) return sight;
    float const t = (b - std::sqrt(root)) / a;
    if (t < sight.distance) sight = {t, (eye + ray * t - ball_at(number)) / 0.8f, ball_at(number) - ball_at(number - 1)};
    return sight;
}

/// How the camera goes, and what the host does with jitter.
struct Shot {
    bool moves = true, jitters = true;
    Extent size{160, 90};
    Place place = Place::room;
    /// The camera looks down by so much more.
    float pitch = 0.f;
    std::optional<unsigned> seed{}; ///< the same in every frame

    [[nodiscard]] Camera camera_at(int number) const {
        auto const t = moves ? static_cast<float>(number) : 3.f;
        glm::vec3 const eye{0.4f + 0.05f * t, 1.4f + 0.02f * t, 2.5f - 0.06f * t};
        Camera camera{glm::lookAt(eye, eye + glm::vec3{0.4f + 0.01f * t, -0.2f - pitch + 0.006f * t, -1.f}, {0, 1, 0}),
                      glm::perspective(1.f, static_cast<float>(size.width) / static_cast<float>(size.height), 0.1f, 30.f)};
        // The first numbers of the Halton sequence, which repeat.
        constexpr float xs[] = {0.f, -0.25f, 0.25f, -0.375f}, ys[] = {-0.17f, 0.17f, -0.39f, -0.06f};
        if (jitters) camera.jitter = {xs[number % 4], ys[number % 4]};
        return camera;
    }
};

inline glm::vec2 projected(Camera const& camera, glm::vec3 p, Extent size) {
    auto const clip = camera.clip_from_world() * glm::vec4(p, 1.f);
    return {(clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(size.width),
            (0.5f - 0.5f * clip.y / clip.w) * static_cast<float>(size.height)};
}

/// Everything as quell wants it.
inline void fill_well(GoodFrame& frame, Shot const& shot, int number) {
    frame.camera = shot.camera_at(number), frame.number = number;
    auto const then = shot.camera_at(number - 1);
    auto const to_world = glm::inverse(frame.camera.view);
    auto const eye = glm::vec3(to_world[3]);
    PixelRays const rays(frame.camera, frame.size);
    std::mt19937 random(shot.seed.value_or(static_cast<unsigned>(number)));
    std::exponential_distribution<float> light(1.f);
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            auto const place = glm::vec2(x, y) + 0.5f + frame.camera.jitter;
            auto const ray = rays.direction(place);
            auto const sight = sight_along(eye, ray, number, shot.place);
            if (!is_finite(sight.distance)) {
                frame[depth].set(x, y, sight.distance), frame[normal].set(x, y, -glm::normalize(ray));
                frame[motion].set(x, y, projected(then, glm::vec3(glm::inverse(then.view)[3]) + ray, frame.size) - place);
                frame[albedo].set(x, y, glm::vec3(1.f)), frame[radiance].set(x, y, glm::vec3(0.4f, 0.6f, 1.f));
                continue;
            }
            auto const p = rays.position(place, sight.distance);
            frame[depth].set(x, y, sight.distance), frame[normal].set(x, y, sight.normal);
            frame[motion].set(x, y, projected(then, p - sight.moved, frame.size) - place);
            auto const texture = std::sin(3.f * p.x) * std::sin(3.f * (p.y + p.z)) > 0 ? 0.8f : 0.3f;
            frame[albedo].set(x, y, glm::vec3(texture, 0.5f, 0.9f * texture));
            frame[radiance].set(x, y, glm::vec3(texture * light(random)));
        }
}

/// Changes every pixel of a channel.
template <ChannelTag C> void each(auto& frame, C channel, auto&& change) {
    fill(frame[channel], [&](int x, int y) { return change(frame[channel].get(x, y)); });
}

/// All that is found in a sequence. `make(frame, i)` fills frame i.
template <class F> std::vector<Finding> findings(Extent size, int frames, F&& make) {
    GoodFrame frame{size, denoise};
    History history{size, denoise};
    std::vector<Finding> all;
    for (int i = 0; i < frames; ++i) {
        make(frame, i);
        for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
        run(denoise, frame, history, Serial{});
    }
    return all;
}

inline std::set<Mistake> mistakes(std::vector<Finding> const& findings) {
    std::set<Mistake> set;
    for (auto const& finding : findings) {
        if (finding.mistake == Mistake::not_checked) continue;
        set.insert(finding.mistake);
        set.insert(finding.also.begin(), finding.also.end());
    }
    return set;
}

/// Whether these are the mistakes that were found, and what else.
inline void check_found(std::vector<Finding> const& found, std::set<Mistake> const& wanted) {
    std::string text;
    for (auto const& finding : found) text += to_string(finding) + "\n";
    INFO("found: ", text);
    CHECK(mistakes(found) == wanted);
    for (auto const& finding : found) {
        if (finding.mistake == Mistake::not_checked) continue;
        CHECK(finding.evidence.find_first_of("0123456789") != std::string::npos);
        CHECK_FALSE(finding.remedy.empty());
    }
}

/// Whether findings about motion say by what to multiply it.
inline void check_factor(std::vector<Finding> const& found, glm::vec2 factor) {
    for (auto const& finding : found)
        if (finding.mistake != Mistake::not_checked)
            CHECK(finding.remedy.starts_with("multiply motion by " + detail::pair(factor.x, factor.y)));
}

} // namespace quell::tests
