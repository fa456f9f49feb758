#include <quell/quell.hpp>

#include <cmath>
#include <cstdio>

constexpr auto denoise = quell::presets::svgf(quell::radiance, quell::Demodulate{});
constexpr quell::Extent size{64, 64};

/// A grey wall that half of the samples miss.
static void render(auto& frame, int number) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const sample = (x + y + number) % 2 == 0 ? 1.f : 0.f;
            frame[quell::radiance].set(x, y, {sample, sample, sample});
            frame[quell::albedo].set(x, y, {0.5f, 0.5f, 0.5f});
            frame[quell::normal].set(x, y, {0.f, 0.f, 1.f});
            frame[quell::depth].set(x, y, 4.f);
        }
}

int main() {
#ifdef SHADERS_FOLDER
    std::FILE* const plan = std::fopen(SHADERS_FOLDER "/plan.json", "r");
    if (!plan) return 2;
    std::fclose(plan);
#endif
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    float worst = 0.f;
    for (int number = 0; number < 8; ++number) {
        render(frame, number);
        auto const clean = quell::run(denoise, frame, history);
        worst = 0.f;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) worst = std::fmax(worst, std::fabs(clean.get(0, x, y) - 0.5f));
    }
    std::printf("furthest from the mean: %g\n", static_cast<double>(worst));
    return worst < 0.05f ? 0 : 1;
}
