#pragma once

#include "sequences.hpp"

#include <functional>
#include <memory>
#include <vector>

// Mistakes of a host, each on every scene: what the table in docs/host_mistakes.md is made from.
namespace quell::tests {

/// Where in the picture without jitter the samples of a frame lie, row by row.
struct Places {
    std::vector<glm::vec2> of_guides; ///< of depth and motion
    std::vector<glm::vec2> of_signal;
};

/// Good frames of a scene, made once. The first is only the past of the second.
struct Take {
    std::string scene;
    std::vector<GoodFrame> good;
    std::vector<GoodFrame> one_seed;    ///< the same with the same random numbers in every frame
    std::vector<Places> places{};       ///< of the good frames; where it is empty, all samples lie at centres with the camera's jitter
    std::vector<GoodFrame> elsewhere{}; ///< good frames of another camera, where there is one

    [[nodiscard]] Extent size() const { return good.front().size; }
    /// The pixel's place, which is that of its depth and motion.
    [[nodiscard]] glm::vec2 place(std::size_t i, int x, int y) const {
        auto const centre = glm::vec2(x, y) + 0.5f + good[i].camera.jitter;
        return places.empty() ? centre : places[i].of_guides[static_cast<std::size_t>(y * size().width + x)];
    }
    /// How far the signal's sample lies from the pixel's centre.
    [[nodiscard]] glm::vec2 jitter(std::size_t i, int x, int y) const {
        auto const place = places.empty() ? good[i].camera.jitter + 0.5f + glm::vec2(x, y)
                                          : places[i].of_signal[static_cast<std::size_t>(y * size().width + x)];
        return place - glm::vec2(x, y) - 0.5f;
    }
};

/// A mistake: what it does to frame i of a take.
struct HostMistake {
    std::string name;
    std::set<Mistake> right; ///< what may be said of it
    std::function<void(GoodFrame& frame, Take const& take, std::size_t i)> make;
    bool divides = false; ///< whether the host divides the signal by albedo itself, and multiplies the output by it
};

/// Divides the signal by albedo.
void divide_by_albedo(GoodFrame& frame);

/// All mistakes of the table, in its order.
std::vector<HostMistake> host_mistakes();

template <ChannelTag C> void copy_channel(GoodFrame const& from, GoodFrame& to, C channel) {
    fill(to[channel], [&](int x, int y) { return from[channel].get(x, y); });
}
inline void copy_frame(GoodFrame const& from, GoodFrame& to) {
    for_each_channel(GoodFrame::channels{}, [&](auto c) { copy_channel(from, to, c); });
    to.camera = from.camera, to.number = from.number, to.shutter = from.shutter;
}
template <ChannelTag C> void turn_rows(GoodFrame& frame, C channel) {
    auto const last = frame.size.height - 1;
    for (int y = 0; 2 * y < last; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            auto const above = frame[channel].get(x, y);
            frame[channel].set(x, y, frame[channel].get(x, last - y)), frame[channel].set(x, last - y, above);
        }
}

} // namespace quell::tests
