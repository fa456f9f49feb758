#include "kernel_language.hpp"

#include <quell/execute/device.cuh>
#include <quell/image/managed.cuh>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>
#include <quell/presets/resolve.hpp>
#include <quell/quell.hpp>

#include "../frames.hpp"
#include "run_steps.hpp"

using namespace quell;

// The executor Cuda as it is, on a device that is emulated. What Serial makes of the same frames comes from by_serial.cpp.
namespace {
namespace device = emulated_cuda;
using device::Emulated;
using device::history_of;
using device::run_step;
using device::uploaded;

constexpr auto clamped = device::preset<1>();
/// A pass of a host.
struct Shine {
    static constexpr auto name = "shine";
    ViewOf<Device<>, Radiance> out;
    void operator()(AtOnce<float>, int x, int y, int) const {
        for (int c = 0; c < 3; ++c) out.set(c, x, y, static_cast<float>(x + 2 * y + c));
    }
};
} // namespace

TEST_CASE("Cuda gives the bits of Serial, whatever happens between frames") {
    device::check_preset<0>(device::by_serial(0), nullptr);
    device::check_preset<1>(device::by_serial(1), nullptr);
    device::check_preset<2>(device::by_serial(2), nullptr);
    device::check_preset<3>(device::by_serial(3), nullptr);
}

TEST_CASE("frames that are traced and denoised on the device, as by examples/cuda_host, are those of the host") {
    auto const expected = device::rendered_by_serial();
    CHECK(expected.size() > 4);
    CHECK(expected[4] != expected[3]);
    device::check_rendered<0>(expected, nullptr);
    CudaGraphs graphs;
    device::check_rendered<0>(expected, &graphs);
}

TEST_CASE("a history in 16 bits is that of Serial, beside a frame in 32") {
    auto const expected = device::by_serial_in_halves();
    Emulated const executor;
    auto history = history_of<Float16>(clamped);
    for (std::size_t i = 0; i < device::steps.size(); ++i) {
        CAPTURE(i);
        if (device::steps[i].forgotten) history.forget();
        CHECK(run_step(clamped, device::steps[i], history, executor) == expected[i]);
    }
    CHECK(expected[1].picture != device::by_serial(1)[1].picture);
}

TEST_CASE("a choice of history by evidence is that of Serial") {
    device::check_preset<4>(device::by_serial(4), nullptr);
    CudaGraphs graphs;
    device::check_preset<4>(device::by_serial(4), &graphs);
}

TEST_CASE("a chain that gives light back is that of Serial") {
    auto const expected = device::by_serial(5);
    CudaGraphs graphs;
    device::check_preset<5>(expected, nullptr);
    device::check_preset<5>(expected, &graphs);
}

TEST_CASE("links that keep frames are those of Serial: colours, and resolve, which keeps six") {
    CudaGraphs graphs;
    device::check_preset<6>(device::by_serial(6), &graphs);
    device::check_preset<7>(device::by_serial(7), nullptr);
    device::check_preset<7>(device::by_serial(7), &graphs);
}

TEST_CASE("a graph that is run again has the frame's own camera, jitter, number and images") {
    auto const before = device::counts();
    CudaGraphs graphs;
    device::check_preset<0>(device::by_serial(0), &graphs);
    device::check_preset<3>(device::by_serial(3), &graphs);
    auto const& now = device::counts();
    CHECK(now.launches == before.launches);
    CHECK(now.graph_launches - before.graph_launches >= 2 * static_cast<int>(device::steps.size()));
    CHECK(now.changed_arguments > before.changed_arguments);
}

TEST_CASE("images that a host has in the device's memory are read in place, and repaired in copies there") {
    auto const expected = device::by_serial(1);
    Emulated const executor;
    auto history = history_of(clamped);
    for (std::size_t i = 0; i < 4; ++i) { // the third has guides to repair
        auto const& step = device::steps[i];
        auto const images = uploaded(clamped, step, executor.cuda);
        Frame frame{images.size, clamped, Borrowed<Float32, DeviceMemory>{}};
        for_each_channel(typename decltype(frame)::channels{}, [&](auto channel) {
            auto const view = images[channel].view();
            auto const between = channel.components > 1 ? view.planes[channel.components - 1] - view.planes[0] : 0;
            frame[channel] = {view.planes[0], view.size, 1, view.row_stride(), between / std::max(1, channel.components - 1)};
        });
        frame.camera = images.camera, frame.number = images.number;
        auto const picture = run(clamped, frame, history, executor);
        CHECK(device::result_of(history, download(picture, executor.cuda).view()) == expected[i]);
    }
}

TEST_CASE("a warm frame allocates nothing and makes no graph") {
    constexpr auto denoise = device::preset<0>();
    CudaGraphs graphs;
    Emulated const executor{{.graphs = &graphs}};
    auto history = history_of(denoise);
    auto frame = uploaded(denoise, device::steps[0], executor.cuda);
    auto const run_frames = [&](int count) {
        for (int i = 0; i < count; ++i, ++*frame.number) run(denoise, frame, history, executor);
        executor.cuda.synchronize();
    };
    run_frames(4);
    auto const warm = device::counts();
    run_frames(9);
    CHECK(device::counts().waits == warm.waits + 1);
    auto const& now = device::counts();
    CHECK(now.allocations == warm.allocations);
    CHECK(now.releases == warm.releases);
    CHECK(now.graphs == warm.graphs);
    CHECK(now.graph_launches == warm.graph_launches + 9);
}

TEST_CASE("a thousand frames take no more memory and no more graphs than the first ones") {
    CudaGraphs graphs;
    Emulated const executor{{.graphs = &graphs}};
    auto history = history_of(clamped);
    auto frame = uploaded(clamped, {.number = 0, .width = 9, .height = 5}, executor.cuda);
    auto const run_frames = [&](int count) {
        for (int i = 0; i < count; ++i, ++*frame.number) {
            run(clamped, frame, history, executor);
            executor.cuda.synchronize();
        }
    };
    run_frames(10);
    auto const warm = device::counts();
    run_frames(1000);
    CHECK(device::counts().bytes == warm.bytes);
    CHECK(device::counts().allocations == warm.allocations);
    CHECK(device::counts().graphs == warm.graphs);
}

TEST_CASE("what stands behind a pipeline waits for nothing, and is on its way when run() returns") {
    constexpr auto denoise = presets::resolve(presets::surface(radiance));
    CudaGraphs graphs;
    std::vector<std::vector<float>> pictures;
    for (bool const by_graph : {false, true}) {
        Emulated const executor{{.graphs = by_graph ? &graphs : nullptr}};
        History history{{90, 50}, denoise, Device<>{}};
        Frame rendered{{45, 25}, denoise};
        Frame frame{rendered.size, denoise, Device<>{}};
        auto const waits = [&](int number) {
            tests::fill_randomly(rendered, static_cast<unsigned>(number));
            for_each_channel(typename decltype(frame)::channels{}, [&](auto c) { upload(frame[c], rendered[c], executor.cuda); });
            frame.number = number;
            int const before = device::counts().waits;
            auto const view = run(denoise, frame, history, executor);
            int const during = device::counts().waits - before;
            cudaStreamSynchronize(nullptr); // not the executor, which could put more in
            int const kernels = device::counts().kernels;
            pictures.push_back(tests::copy_of(download(view, executor.cuda).view()));
            CHECK(device::counts().kernels == kernels);
            return during;
        };
        constexpr int warm = 12; // all frames that are looked back at have their images
        for (int i = 0; i < warm; ++i) waits(i);
        CHECK(waits(warm) == 0);
    }
    for (std::size_t i = 0; i < 13; ++i) CHECK(pictures[i] == pictures[i + 13]);
}

TEST_CASE("histories in two streams do not disturb each other") {
    auto const expected = device::by_serial(1);
    cudaStream_t streams[2] = {};
    for (auto& each : streams) cudaStreamCreate(&each);
    {
        auto one = history_of(clamped), two = history_of(clamped);
        Emulated const in_first{{.stream = streams[0]}}, in_second{{.stream = streams[1]}};
        for (std::size_t i = 0; i < 3; ++i) {
            auto const frame = uploaded(clamped, device::steps[i], {});
            auto const first = run(clamped, frame, one, in_first), second = run(clamped, frame, two, in_second);
            CHECK(device::result_of(one, download(first, in_first.cuda).view()) == expected[i]);
            CHECK(device::result_of(two, download(second, in_second.cuda).view()) == expected[i]);
        }
    }
    for (auto& each : streams) cudaStreamDestroy(each);
}

TEST_CASE("a host's own pass runs before the frame that it makes, in a graph too, or at once where it waits") {
    CudaGraphs graphs;
    std::vector<std::vector<float>> pictures;
    for (bool const by_graph : {false, true}) {
        Emulated const executor{{.graphs = by_graph ? &graphs : nullptr}};
        for (bool const waits : {false, true}) {
            auto history = history_of(clamped);
            auto frame = uploaded(clamped, device::steps[0], executor.cuda);
            Shine const shine{frame[radiance].view()};
            Region const all{0, 0, frame.size.width, frame.size.height};
            auto const before = device::counts().kernels;
            if (waits) {
                executor.for_each_pixel(all, shine);
                CHECK(device::counts().kernels == before + 1);
            } else {
                executor.enqueue(all, shine);
                CHECK(device::counts().kernels == before);
            }
            auto const view = run(clamped, frame, history, executor);
            pictures.push_back(device::result_of(history, download(view, executor.cuda).view()).picture);
        }
    }
    CHECK(pictures[0][5 * 3 + 1] > 5.f);
    for (auto const& each : pictures) CHECK(each == pictures[0]);
}

TEST_CASE("a launch that fails is an Error with the pass's name, and the next frame starts anew") {
    auto const expected = device::by_serial(1);
    CudaGraphs graphs;
    auto const other = uploaded(clamped, device::steps[4], {}), first = uploaded(clamped, device::steps[0], {}),
               second = uploaded(clamped, device::steps[1], {});
    auto const fails = [&](Emulated const& executor, char const* call, int after) {
        auto history = history_of(clamped);
        auto const picture_of = [&](auto const& frame) {
            auto const view = run(clamped, frame, history, executor);
            return device::result_of(history, download(view, executor.cuda).view()).picture;
        };
        picture_of(other);
        history.forget();
        device::fail(call, after, cudaErrorLaunchOutOfResources);
        auto const said = tests::message([&] { picture_of(first); });
        device::restart();
        CHECK(cudaGetLastError() == cudaSuccess);
        CHECK(picture_of(first) == expected[0].picture);
        CHECK(picture_of(second) == expected[1].picture);
        return said;
    };
    auto const with = [](std::string const& pass) {
        return "pass '" + pass + "' on the device: too many resources requested for launch; compile for this device's architecture";
    };
    CHECK(fails({}, "cudaLaunchKernel", 0) == with("ingest"));
    CHECK(fails({}, "cudaLaunchKernel", 1) == with("temporal"));
    CHECK(fails({}, "cudaLaunchCooperativeKernel", 0) == with("completion of ingest"));
    CHECK(fails({{.graphs = &graphs}}, "cudaGraphLaunch", 0) == with("of a graph"));
}

TEST_CASE("a graph that refuses changed arguments is made anew, and the frame is whole") {
    auto const expected = device::by_serial(1);
    CudaGraphs graphs;
    Emulated const executor{{.graphs = &graphs}};
    auto history = history_of(clamped);
    for (std::size_t i = 0; i < 4; ++i) {
        auto const before = device::counts();
        // Of the graph with a past, which the third frame has from the second; the first pass or one behind it.
        if (i > 1) device::fail("cudaGraphExecKernelNodeSetParams", i == 2 ? 0 : 2, cudaErrorInvalidValue);
        CHECK(run_step(clamped, device::steps[i], history, executor) == expected[i]);
        CHECK(cudaGetLastError() == cudaSuccess);
        if (i > 1) CHECK(device::counts().graphs == before.graphs + 1);
        device::restart();
    }
    // Where a new one can't be made either, the pass is named.
    device::fail("cudaGraphExecKernelNodeSetParams", 2, cudaErrorInvalidValue);
    device::fail("cudaGraphInstantiate", 0, cudaErrorMemoryAllocation);
    CHECK(tests::message([&] { run_step(clamped, device::steps[3], history, executor); }) ==
          "pass 'temporal' on the device: out of memory; use smaller images or Float16");
    device::restart();
}

TEST_CASE("where memory is short at any place, the history can be used again, and nothing of the frame runs behind its end") {
    auto const expected = device::by_serial(1);
    for (bool const by_graph : {false, true}) {
        CudaGraphs graphs;
        Emulated const executor{{.graphs = by_graph ? &graphs : nullptr}};
        auto const frame = uploaded(clamped, device::steps[0], executor.cuda);
        auto const plane = frame[depth].bytes();
        int failed = 0;
        for (std::size_t room = 0;; room += plane) {
            auto const held = device::counts().bytes;
            std::string said;
            for (bool const again : {false, true}) {
                {
                    auto history = history_of(clamped);
                    device::limit_memory(held + room);
                    said = tests::message([&] { run(clamped, frame, history, executor); });
                    device::limit_memory(std::numeric_limits<std::size_t>::max());
                    CHECK(cudaGetLastError() == cudaSuccess);
                    if (again) CHECK(run_step(clamped, device::steps[0], history, executor).picture == expected[0].picture);
                }
                executor.cuda.synchronize(); // the history's memory is gone
            }
            CHECK(device::counts().bytes == held);
            if (said == "nothing thrown") break;
            CHECK(said.find("device memory of ") == 0);
            CHECK(said.find(": out of memory; use smaller images or Float16") != std::string::npos);
            ++failed;
        }
        CHECK(failed > 3);
    }
    device::fail("cudaMallocManaged", 0, cudaErrorMemoryAllocation);
    CHECK(tests::message([] { ManagedMemory::allocate(64); }) ==
          "managed memory of 64 bytes: out of memory; use smaller images or Float16");
    CHECK(cudaGetLastError() == cudaSuccess);
}

TEST_CASE("a fault of the device is told where the host waits next, and that the context is lost") {
    Emulated const executor;
    auto history = history_of(clamped);
    auto frame = uploaded(clamped, device::steps[0], executor.cuda);
    for (int i = 0; i < 3; ++i, ++*frame.number) run(clamped, frame, history, executor);
    device::break_device();
    auto const picture = run(clamped, frame, history, executor); // nothing waits
    auto const said = tests::message([&] { download(picture, executor.cuda); });
    CHECK(said ==
          "pass 'of the frames before' on the device or one before it: an illegal memory access was encountered; the device's context "
          "is lost: start the program again, with frame, history and target in memory that the device can reach: Device<> or "
          "Managed<>");
    CHECK(tests::message([&] { run(clamped, frame, history, executor); }).find("context is lost") != std::string::npos);
    CHECK(tests::message([&] { DeviceMemory::clear(nullptr, 0); }).find("context is lost") != std::string::npos);
    device::restart();
}
