// libquell on a GPU: frames of device pointers, and the same from host memory, through quell.h. Both must give the same bits. Built by
// bench/cuda.sh; libquell's code for CPUs is left out.
#include "scene.hpp"

#include <library/cuda/cuda_code.hpp>
#include <library/cuda/cuda_instance.cuh>
#include <quell.h>

#include <cstdio>

using namespace quell_library;

Codes const* quell_code_cuda() {
    static auto const all = codes_of_device(
        {cuda_code<quell::Cuda>("surface-clamp",
                                [](float /*samples*/) { return quell::presets::surface_clamp(quell::radiance, quell::Demodulate{}); })},
        {});
    return &all;
}
extern "C" CodesOf quell_code_none;
Codes const* quell_code_none() {
    static Codes const none;
    return &none;
}

namespace {

constexpr int width = 640, height = 360, frames = 4;
using Frame = quell::Frame<decltype(quell::presets::surface_clamp(quell::radiance, quell::Demodulate{}))::reads>;

bool failed(quell_status status) {
    if (status != QUELL_OK) std::fprintf(stderr, "%s\n", quell_error());
    return status != QUELL_OK;
}
/// The last of some frames; nothing where one fails.
std::vector<float> picture_of(bool on_device) {
    quell_settings settings = QUELL_SETTINGS;
    settings.preset = "surface-clamp", settings.width = width, settings.height = height, settings.device = QUELL_CUDA;
    quell_denoiser* denoiser = nullptr;
    if (failed(quell_create(&settings, &denoiser))) return {};
    std::vector<void*> blocks;
    auto const lent = [&](std::vector<float>& numbers) -> void* {
        if (!on_device) return numbers.data();
        auto const bytes = numbers.size() * sizeof(float);
        auto* const block = blocks.emplace_back(quell::DeviceMemory::allocate(bytes));
        cudaMemcpy(block, numbers.data(), bytes, cudaMemcpyDefault);
        return block;
    };
    std::vector<float> picture(std::size_t{3} * width * height);
    bool is_good = true;
    for (int i = 0; i < frames && is_good; ++i) {
        Frame rendered({width, height});
        quell::bench::fill_frame(rendered, i);
        std::vector<std::vector<float>> numbers;
        std::vector<quell_channel> channels;
        for_each_channel(Frame::channels{}, [&](auto c) {
            auto& pixels = numbers.emplace_back();
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    for (int k = 0; k < c.components; ++k) pixels.push_back(rendered[c].view().get(k, x, y));
        });
        std::size_t next = 0;
        for_each_channel(Frame::channels{}, [&](auto c) {
            channels.push_back({c.name, QUELL_PIXELS(lent(numbers[next++]), c.components)});
        });
        quell_frame frame = QUELL_FRAME;
        frame.channels = channels.data(), frame.channel_count = channels.size(), frame.output = QUELL_PIXELS(lent(picture), 3);
        is_good = !failed(quell_run(denoiser, &frame));
        if (is_good && on_device)
            is_good = cudaMemcpy(picture.data(), frame.output.data, picture.size() * sizeof(float), cudaMemcpyDefault) == cudaSuccess;
    }
    quell_destroy(denoiser);
    for (auto* const block : blocks) quell::DeviceMemory::release(block);
    return is_good ? picture : std::vector<float>();
}

} // namespace

int main() {
    auto const from_device = picture_of(true);
    if (from_device.empty()) return 1;
    bool const is_same = from_device == picture_of(false);
    std::printf("libquell, %d frames of %dx%d from device pointers and from host memory: %s\n", frames, width, height,
                is_same ? "the same bits" : "they DIFFER");
    return is_same ? 0 : 1;
}
