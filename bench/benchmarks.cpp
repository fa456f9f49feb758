#include "benchmarks.hpp"

#include "allocations.hpp"
#include "family.hpp"

#include <benchmark/benchmark.h>

namespace quell::bench {
namespace {

constexpr Extent sizes[] = {{1280, 720}, {1920, 1080}};
constexpr Extent smoke_size{96, 54};

/// Threads 1, 2, 4, ... and as many as there are.
std::vector<How> executors(Family const& family) {
    if (family.storage == cuda_storage) return {{How::Kind::threads, max_threads()}}; // which copy images
    std::vector<How> all;
    all.push_back({How::Kind::simd});
    for (int n = 1; n < max_threads(); n *= 2) all.push_back({How::Kind::threads, n});
    all.push_back({How::Kind::threads, max_threads()});
    return all;
}

/// The counters that do not depend on how long it took come first.
void report(benchmark::State& state, Workload const& work, Extent size, double seconds) {
    auto const frames = static_cast<double>(state.iterations()), pixels = static_cast<double>(size.pixels());
    state.counters["bytes/pixel"] = work.bytes_per_pixel();
    state.counters["ms/frame"] = 1e3 * seconds / frames;
    state.counters["pixels/s"] = pixels * frames / seconds;
}

void run_preset(benchmark::State& state, Family const& family, Extent size, How how) {
    auto& work = workload(family, size);
    double seconds = 0.;
    long long allocated = 0;
    for (auto _ : state) {
        auto const before = allocations();
        auto const frame = work.next(how);
        allocated += allocations() - before;
        seconds += frame.wall;
    }
    report(state, work, size, seconds);
    state.counters["allocations/frame"] = static_cast<double>(allocated) / static_cast<double>(state.iterations());
}

void run_pass(benchmark::State& state, Family const& family, std::size_t pass, Extent size, How how) {
    auto& work = workload(family, size);
    double seconds = 0.;
    for (auto _ : state) {
        work.next(how);
        auto const taken = work.passes()[pass].wall;
        state.SetIterationTime(taken);
        seconds += taken;
    }
    report(state, work, size, seconds);
}

void register_preset(Family const& family, Extent size, How how) {
    auto const name = family.preset + "/" + to_string(size) + "/" + family.storage + "/" + how.name();
    auto* const made = benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run_preset(state, family, size, how); });
    made->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

void register_passes(Family const& family, Extent size, How how) {
    for (std::size_t i = 0; i < family.passes.size(); ++i) {
        auto const name =
            "pass/" + family.preset + "/" + family.passes[i] + "/" + to_string(size) + "/" + family.storage + "/" + how.name();
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run_pass(state, family, i, size, how); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(5);
    }
}

void register_size(std::vector<Family> const& all, Extent size) {
    for (auto const& family : all)
        for (auto const how : executors(family)) {
            register_preset(family, size, how);
            register_passes(family, size, how);
        }
}

} // namespace

void register_benchmarks(std::vector<Family> const& all) {
    for (auto const size : sizes) register_size(all, size);
    for (auto const& family : all)
        benchmark::RegisterBenchmark(("smoke/" + family.preset).c_str(), [=](benchmark::State& state) {
            run_preset(state, family, smoke_size, {How::Kind::threads, max_threads()});
        })->Iterations(1);
}

} // namespace quell::bench
