#pragma once

#include "sequences.hpp"

#include <functional>
#include <memory>
#include <vector>

// Mistakes of a host, each on every scene: what the table in docs/host_mistakes.md is made from.
namespace quell::tests {

/// Good frames of a scene, made once. The first is only the past of the second.
struct Take {
    std::string scene;
    std::vector<GoodFrame> good;
    std::vector<GoodFrame> one_seed; ///< the same with the same random numbers in every frame

    [[nodiscard]] Extent size() const { return good.front().size; }
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
