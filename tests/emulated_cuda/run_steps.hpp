#pragma once

#include "emulated.hpp"

#include <quell/execute/device.cuh>

#include "rendered.hpp"

// Runs the steps on the emulated device.
namespace emulated_cuda {

/// A frame in the device's memory.
template <class P> auto uploaded(P const& denoise, Step const& step, quell::Cuda const& cuda) {
    quell::Frame rendered{{step.width, step.height}, denoise};
    fill(rendered, step);
    quell::Frame frame{rendered.size, denoise, quell::Device<>{}};
    for_each_channel(typename decltype(frame)::channels{}, [&](auto channel) { quell::upload(frame[channel], rendered[channel], cuda); });
    frame.camera = rendered.camera, frame.number = rendered.number;
    return frame;
}

/// Runs a step, and returns the picture.
template <class P, class H> Result run_step(P const& denoise, Step const& step, H& history, Emulated const& executor) {
    auto const frame = uploaded(denoise, step, executor.cuda);
    auto const view = run(denoise, frame, history, executor);
    return result_of(history, download(view, executor.cuda).view());
}
template <class Format = quell::Float32, class P> auto history_of(P const& denoise) {
    return quell::History{{steps[0].width, steps[0].height}, denoise, quell::Device<Format>{}};
}

template <int number> void check_preset(std::vector<Result> const& expected, quell::CudaGraphs* graphs) {
    constexpr auto denoise = preset<number>();
    Emulated const executor{{.graphs = graphs}};
    auto history = history_of(denoise);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        CAPTURE(number);
        CAPTURE(i);
        if (steps[i].forgotten) history.forget();
        CHECK(run_step(denoise, steps[i], history, executor) == expected[i]);
    }
}

/// Renders the frames of examples/cuda_host on the device.
template <int number> void check_rendered(Pictures const& expected, quell::CudaGraphs* graphs) {
    Emulated const executor, by_graph{{.graphs = graphs}};
    RendererOf<number, quell::Device<>> renderer{preset<number>(), rendered_size};
    auto* const scene = static_cast<quell::live::Scene*>(quell::DeviceMemory::allocate(sizeof(quell::live::Scene)));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(number);
        CAPTURE(i);
        executor.cuda.copy(scene, &renderer.scene_of(static_cast<int>(i)), sizeof *scene);
        executor.enqueue({0, 0, rendered_size.width, rendered_size.height}, renderer.trace(static_cast<int>(i), scene));
        auto const picture = renderer.denoise(by_graph);
        CHECK(components_of_picture(download(picture, executor.cuda).view()) == expected[i]);
    }
    quell::DeviceMemory::release(scene);
}

} // namespace emulated_cuda
