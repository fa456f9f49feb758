// Compiled once for each instruction set. ENTRY is the name of the function, another one each time.
#include "denoise.hpp"

#include <quell/quell.hpp>

extern "C" DenoiseFunction ENTRY;

extern "C" void ENTRY(int width, int height, int frames, float* rgb) {
    constexpr auto denoise = quell::presets::svgf(quell::radiance, quell::Demodulate{});
    quell::Extent const size{width, height};
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    unsigned random = 1;
    for (int n = 0; n < frames; ++n) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                random = random * 1664525u + 1013904223u;
                frame[quell::radiance].set(x, y, glm::vec3(static_cast<float>(random >> 8) * 0x1p-24f));
                frame[quell::albedo].set(x, y, glm::vec3(x / 8 % 2 == 0 ? 0.8f : 0.4f));
                frame[quell::normal].set(x, y, {0, 0, 1});
                frame[quell::depth].set(x, y, 3.f);
                frame[quell::motion].set(x, y, {0.25f, 0});
            }
        auto const clean = run(denoise, frame, history);
        for (int i = 0; i < width * height * 3; ++i) rgb[i] = clean.get(i % 3, i / 3 % width, i / 3 / width);
    }
}
