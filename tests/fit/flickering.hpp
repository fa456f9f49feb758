#pragma once

#include "fit/sequence.hpp"

#include <random>

namespace quell::tests {

/// A still wall, half in shadow, under a light whose brightness changes from frame to frame without noise: the history of the picture is
/// wrong, while that of the shadow isn't. `blocked_by_what_moves` moves the blocker, though not its shadow.
class FlickeringWall final : public bench::FitSequence {
public:
    bool blocker_moves = false, in_shadow = true;
    float sweeps = 0; ///< pixels, all of it, as far as the channels say
    static constexpr float bounced = 0.1f;

    FlickeringWall() {
        name = "flickering wall";
        size = {24, 16};
        for (int i = 0; i < 30; ++i) numbers.push_back(i);
        for_each_channel(bench::FitFrame::channels{}, [&](auto channel) { channels.insert(channel.name); });
        for (long long const frame : {24, 29}) converged.push_back({frame, metrics::displayed(clean(frame))});
    }

    void load(long long number, bench::FitFrame& frame) override {
        std::mt19937 random(static_cast<unsigned>(number));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) put(frame, x, y, number, random);
        frame.number = number;
    }

    [[nodiscard]] metrics::Picture clean(long long number) const {
        metrics::Picture picture{size, {}};
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                picture.pixels.emplace_back(brightness(number) * (x < size.width / 2 && in_shadow ? 0.5f : 1.f) + 0.5f * bounced);
        return picture;
    }

private:
    static float brightness(long long number) { return number % 2 == 0 ? 0.7f : 0.3f; }

    void put(bench::FitFrame& frame, int x, int y, long long number, std::mt19937& random) const {
        for_each_channel(bench::FitFrame::channels{}, [&]<class C>(C channel) {
            for (int c = 0; c < C::components; ++c) frame[channel].view().set(c, x, y, 0.f);
        });
        bool const seen = !in_shadow || x >= size.width / 2 || random() % 2 == 0;
        frame[visibility].set(x, y, seen ? 1.f : 0.f);
        frame[direct].set(x, y, glm::vec3(brightness(number)));
        frame[albedo].set(x, y, glm::vec3(0.5f));
        frame[indirect].set(x, y, glm::vec3(bounced));
        frame[radiance].set(x, y, glm::vec3((seen ? brightness(number) : 0.f) + 0.5f * bounced));
        frame[sweep].set(x, y, {sweeps, 0.f});
        frame[time].set(x, y, 0.5f);
        frame[normal].set(x, y, {0.f, 0.f, 1.f});
        frame[depth].set(x, y, 5.f);
        frame[blocker].set(x, y, {blocker_moves ? 0.5f : 0.f, 0.f, 0.f});
    }
};

} // namespace quell::tests
