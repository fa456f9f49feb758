#include "denoised.hpp"

#include <chrono>

namespace quell::examples {

DemoDenoiser::DemoDenoiser(Extent size, int thread_count) : history(size, denoise), threads{.count = thread_count} {}

double DemoDenoiser::run(DemoFrame const& frame) {
    auto const begin = std::chrono::steady_clock::now();
    result = quell::run(denoise, frame, history, threads);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace quell::examples
