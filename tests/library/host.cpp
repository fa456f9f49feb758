// A host that includes both the library's header and quell's own, with other flags than the library's: fast math, no exceptions.
#include <quell/quell.hpp>

#include <quell_denoiser.hpp>

/// The greatest difference between what the library and the headers make of the same frames.
extern "C" float difference_of_both(int width, int height);

extern "C" float difference_of_both(int width, int height) {
    constexpr auto denoise = quell::presets::svgf(quell::radiance, quell::Demodulate{});
    quell::Frame frame{{width, height}, denoise};
    quell::History history{frame.size, denoise};
    auto const n = static_cast<std::size_t>(width * height);
    std::vector<float> rgb(n * 3), albedo(n * 3), normal(n * 3), depth(n), motion(n * 2), out(n * 3);
    quell::Denoiser denoiser("svgf", width, height);
    denoiser.set("radiance", rgb.data(), 3).set("albedo", albedo.data(), 3).set("normal", normal.data(), 3);
    denoiser.set("depth", depth.data(), 1).set("motion", motion.data(), 2);
    unsigned random = 1;
    auto const any = [&] { return static_cast<float>((random = random * 1664525u + 1013904223u) >> 8) * 0x1p-24f; };
    float worst = 0;
    for (int i = 0; i < 5; ++i) {
        for (std::size_t p = 0; p < n; ++p) {
            int const x = static_cast<int>(p) % width, y = static_cast<int>(p) / width;
            glm::vec3 const light(any(), any(), any()), colour(0.2f + 0.7f * any());
            float const z = 3.f + 0.01f * static_cast<float>(x) + 0.02f * static_cast<float>(y);
            frame[quell::radiance].set(x, y, light), frame[quell::albedo].set(x, y, colour), frame[quell::normal].set(x, y, {0, 0, 1});
            frame[quell::depth].set(x, y, z), frame[quell::motion].set(x, y, {0.25f, -0.5f});
            for (std::size_t c = 0; c < 3; ++c) rgb[p * 3 + c] = light[static_cast<int>(c)], albedo[p * 3 + c] = colour.x;
            normal[p * 3 + 2] = 1, depth[p] = z, motion[p * 2] = 0.25f, motion[p * 2 + 1] = -0.5f;
        }
        auto const wanted = run(denoise, frame, history);
        denoiser.run(out.data(), 3);
        for (std::size_t p = 0; p < n * 3; ++p) {
            int const pixel = static_cast<int>(p / 3);
            float const apart = out[p] - wanted.get(static_cast<int>(p % 3), pixel % width, pixel / width);
            worst = apart > worst ? apart : -apart > worst ? -apart : worst;
        }
    }
    return worst;
}
