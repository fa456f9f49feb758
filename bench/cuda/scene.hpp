#pragma once

#include <quell/quell.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

// A made-up world that has every channel, so that no tracer is needed where times are measured: a floor and a wall, posts before them, a
// light that moves, and a camera that moves. Noise is that of one sample per pixel, and some samples are missing.
namespace quell::bench {

/// Where the camera is in a frame. It goes to and fro, so that two frames can be run round and round. Posts move by 8 pixels, the wall
/// by 3.
inline glm::vec3 eye_of(int number, Extent size) {
    float const way = number % 2 == 0 ? 0.f : 100.f / static_cast<float>(size.width);
    return {way, 2.f + 0.3f * way, 6.f - 0.2f * way};
}
inline glm::vec3 light_of(int number) { return {2.f + (number % 2 == 0 ? 0.f : 0.01f), 5.f, 0.f}; }

/// Equal numbers on every machine, in [0, 1).
inline float uniform(int x, int y, int frame, unsigned which) {
    auto h = static_cast<unsigned>(x) * 0x9e3779b1u ^ static_cast<unsigned>(y) * 0x85ebca77u ^ static_cast<unsigned>(frame) * 0xc2b2ae3du ^
             which * 0x27d4eb2fu;
    for (int i = 0; i < 2; ++i) h = (h ^ h >> 15) * 0x2c1b3c6du, h ^= h >> 13;
    return static_cast<float>(h >> 8) * 0x1p-24f;
}

/// What a camera sees of the world.
struct Eye {
    Extent size;
    glm::vec3 at;
    Camera camera;
    Eye(Extent size_, int number)
        : size(size_),
          at(eye_of(number, size_)), camera{.view = glm::translate(glm::mat4(1.f), -at),
                                            .projection = glm::perspective(
                                                0.9f, static_cast<float>(size.width) / static_cast<float>(size.height), 0.1f, 100.f)} {}

    /// Along the ray of a pixel's centre; 1 long in depth.
    [[nodiscard]] glm::vec3 toward(int x, int y) const {
        auto const& p = camera.projection;
        return {((static_cast<float>(x) + 0.5f) / static_cast<float>(size.width) * 2.f - 1.f) / p[0][0],
                (1.f - (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height) * 2.f) / p[1][1], -1.f};
    }
    [[nodiscard]] glm::vec2 project(glm::vec3 place) const {
        auto const clip = camera.clip_from_world() * glm::vec4(place, 1.f);
        return {(clip.x / clip.w + 1.f) * 0.5f * static_cast<float>(size.width),
                (1.f - clip.y / clip.w) * 0.5f * static_cast<float>(size.height)};
    }
};

/// The values of all channels at a pixel.
struct Sample {
    /// Nothing here knows of the next frame or of numbers of samples.
    using channels = without<AllChannels, Channels<Instance, MotionNext, SampleCount, SampleVariance>>;
    Eye const& now;
    Eye const& then;
    int x, y, number;
    float depth = 0.f;
    glm::vec3 normal{-0.2425356f, 0.f, 0.9701425f}, along{}, place{}; // of the wall, which is aslant
    glm::vec2 moved{};

    Sample(Eye const& now_, Eye const& then_, int x_, int y_, int number_) : now(now_), then(then_), x(x_), y(y_), number(number_) {
        along = now.toward(x, y);
        depth = (14.f + now.at.z - 0.25f * now.at.x) / (1.f + 0.25f * along.x);
        if (along.y < 0.f && now.at.y / -along.y < depth) depth = now.at.y / -along.y, normal = {0.f, 1.f, 0.f};
        float const beside = now.at.x + along.x * 7.f;
        if (std::abs(beside - std::round(beside)) < 0.06f && depth > 7.f) depth = 7.f, normal = {0.f, 0.f, 1.f};
        place = now.at + along * depth;
        moved = then.project(place) - glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    }
    [[nodiscard]] float random(unsigned which) const { return uniform(x, y, number, which); }
    [[nodiscard]] bool missing(unsigned which) const { return random(which) < 0.0005f; }
    [[nodiscard]] glm::vec3 noisy(glm::vec3 mean, unsigned which) const {
        if (missing(which)) return glm::vec3(std::numeric_limits<float>::quiet_NaN());
        return mean * -std::log(random(which + 1) * 0.999f + 0.0005f);
    }

    [[nodiscard]] float of(Depth) const { return depth; }
    [[nodiscard]] glm::vec3 of(Normal) const { return normal; }
    [[nodiscard]] glm::vec2 of(Motion) const { return moved; }
    [[nodiscard]] glm::vec2 of(Sweep) const { return moved * -0.5f; }
    template <class S> [[nodiscard]] glm::vec2 of(SweepOf<S>) const { return moved * -0.4f; }
    [[nodiscard]] glm::vec2 of(SweepBend) const { return moved * 0.01f; }
    [[nodiscard]] float of(Time) const { return random(11); }
    [[nodiscard]] glm::vec3 of(Position) const { return place; }
    [[nodiscard]] glm::vec3 of(ReceiverPrevious) const { return place; }
    [[nodiscard]] float of(Roughness) const { return 0.3f; }
    [[nodiscard]] glm::vec3 of(Albedo) const {
        bool const odd = (static_cast<int>(std::floor(place.x * 2.f)) + static_cast<int>(std::floor(place.z * 2.f))) % 2 != 0;
        return odd ? glm::vec3(0.2f, 0.3f, 0.4f) : glm::vec3(0.8f, 0.7f, 0.6f);
    }
    [[nodiscard]] glm::vec3 of(Radiance) const { return noisy(of(Albedo{}) * 0.7f, 21); }
    /// No surface's light changes.
    [[nodiscard]] glm::vec2 of(GradientOf<Radiance>) const { return {0.f, x % 3 == 1 && y % 3 == 1 ? 0.4f : 0.f}; }
    [[nodiscard]] glm::vec3 of(Direct) const { return of(Albedo{}) * 0.5f; }
    [[nodiscard]] glm::vec3 of(Glossy) const { return noisy({0.3f, 0.3f, 0.25f}, 31); }
    [[nodiscard]] glm::vec3 of(Indirect) const { return noisy({0.4f, 0.35f, 0.5f}, 41); }
    [[nodiscard]] float of(Visibility) const { return random(51) < 0.5f + 0.5f * std::sin(place.x * 2.f + place.z) ? 1.f : 0.f; }
    [[nodiscard]] glm::vec3 of(Light) const { return light_of(number) + glm::vec3(random(52) - 0.5f, 0.f, random(53) - 0.5f); }
    [[nodiscard]] glm::vec3 of(LightPrevious) const { return of(Light{}) + light_of(number + 1) - light_of(number); }
    [[nodiscard]] glm::vec3 of(Blocker) const {
        return of(Visibility{}) > 0.f ? glm::vec3(std::numeric_limits<float>::quiet_NaN()) : glm::mix(place, of(Light{}), 0.3f);
    }
    [[nodiscard]] glm::vec3 of(BlockerPrevious) const { return of(Blocker{}); }
    [[nodiscard]] glm::vec3 of(GlossyHit) const { return place + glm::reflect(along, normal) * (2.f + random(61)); }
    [[nodiscard]] glm::vec3 of(GlossyHitPrevious) const { return of(GlossyHit{}); }
    [[nodiscard]] glm::vec3 of(IndirectDirection) const {
        float const turn = 6.2831853f * random(71), out = std::sqrt(random(72)), up = std::sqrt(1.f - out * out);
        glm::vec3 const beside(normal.y, normal.z, normal.x), behind = glm::cross(normal, beside);
        return normal * up + (beside * std::cos(turn) + behind * std::sin(turn)) * out;
    }
};

/// Fills a frame, by all threads of the machine.
template <class F> void fill_frame(F& frame, int number) {
    Eye const now(frame.size, number), then(frame.size, number + 1);
    frame.camera = now.camera;
    auto const fill_rows = [&](int first, int step) {
        for (int y = first; y < frame.size.height; y += step)
            for (int x = 0; x < frame.size.width; ++x) {
                Sample const sample(now, then, x, y, number);
                for_each_channel(typename F::channels{}, [&](auto c) { frame[c].set(x, y, sample.of(c)); });
            }
    };
    int const count = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::jthread> threads;
    for (int i = 0; i < count; ++i) threads.emplace_back(fill_rows, i, count);
}

/// Makes samples missing in a square, so that those inside have no neighbour that stands in, and a guide of some pixels impossible.
template <class F> void spoil(F& frame) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (int y = 20; y < 60; ++y)
        for (int x = 30; x < 70; ++x) {
            for_each_channel(Channels<Radiance, Glossy, Indirect>{}, [&](auto c) { frame[c].set(x, y, glm::vec3(nan)); });
            frame[visibility].set(x, y, nan);
        }
    frame[depth].set(100, 30, -1.f);
    frame[normal].set(101, 31, glm::vec3(nan));
    frame[albedo].set(102, 32, glm::vec3(2.f, 0.5f, 0.5f));
}

} // namespace quell::bench
