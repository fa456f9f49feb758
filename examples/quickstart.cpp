// The README's code, with a renderer that makes up its frames.
#include <quell/quell.hpp>

#include <cstdio>
#include <random>

constexpr auto denoise = quell::presets::general(quell::radiance, quell::Demodulate{});

/// Stands for a path tracer: a grey wall in noisy light.
void render(auto& frame) {
    static std::mt19937 random(1);
    std::uniform_real_distribution<float> light(0.f, 1.f);
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            frame[quell::radiance].set(x, y, glm::vec3(light(random)));
            frame[quell::albedo].set(x, y, glm::vec3(0.8f));
            frame[quell::normal].set(x, y, {0, 0, 1});
            frame[quell::depth].set(x, y, 3.f);
            frame[quell::motion].set(x, y, {0, 0});
        }
}

int main() {
    quell::Extent const size{320, 180};
    quell::Frame frame{size, denoise};     // exactly the channels that `denoise` reads
    quell::History history{size, denoise}; // exactly what it must remember
    for (int i = 0; i < 16; ++i) {
        render(frame);
        auto const clean = quell::run(denoise, frame, history);
        std::printf("frame %2d: %.3f in the middle, 0.5 is right\n", i, static_cast<double>(clean.get(0, size.width / 2, size.height / 2)));
    }
}
