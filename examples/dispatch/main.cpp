// One program for every x86-64 machine: code for three instruction sets, of which the best that the machine has is chosen at the start.
// This file is compiled for the oldest and includes no header of quell's.
#include "denoise.hpp"
#include "machine_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

extern "C" DenoiseFunction denoise_x86_64, denoise_x86_64_v3, denoise_x86_64_v4;

int main() {
    struct Code {
        char const* name;
        DenoiseFunction* denoise;
        [[nodiscard]] bool runs_here() const { return machine_runs(name); }
    };
    std::array const all{Code{"x86-64-v4", denoise_x86_64_v4}, Code{"x86-64-v3", denoise_x86_64_v3}, Code{"x86-64", denoise_x86_64}};
    auto const best = std::ranges::find_if(all, &Code::runs_here);
    std::printf("chosen: %s\n", best->name);

    // A program needs no more than best->denoise. All that run here must agree.
    int const width = 67, height = 33;
    std::vector<float> expected(67 * 33 * 3), found(expected.size());
    all.back().denoise(width, height, 5, expected.data());
    for (auto const& code : all) {
        if (!code.runs_here()) continue;
        code.denoise(width, height, 5, found.data());
        float worst = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            float const apart = std::abs(found[i] - expected[i]) / std::max(1.f, std::abs(expected[i]));
            worst = apart <= worst ? worst : apart;
        }
        std::printf("%s: %s\n", code.name, worst < 2e-5f && found[0] > 0 ? "agrees" : "differs");
        if (!(worst < 2e-5f)) std::printf("by %g\n", static_cast<double>(worst));
    }
}
