// Denoises by shaders on Vulkan, and compares with the CPU: a host of quell's shaders in which all is shown that one needs.
//     quell-shaders --preset general --language spirv --out out/general
//     vulkan_host out/general
//     vulkan_host out/general 1920 1080    of one size
#include "plan_runner.hpp"

#include <quell/quell.hpp>
#include <support/program.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace quell;

constexpr auto denoise = presets::general(radiance, Demodulate{});
using Input = Frame<decltype(denoise)::reads>;

/// A floor of two materials that moves to the left under a light, one noisy sample for each pixel, some of them unusable.
void render(Input& frame, unsigned number) {
    std::mt19937 random(number);
    std::exponential_distribution<float> light(1.f);
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            auto const at = static_cast<float>(x) + 1.5f * static_cast<float>(number);
            bool const is_tile = static_cast<int>(at / 24.f) % 2 == 0;
            glm::vec3 const colour = is_tile ? glm::vec3(0.7f, 0.3f, 0.2f) : glm::vec3(0.2f, 0.5f, 0.6f);
            frame[albedo].set(x, y, colour);
            frame[normal].set(x, y, glm::vec3(0, is_tile ? 1.f : 0.8f, is_tile ? 0.f : 0.6f));
            frame[depth].set(x, y, 4.f + 0.01f * static_cast<float>(frame.size.height - y));
            frame[motion].set(x, y, glm::vec2(1.5f, 0.f));
            auto const sample = random() % 100 == 0 ? std::numeric_limits<float>::quiet_NaN() : light(random);
            frame[radiance].set(x, y, colour * sample);
        }
}
void upload(Input const& frame, vulkan::PlanRunner const& to) {
    for_each_channel(Input::channels{}, [&]<class C>(C c) {
        for (int k = 0; k < C::components; ++k) {
            auto const plane = to.input(C::name, k);
            if (plane.empty()) raise_error("plan.json", "it is of another preset", "write the shaders of general");
            for (int y = 0; y < frame.size.height; ++y)
                for (int x = 0; x < frame.size.width; ++x)
                    plane[static_cast<std::size_t>(y * frame.size.width + x)] = frame[c].get(k, x, y);
        }
    });
}
/// The largest difference between both pictures, relative where they are above 1.
float difference(auto const& clean, vulkan::PlanRunner const& on_device) {
    float worst = 0.f;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < clean.size.height; ++y)
            for (int x = 0; x < clean.size.width; ++x) {
                float const one = clean.get(c, x, y), other = on_device.picture(c)[static_cast<std::size_t>(y * clean.size.width + x)];
                float const off = std::abs(one - other) / std::max(1.f, std::abs(one));
                // NaN counts as infinite: it would give way to the next number.
                worst = std::max(worst, std::isnan(off) ? std::numeric_limits<float>::infinity() : off);
            }
    return worst;
}

/// Processor time of all threads in seconds, which others on the machine hardly lengthen.
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void body(char const* folder, std::vector<Extent> const& sizes) {
    vulkan::Device const device;
    vulkan::PlanRunner shaders(device, folder);
    History history{{1, 1}, denoise};
    float worst = 0.f;
    double seconds = 0, by_shaders = 0, by_serial = 0;
    int runs = 0;
    for (Extent const size : sizes) {
        shaders.resize(size);
        history = History{size, denoise};
        Input frame(size, denoise);
        Camera then;
        for (unsigned number = 0; number < 6; ++number) {
            if (number == 4) shaders.forget(), history.forget(); // a cut
            render(frame, number);
            upload(frame, shaders);
            auto const start = std::chrono::steady_clock::now();
            auto const processor_start = processor_time();
            shaders.run({.size = size, .frame_index = static_cast<std::int32_t>(number), .camera = frame.camera, .camera_then = then});
            auto const between = processor_time();
            seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), ++runs;
            auto const clean = run(denoise, frame, history, Serial{});
            by_shaders += between - processor_start, by_serial += processor_time() - between;
            worst = std::max(worst, difference(clean, shaders));
            then = frame.camera;
        }
    }
    std::printf("%s: %.2f ms a frame, of processor time %.0f, of Serial %.0f; %.2g from the CPU\n", device.properties().deviceName.data(),
                1e3 * seconds / runs, 1e3 * by_shaders / runs, 1e3 * by_serial / runs, static_cast<double>(worst));
    if (!(worst <= 1e-4f))
        raise_error<Failure>("the picture", "it differs from the CPU's by " + std::to_string(worst), "see docs/shaders.md");
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("vulkan_host", [&] {
        if (argc != 2 && argc != 4)
            raise_error("arguments", std::to_string(argc - 1), "give the folder that quell-shaders --language spirv has written");
        std::vector<Extent> sizes{{253, 131}, {64, 48}}; // a window that is made smaller
        if (argc == 4) sizes = {{std::atoi(argv[2]), std::atoi(argv[3])}};
        for (auto const& size : sizes)
            if (size.width < 1 || size.height < 1) raise_error("size", to_string(size), "give width and height in pixels");
        body(argv[1], sizes);
    });
}
