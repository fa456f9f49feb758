// The same from C++, without a template.
#include <quell_denoiser.hpp>

#include <cstdio>
#include <random>

int main() {
    int const width = 320, height = 180;
    std::vector<float> radiance(width * height * 3), albedo(width * height * 3, 0.5f), normal(width * height * 3),
        depth(width * height, 4.f), motion(width * height * 2), out(width * height * 3);
    for (std::size_t i = 2; i < normal.size(); i += 3) normal[i] = 1;
    quell::Denoiser denoiser("svgf", width, height);
    denoiser.set("radiance", radiance.data(), 3).set("albedo", albedo.data(), 3).set("normal", normal.data(), 3);
    denoiser.set("depth", depth.data(), 1).set("motion", motion.data(), 2);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(0, 1);
    for (int n = 0; n < 8; ++n) {
        for (auto& value : radiance) value = any(random);
        denoiser.run(out.data(), 3);
    }
    std::printf("%s%.2f %.2f %.2f\n", denoiser.plan().c_str(), static_cast<double>(out[0]), static_cast<double>(out[1]),
                static_cast<double>(out[2]));
}
