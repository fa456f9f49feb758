#include "layouts.hpp"
#include "measured.hpp"

#include <cuda_runtime_api.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

// quell-cuda                       runs each preset by Cuda and by Serial, then measures it
// quell-cuda --layouts FILE.ptx... compares how jobs are laid out by the host's and by the device's compiler; needs no GPU
namespace quell::bench {
namespace {

int find_device() {
    int count = 0;
    auto const status = cudaGetDeviceCount(&count);
    if (status == cudaSuccess && count > 0) return 0;
    std::fprintf(stderr, "quell-cuda: no GPU to run on (%s); run it on a machine with an NVIDIA GPU and a driver for CUDA %d.%d or newer\n",
                 status == cudaSuccess ? "the driver has none" : cudaGetErrorString(status), CUDART_VERSION / 1000,
                 CUDART_VERSION / 10 % 100);
    return 1;
}

void print_device() {
    cudaDeviceProp device{};
    int driver = 0;
    if (cudaGetDeviceProperties(&device, 0) != cudaSuccess || cudaDriverGetVersion(&driver) != cudaSuccess) return;
    std::printf("%s, compute capability %d.%d, driver for CUDA %d.%d, compiled by CUDA %d.%d\n\n", device.name, device.major, device.minor,
                driver / 1000, driver / 10 % 100, CUDART_VERSION / 1000, CUDART_VERSION / 10 % 100);
}

bool print_agreement() {
    constexpr int width = 256, height = 144, frames = 8;
    std::printf("Cuda against Serial, %d frames of %dx%d: greatest difference relative to max(1, value)\n", frames, width, height);
    std::printf("| preset | greatest difference | components apart by more than %g | counts |\n| --- | --- | --- | --- |\n",
                Agreement::allowed);
    bool good = true;
    for (auto const& preset : measured_presets()) {
        auto const found = preset.agreement(width, height, frames);
        good = good && found.good();
        std::printf("| %s | %.1e | %.4f %% | %s |%s\n", preset.name.c_str(), found.worst, 100. * found.apart,
                    found.counts_equal ? "equal" : "differ", found.good() ? "" : " NOT good");
        std::fflush(stdout);
    }
    return good;
}

double device_time(Cost const& cost) {
    double sum = 0;
    for (auto const& pass : cost.passes) sum += pass.milliseconds;
    return sum;
}

void print_times(int width, int height, bool with_passes) {
    std::printf("\n%dx%d, milliseconds a frame\n| preset | passes on the device | frames in a row | the host waits | run() returns | as "
                "graphs, in a row | run() returns |\n"
                "| --- | --- | --- | --- | --- | --- | --- |\n",
                width, height);
    std::vector<Cost> costs;
    for (auto const& preset : measured_presets()) {
        auto const& cost = costs.emplace_back(preset.cost(width, height, 12));
        std::printf("| %s | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |\n", preset.name.c_str(), device_time(cost), cost.milliseconds_in_row,
                    cost.milliseconds, cost.host_milliseconds, cost.graph_milliseconds_in_row, cost.graph_host_milliseconds);
        std::fflush(stdout);
    }
    if (!with_passes) return;
    std::printf("\nPasses at %dx%d\n| preset | pass | milliseconds | registers | local bytes |\n| --- | --- | --- | --- | --- |\n", width,
                height);
    for (std::size_t i = 0; i < costs.size(); ++i)
        for (auto const& pass : costs[i].passes)
            std::printf("| %s | %s | %.3f | %d | %zu |\n", measured_presets()[i].name.c_str(), pass.name.c_str(), pass.milliseconds,
                        pass.registers, pass.local_bytes);
}

int run_all() {
    if (int const failed = find_device()) return failed;
    print_device();
    std::ranges::sort(measured_presets(), {}, &Measured::order);
    bool const good = print_agreement();
    print_times(1920, 1080, true);
    print_times(3840, 2160, false);
    if (!good) std::fprintf(stderr, "quell-cuda: Cuda and Serial do not agree; see the rows that say NOT good\n");
    return good ? 0 : 1;
}

} // namespace
} // namespace quell::bench

int main(int count, char** arguments) {
    using namespace quell::bench;
    try {
        if (count > 2 && std::strcmp(arguments[1], "--layouts") == 0) return check_layouts({arguments + 2, arguments + count}) ? 0 : 1;
        if (count == 1) return run_all();
    } catch (std::exception const& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    std::fprintf(stderr, "usage: quell-cuda [--layouts FILE.ptx...]\n");
    return 2;
}
