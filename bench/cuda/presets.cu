#include "layout.cuh"
#include "measured.hpp"
#include "scene.hpp"

#include <baselines/named.hpp>
#include <quell/execute/cuda.cuh>
#include <quell/execute/device.cuh>
#include <quell/presets/by_evidence.hpp>

#include <library/preset_share.hpp>

#include <chrono>

// Compiled several times, with other UNITs of UNITS, so that presets are compiled side by side.
namespace quell::bench {

inline void check(cudaError_t status) {
    if (status != cudaSuccess) raise_error("quell-cuda", cudaGetErrorString(status), "see whether the driver is as new as CUDA");
}

/// Cuda, or Cuda with the time of each pass: one type, so that what runs a preset is compiled once.
struct Chosen {
    Cuda cuda{};
    std::vector<PassCost>* passes = nullptr;
    cudaEvent_t begin = nullptr, end = nullptr;

    template <class Job> void for_each_pixel(Region r, Job const& job) const { cuda.for_each_pixel(r, job); }
    template <class Job> void enqueue(Region r, Job const& job) const {
        static_cast<void>(is_listed<Job>);
        timed(job.name, quell::detail::each_pixel<Job>, [&] { cuda.enqueue(r, job); });
    }
    template <class Work> void enqueue_grid(Region r, Work const& work) const {
        timed(work.name, quell::detail::whole_grid<Work>, [&] { cuda.enqueue_grid(r, work); });
    }
    void submit() const { cuda.submit(); }
    void drop() const { cuda.drop(); }
    void clear(void* memory, std::size_t bytes) const { cuda.clear(memory, bytes); }
    void read(void* to, void const* from, std::size_t bytes) const { cuda.read(to, from, bytes); }

private:
    void timed(char const* name, auto* kernel, auto&& launch) const {
        if (!passes) return launch();
        float milliseconds = 0;
        check(cudaEventRecord(begin));
        launch();
        check(cudaEventRecord(end));
        check(cudaEventSynchronize(end));
        check(cudaEventElapsedTime(&milliseconds, begin, end));
        cudaFuncAttributes attributes{};
        check(cudaFuncGetAttributes(&attributes, kernel));
        passes->push_back({name, milliseconds, attributes.numRegs, attributes.localSizeBytes});
    }
};

using Input = Frame<Sample::channels>;
using DeviceInput = Frame<Sample::channels, Device<>>;

inline void upload_frame(DeviceInput& to, Input const& from) {
    for_each_channel(Sample::channels{}, [&](auto c) { upload(to[c], from[c]); });
    to.camera = from.camera;
}
/// What all presets read. Made once for all: only the last size asked for is kept.
inline std::vector<DeviceInput>& input(Extent size) {
    static std::vector<DeviceInput> made;
    if (!made.empty() && made[0].size == size) return made;
    made.clear();
    Input frame(size);
    for (int i = 0; i < 2; ++i) {
        fill_frame(frame, i);
        upload_frame(made.emplace_back(size), frame);
    }
    return made;
}

template <class Preset> Agreement agreement(int width, int height, int frames) {
    auto const denoise = Preset::usual();
    Input frame({width, height});
    DeviceInput on_device(frame.size);
    History by_host{frame.size, denoise};
    History by_device{frame.size, denoise, Device<>{}};
    CudaGraphs graphs;
    Agreement found;
    long long components = 0, apart = 0;
    for (int i = 0; i < frames; ++i) {
        fill_frame(frame, i);
        if (i == 3) spoil(frame);
        upload_frame(on_device, frame);
        auto const a = run(denoise, frame, by_host, Serial{});
        Chosen chosen;
        if (i > 1) chosen.cuda.graphs = &graphs;
        auto const b = download(run(denoise, on_device, by_device, chosen), chosen.cuda);
        for (int y = 0; y < a.size.height; ++y)
            for (int x = 0; x < a.size.width; ++x)
                for (int c = 0; c < a.components; ++c, ++components) {
                    double const expected = a.get(c, x, y);
                    double const difference = std::abs(b.get(c, x, y) - expected) / std::max(1., std::abs(expected));
                    if (!(difference <= Agreement::allowed)) ++apart;
                    if (!(difference <= found.worst)) found.worst = difference;
                }
        auto const expected = by_host.statistics(), counted = by_device.statistics();
        found.counts_equal = found.counts_equal && expected.missing_samples == counted.missing_samples &&
                             expected.repaired_guides.pixels == counted.repaired_guides.pixels;
    }
    found.apart = static_cast<double>(apart) / static_cast<double>(components);
    return found;
}

inline double now() { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Of the frames after the first few, in which memory is allocated.
template <class Preset> Cost cost(int width, int height, int rounds) {
    auto const& frames = input({width, height});
    auto const denoise = Preset::usual();
    History history{frames[0].size, denoise, Device<>{}};
    auto const run_frames = [&](int count, Chosen const& chosen, auto&& behind_each) {
        for (int i = 0; i < count; ++i) {
            run(denoise, frames[static_cast<std::size_t>(i) % frames.size()], history, chosen);
            behind_each();
        }
    };
    auto const nothing = [] {};
    Cuda const cuda;
    run_frames(6, Chosen{}, nothing);
    cuda.synchronize();

    Cost found;
    double begun = now();
    run_frames(rounds, Chosen{}, [&] { cuda.synchronize(); });
    found.milliseconds = (now() - begun) / rounds;
    begun = now();
    run_frames(rounds, Chosen{}, nothing);
    found.host_milliseconds = (now() - begun) / rounds;
    cuda.synchronize();
    found.milliseconds_in_row = (now() - begun) / rounds;

    CudaGraphs graphs;
    Chosen by_graph;
    by_graph.cuda.graphs = &graphs;
    run_frames(6, by_graph, nothing);
    cuda.synchronize();
    begun = now();
    run_frames(rounds, by_graph, nothing);
    found.graph_host_milliseconds = (now() - begun) / rounds;
    cuda.synchronize();
    found.graph_milliseconds_in_row = (now() - begun) / rounds;

    std::vector<PassCost> all;
    Chosen timed{.passes = &all};
    check(cudaEventCreate(&timed.begin));
    check(cudaEventCreate(&timed.end));
    run_frames(rounds, timed, nothing);
    check(cudaEventDestroy(timed.begin));
    check(cudaEventDestroy(timed.end));
    // Every frame has the same passes.
    std::size_t const passes = all.size() / static_cast<std::size_t>(rounds);
    found.passes.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(passes));
    for (std::size_t i = passes; i < all.size(); ++i) found.passes[i % passes].milliseconds += all[i].milliseconds;
    for (auto& pass : found.passes) pass.milliseconds /= rounds;
    return found;
}

/// A choice of history by evidence, which has passes that no preset has.
struct ClampByEvidence {
    static constexpr auto usual() { return presets::by_evidence(presets::surface_clamp(radiance, Demodulate{})); }
};

constexpr auto is_usual = [](auto const& preset) { return preset.group != PresetGroup::published; };

static bool list_presets() {
    for_each_preset_index(all_presets, [](auto i) {
        if constexpr (is_usual(std::get<i>(all_presets)))
            if constexpr (quell_library::share_of_preset<UNITS>(i, is_usual) == UNIT) {
                using Preset = std::remove_cvref_t<decltype(std::get<i>(all_presets))>;
                measured_presets().push_back({std::string(std::get<i>(all_presets).name), i, agreement<Preset>, cost<Preset>});
            }
    });
    if constexpr (UNIT == 0)
        measured_presets().push_back(
            {"surface-clamp by evidence", std::tuple_size_v<decltype(all_presets)>, agreement<ClampByEvidence>, cost<ClampByEvidence>});
    return true;
}
static bool const listed = list_presets();

} // namespace quell::bench
