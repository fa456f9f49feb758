#pragma once

#include "../frames.hpp"

namespace quell::tests {

/// What a pixel shows at a time: a grey value, its sweep and its depth.
struct Seen {
    float value;
    glm::vec2 sweep{0, 0};
    float depth = 4.f;
    glm::vec2 bend{0, 0};
};

/// Frames in which every pixel has a random time, and shows what is there then.
struct World {
    Extent size{64, 48};
    int frames = 8;
    float shutter = 0.5f; ///< the part of the time between frames that sweeps last

    /// What comes out of the last frame.
    /// @param seen_at of (x, y, frame, time) makes a Seen; called once for every pixel of every frame
    template <class P> std::vector<float> last(P const& pipeline, auto&& seen_at) const {
        Frame frame{size, pipeline};
        History history{size, pipeline};
        fill_still(frame);
        frame.shutter = shutter;
        std::mt19937 random(7);
        std::uniform_real_distribution<float> part(0, 1);
        std::vector<float> out;
        for (int i = 0; i < frames; ++i) {
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    float const t = part(random);
                    Seen const seen = seen_at(x, y, i, t);
                    frame[quell::time].set(x, y, t), frame[sweep].set(x, y, seen.sweep);
                    frame[radiance].set(x, y, glm::vec3(seen.value));
                    if constexpr (P::reads::template has<SweepBend>) frame[sweep_bend].set(x, y, seen.bend);
                    if constexpr (P::reads::template has<Depth>) frame[depth].set(x, y, seen.depth);
                }
            out = copy_of(run(pipeline, frame, history));
        }
        return out;
    }
    [[nodiscard]] float at(std::vector<float> const& all, int x, int y) const {
        return all[static_cast<std::size_t>(y * size.width + x) * 3];
    }
};

/// A point turned around another one by an angle in radians, clockwise in the image.
inline glm::vec2 turned(glm::vec2 p, glm::vec2 middle, float angle) {
    glm::vec2 const from = p - middle;
    float const cosine = std::cos(angle), sine = std::sin(angle);
    return middle + glm::vec2(from.x * cosine - from.y * sine, from.x * sine + from.y * cosine);
}
/// A pixel's centre.
inline glm::vec2 centre_of(int x, int y) { return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}; }

/// A bar that is 20 pixels wide and slides by 24 in a frame, by 12 while the shutter is open.
inline bool in_sliding_bar(int x, int frame, float t) {
    float const left = 20.f + 24.f * static_cast<float>(frame) + 12.f * t, centre = static_cast<float>(x) + 0.5f;
    return centre >= left && centre < left + 20;
}

/// A sector of a disc around (64, 64), half a radian wide, that turns by a radian while the shutter is open.
struct TurningSector {
    static constexpr float width = 0.5f, turn = 1.f;
    static bool covers(glm::vec2 p, float t) {
        float const angle = std::atan2(p.y - 64, p.x - 64) - turn * t, radius = glm::distance(p, glm::vec2(64, 64));
        return radius > 10 && radius < 60 && angle >= 0 && angle < width;
    }
    static Seen seen(int x, int y, int, float t) {
        auto const p = centre_of(x, y);
        if (!covers(p, t)) return {0.2f, {0, 0}, 8.f};
        auto const at = [&](float when) { return turned(p, {64, 64}, turn * (when - t)); };
        return {1.f, at(1) - at(0), 4.f, at(0.5f) - (at(0) + at(1)) * 0.5f};
    }
    static float blurred(int x, int y) {
        float sum = 0;
        for (int k = 0; k < 64; ++k) sum += seen(x, y, 0, (static_cast<float>(k) + 0.5f) / 64).value;
        return sum / 64;
    }
};

} // namespace quell::tests
