// Renders and denoises on a GPU: the live page's path tracer fills frames in the device's memory, `general` or `trmv` denoises them there,
// and the host sees the last picture only. nvcc alone builds it:
//     nvcc -std=c++20 --expt-relaxed-constexpr -arch=sm_80 -Iinclude -Iexamples examples/cuda_host/main.cu -o cuda_host
//     ./cuda_host [--preset general|trmv] [frames [width height]]      prints times, and writes noisy.ppm and denoised.ppm
#include "renderer.hpp"

#include <live/pictures.hpp>

#include <quell/execute/device.cuh>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>
#include <quell/quell.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace {

using namespace quell;

/// Marks in a stream, between which the device tells the time.
struct Mark {
    cudaEvent_t event = nullptr;
    Mark() { cudaEventCreate(&event); }
    Mark(Mark const&) = delete;
    Mark& operator=(Mark const&) = delete;
    ~Mark() { cudaEventDestroy(event); }
    void set(cudaStream_t stream) const { cudaEventRecord(event, stream); }
    float milliseconds_since(Mark const& before) const {
        float time = 0;
        cudaEventElapsedTime(&time, before.event, event);
        return time;
    }
};

/// @param colour_at gives a pixel's colour
void write(char const* path, Extent size, auto const& colour_at) {
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << size.width << ' ' << size.height << " 255\n";
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const colour = live::packed(live::ToneMap{}(colour_at(x, y)));
            for (int shift : {0, 8, 16}) file.put(static_cast<char>(colour >> shift));
        }
    if (!file.flush()) raise_error<Failure>(path, "can't be written", "run it in a folder where you may write");
}

/// What the host has of the last frame.
template <class R> void write_pictures(R const& renderer, Extent size, auto const& picture, Cuda const& cuda) {
    auto const of = [](auto const& image) {
        return [&image](int x, int y) { return live::Vector{image.get(0, x, y), image.get(1, x, y), image.get(2, x, y)}; };
    };
    auto const image_of = [&](auto channel) { return download(renderer[channel].view(), cuda); };
    auto const denoised = download(picture, cuda);
    write("denoised.ppm", size, of(denoised));
    if constexpr (R::template has<Radiance>) {
        auto const noisy = image_of(radiance);
        write("noisy.ppm", size, of(noisy));
    } else {
        auto const direct = image_of(quell::direct), glossy = image_of(quell::glossy);
        auto const albedo = image_of(quell::albedo), indirect = image_of(quell::indirect);
        auto const visibility = image_of(quell::visibility);
        write("noisy.ppm", size, [&](int x, int y) {
            return of(direct)(x, y) * visibility.get(0, x, y) + of(glossy)(x, y) + of(albedo)(x, y) * of(indirect)(x, y);
        });
    }
}

template <class P> void render(P const& denoiser, int frames, Extent size) {
    cudaStream_t stream = nullptr;
    cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking);
    CudaGraphs graphs;
    Cuda const cuda{.stream = stream}, by_graph{.stream = stream, .graphs = &graphs};
    cuda_host::Renderer<P, Device<>> renderer{denoiser, size};
    auto* const scene = static_cast<live::Scene*>(DeviceMemory::allocate(sizeof(live::Scene)));
    Mark start, traced, denoised;
    float trace_time = 0, denoise_time = 0;
    double host_time = 0;
    int timed = 0;
    auto picture = ViewOf<Device<>, Radiance>{};
    for (int i = 0; i < frames; ++i) {
        cuda.copy(scene, &renderer.scene_of(i), sizeof(live::Scene));
        start.set(stream);
        cuda.enqueue({0, 0, size.width, size.height}, renderer.trace(i, scene));
        traced.set(stream);
        auto const begun = std::chrono::steady_clock::now();
        picture = renderer.denoise(by_graph);
        std::chrono::duration<double, std::milli> const took = std::chrono::steady_clock::now() - begun;
        denoised.set(stream);
        cuda.synchronize(); // for the times alone
        if (i < frames / 4) continue;
        ++timed;
        host_time += took.count();
        trace_time += traced.milliseconds_since(start), denoise_time += denoised.milliseconds_since(traced);
    }
    std::printf("%dx%d, milliseconds a frame: traced %.3f, denoised %.3f; run() returns after %.3f\n", size.width, size.height,
                trace_time / static_cast<float>(timed), denoise_time / static_cast<float>(timed), host_time / timed);
    write_pictures(renderer, size, picture, cuda);
    DeviceMemory::release(scene);
    cudaStreamDestroy(stream);
}

} // namespace

int main(int count, char** arguments) {
    std::string_view preset = "general";
    bool good = true;
    if (count > 1 && std::string_view(arguments[1]) == "--preset") {
        if (count > 2) preset = arguments[2];
        good = count > 2 && (preset == "general" || preset == "trmv");
        count -= 2, arguments += 2;
    }
    auto const number = [&](int i, int otherwise) { return count > i ? std::atoi(arguments[i]) : otherwise; };
    int const frames = number(1, 64), width = number(2, 1280), height = number(3, 720);
    if (!good || count == 3 || count > 4 || frames < 1 || width < 1 || height < 1 || width > 16384 || height > 16384) {
        std::fprintf(stderr, "usage: cuda_host [--preset general|trmv] [frames [width height]]\n");
        return 2;
    }
    int devices = 0;
    if (auto const status = cudaGetDeviceCount(&devices); status != cudaSuccess || devices == 0) {
        std::fprintf(stderr,
                     "cuda_host: no GPU to run on (%s); run it on a machine with an NVIDIA GPU and a driver that is as new as CUDA\n",
                     status == cudaSuccess ? "the driver has none" : cudaGetErrorString(status));
        return 1;
    }
    try {
        if (preset == "trmv")
            render(presets::trmv(), frames, {width, height});
        else
            render(presets::general(radiance, Demodulate{}), frames, {width, height});
    } catch (Error const& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
