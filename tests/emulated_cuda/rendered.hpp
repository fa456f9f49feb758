#pragma once

#include "sequence.hpp"

#include <cuda_host/renderer.hpp>

// The frames of examples/cuda_host: traced and denoised in memory of the device, and of the host.
namespace emulated_cuda {

using Pictures = std::vector<std::vector<float>>;
inline constexpr quell::Extent rendered_size{75, 43};
inline constexpr int rendered_frames = 5;

template <int number, class Storage> using RendererOf = cuda_host::Renderer<std::remove_const_t<decltype(preset<number>())>, Storage>;

/// What Serial makes of them. In files that are compiled for the host.
template <int number> Pictures pictures_by_serial() {
    RendererOf<number, quell::Planar<>> renderer{preset<number>(), rendered_size};
    Pictures all;
    for (int i = 0; i < rendered_frames; ++i) {
        auto const pass = renderer.trace(i, &renderer.scene_of(i));
        for (int y = 0; y < rendered_size.height; ++y)
            for (int x = 0; x < rendered_size.width; ++x) pass(quell::at_once<float>, x, y, 1);
        all.push_back(components_of_picture(renderer.denoise(quell::Serial{})));
    }
    return all;
}
Pictures rendered_by_serial();
/// By one of the presets that take long to compile.
template <int number> Pictures rendered_by_serial_of();

} // namespace emulated_cuda
