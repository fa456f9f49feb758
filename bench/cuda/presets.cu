#include "layout.cuh"
#include "measured.hpp"
#include "scene.hpp"

#include <quell/execute/cuda.cuh>
#include <quell/image/managed.cuh>
#include <quell/presets/named.hpp>

#include <chrono>

// Compiled several times, with other UNITs of UNITS, so that presets are compiled side by side.
namespace quell::bench {

inline void check(cudaError_t status) {
    if (status != cudaSuccess) raise_error("quell-cuda", cudaGetErrorString(status), "see whether the driver is as new as CUDA");
}

/// Serial, Cuda, or Cuda with the time of each pass: one type, so that what runs a preset is compiled once.
struct Chosen {
    bool on_device = true;
    std::vector<PassCost>* passes = nullptr;
    cudaEvent_t begin = nullptr, end = nullptr;

    template <class Job> void for_each_pixel(Region r, Job const& job) const {
        static_cast<void>(is_listed<Job>);
        if (!on_device)
            Serial{}.for_each_pixel(r, job);
        else if (!passes)
            Cuda{}.for_each_pixel(r, job);
        else
            passes->push_back(cost_of(r, job));
    }

private:
    template <class Job> PassCost cost_of(Region r, Job const& job) const {
        float milliseconds = 0;
        check(cudaEventRecord(begin));
        Cuda{}.launch(r, job);
        check(cudaEventRecord(end));
        check(cudaEventSynchronize(end));
        check(cudaEventElapsedTime(&milliseconds, begin, end));
        cudaFuncAttributes kernel{};
        check(cudaFuncGetAttributes(&kernel, quell::detail::each_pixel<Job>));
        return {job.name, milliseconds, kernel.numRegs, kernel.localSizeBytes};
    }
};

/// What all presets read. Made once for all: only the last size asked for is kept.
using Input = Frame<Sample::channels, Managed<>>;
inline std::vector<Input>& input(Extent size) {
    static std::vector<Input> made;
    if (!made.empty() && made[0].size == size) return made;
    made.clear();
    for (int i = 0; i < 2; ++i) fill_frame(made.emplace_back(size), i);
    return made;
}

template <class Preset> Agreement agreement(int width, int height, int frames) {
    auto const denoise = Preset::usual();
    Input frame({width, height});
    History by_host{frame.size, denoise, Managed<>{}}, by_device{frame.size, denoise, Managed<>{}};
    Agreement found;
    long long components = 0, apart = 0;
    for (int i = 0; i < frames; ++i) {
        fill_frame(frame, i);
        auto const a = run(denoise, frame, by_host, Chosen{.on_device = false}), b = run(denoise, frame, by_device, Chosen{});
        for (int y = 0; y < a.size.height; ++y)
            for (int x = 0; x < a.size.width; ++x)
                for (int c = 0; c < a.components; ++c, ++components) {
                    double const expected = a.get(c, x, y);
                    double const difference = std::abs(b.get(c, x, y) - expected) / std::max(1., std::abs(expected));
                    if (!(difference <= Agreement::allowed)) ++apart;
                    if (!(difference <= found.worst)) found.worst = difference;
                }
        found.counts_equal = found.counts_equal && by_host.statistics().missing_samples == by_device.statistics().missing_samples;
    }
    found.apart = static_cast<double>(apart) / static_cast<double>(components);
    return found;
}

inline double now() { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Of the frames after the first few, in which memory is allocated and comes to the device.
template <class Preset> Cost cost(int width, int height, int rounds) {
    auto const& frames = input({width, height});
    auto const denoise = Preset::usual();
    History history{frames[0].size, denoise, Managed<>{}};
    auto const run_frames = [&](int count, Chosen const& chosen) {
        for (int i = 0; i < count; ++i) run(denoise, frames[static_cast<std::size_t>(i) % frames.size()], history, chosen);
    };
    run_frames(6, Chosen{});
    double const begun = now();
    run_frames(rounds, Chosen{});
    Cost found{.milliseconds = (now() - begun) / rounds, .passes = {}};

    std::vector<PassCost> all;
    Chosen timed{.passes = &all};
    check(cudaEventCreate(&timed.begin));
    check(cudaEventCreate(&timed.end));
    run_frames(rounds, timed);
    check(cudaEventDestroy(timed.begin));
    check(cudaEventDestroy(timed.end));
    // Every frame has the same passes.
    std::size_t const passes = all.size() / static_cast<std::size_t>(rounds);
    found.passes.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(passes));
    for (std::size_t i = passes; i < all.size(); ++i) found.passes[i % passes].milliseconds += all[i].milliseconds;
    for (auto& pass : found.passes) pass.milliseconds /= rounds;
    return found;
}

static bool list_presets() {
    for_each_preset_index<UNIT, UNITS>([](auto i) {
        if constexpr (std::get<i>(named_presets).group != PresetGroup::published) {
            using Preset = std::remove_cvref_t<decltype(std::get<i>(named_presets))>;
            measured_presets().push_back({std::string(std::get<i>(named_presets).name), i, agreement<Preset>, cost<Preset>});
        }
    });
    return true;
}
static bool const listed = list_presets();

} // namespace quell::bench
