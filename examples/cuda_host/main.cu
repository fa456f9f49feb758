// Renders and denoises on a GPU: the live page's path tracer fills frames in the device's memory, `general` denoises them there, and the
// host sees the last picture only. nvcc alone builds it:
//     nvcc -std=c++20 --expt-relaxed-constexpr -arch=sm_80 -Iinclude -Iexamples examples/cuda_host/main.cu -o cuda_host
//     ./cuda_host [frames [width height]]      prints times, and writes noisy.png and denoised.png
#include "png.hpp"

#include <live/core/scenes.hpp>
#include <live/core/trace.hpp>
#include <live/pictures.hpp>

#include <quell/execute/device.cuh>
#include <quell/presets/general.hpp>
#include <quell/quell.hpp>

#include <chrono>
#include <cstdlib>

namespace {

using namespace quell;
constexpr auto denoise = presets::general(radiance, Demodulate{});
using DeviceFrame = Frame<decltype(denoise)::reads, Device<>>;
template <class C> using View = ViewOf<Device<>, C>;

/// A pass of this host's own: one path for each pixel, into the frame that is denoised next.
struct Trace {
    static constexpr auto name = "trace";
    live::Scene const* scene; ///< the device's
    live::Cameras cameras;
    live::Tracing tracing;
    View<Radiance> radiance;
    View<Albedo> albedo;
    View<Normal> normal;
    View<Depth> depth;
    View<Motion> motion;

    __device__ void operator()(AtOnce<float>, int x, int y, int) const {
        auto const value = live::trace_pixel(*scene, cameras, tracing, x, y);
        put(radiance, x, y, value.radiance), put(albedo, x, y, value.albedo), put(normal, x, y, value.normal);
        depth.set(0, x, y, value.depth);
        motion.set(0, x, y, value.motion.x), motion.set(1, x, y, value.motion.y);
    }
    __device__ static void put(auto const& view, int x, int y, live::Vector a) {
        view.set(0, x, y, a.x), view.set(1, x, y, a.y), view.set(2, x, y, a.z);
    }
};

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

void write(char const* path, auto const& image) {
    auto const size = image.size();
    std::vector<unsigned char> rows;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const colour = live::packed(live::ToneMap{}({image.get(0, x, y), image.get(1, x, y), image.get(2, x, y)}));
            for (int shift : {0, 8, 16}) rows.push_back(static_cast<unsigned char>(colour >> shift));
        }
    if (!cuda_host::PngFile(path).write(static_cast<unsigned>(size.width), static_cast<unsigned>(size.height), rows))
        raise_error<Failure>(path, "can't be written", "run it in a folder where you may write");
}

/// Where everything is at a frame.
live::Moment moment_of(int number) { return {.time = static_cast<float>(number) / 30}; }
live::Camera camera_of(int number, Extent size) {
    auto orbit = live::first_orbit(0);
    orbit.yaw += 0.004f * static_cast<float>(number);
    return live::camera_of(live::within_reach(0, orbit), size.width, size.height);
}

void render(int frames, Extent size) {
    cudaStream_t stream = nullptr;
    cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking);
    CudaGraphs graphs;
    Cuda const cuda{.stream = stream}, by_graph{.stream = stream, .graphs = &graphs};
    DeviceFrame frame{size};
    History history{size, denoise, Device<>{}};
    auto* const scene = static_cast<live::Scene*>(DeviceMemory::allocate(sizeof(live::Scene)));
    Mark start, traced, denoised;
    float trace_time = 0, denoise_time = 0;
    double host_time = 0;
    int timed = 0;
    auto picture = ViewOf<Device<>, Radiance>{};
    for (int i = 0; i < frames; ++i) {
        auto const now = live::moving_scene(0, moment_of(i), moment_of(i > 0 ? i - 1 : 0));
        cuda.copy(scene, &now, sizeof(now));
        start.set(stream);
        cuda.enqueue({0, 0, size.width, size.height}, Trace{scene,
                                                            {camera_of(i, size), camera_of(i > 0 ? i - 1 : 0, size)},
                                                            {.samples = 1, .frame = static_cast<std::uint32_t>(i + 1)},
                                                            frame[radiance].view(),
                                                            frame[albedo].view(),
                                                            frame[normal].view(),
                                                            frame[depth].view(),
                                                            frame[motion].view()});
        traced.set(stream);
        auto const begun = std::chrono::steady_clock::now();
        picture = run(denoise, frame, history, by_graph);
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
    write("noisy.png", download(frame[radiance].view(), cuda));
    write("denoised.png", download(picture, cuda));
    DeviceMemory::release(scene);
    cudaStreamDestroy(stream);
}

} // namespace

int main(int count, char** arguments) {
    auto const number = [&](int i, int otherwise) { return count > i ? std::atoi(arguments[i]) : otherwise; };
    int const frames = number(1, 64), width = number(2, 1280), height = number(3, 720);
    if (count == 3 || count > 4 || frames < 1 || width < 1 || height < 1 || width > 16384 || height > 16384) {
        std::fprintf(stderr, "usage: cuda_host [frames [width height]]\n");
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
        render(frames, {width, height});
    } catch (Error const& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
