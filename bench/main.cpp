// quell-bench: how fast presets and their passes are on this machine.
//
//   quell-bench --benchmark_list_tests                                    what there is
//   quell-bench --benchmark_filter='^svgf/1920x1080/planar-float/'        whole frames; also pass/svgf/..., smoke/...
//   quell-bench --benchmark_filter='^pass/svgf/.*planar-float/simd' --benchmark_repetitions=5 --benchmark_report_aggregates_only
//   quell-bench --device=cuda                                             whole frames on a GPU, whose images are copied there and back
//   quell-bench --summary[=svgf] [--rounds=5]                             tables that compare executors in turn; no single benchmarks
//
// All other flags are Google Benchmark's own (--help). Names are PRESET/SIZE/STORAGE/EXECUTOR; the storage is the history's,
// planar floats as the frame. Histories are warm: no benchmark times a first frame.
// Counters: ms/frame and pixels/s by the clock on the wall; bytes/pixel of history and scratch; allocations/frame by operator new, which is
// 0 for quell itself (see --summary, executor simd).

#include "benchmarks.hpp"
#include "family.hpp"
#include "summary.hpp"

#include <quell/core/error.hpp>

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace {

/// What follows `--name=`, "" for `--name` alone; takes the argument away from Google Benchmark, which rejects what it doesn't know.
std::optional<std::string> take_flag(int& count, char** arguments, std::string const& name) {
    std::optional<std::string> found;
    int kept = 1;
    for (int i = 1; i < count; ++i) {
        std::string const argument = arguments[i];
        if (argument == name)
            found = "";
        else if (argument.starts_with(name + "="))
            found = argument.substr(name.size() + 1);
        else
            arguments[kept++] = arguments[i];
    }
    count = kept;
    arguments[count] = nullptr;
    return found;
}

/// @throws quell::Error for anything but a number of rounds
int rounds_in(std::string const& text) {
    int rounds = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), rounds);
    if (error == std::errc{} && end == text.data() + text.size() && rounds >= 1) return rounds;
    throw quell::Error("--rounds", "'" + text + "'", "give a number of 1 or more, as in --rounds=5");
}
/// The presets that are measured.
/// @throws quell::Error for another device, or one that the program was not built for
std::vector<quell::bench::Family> families_on(std::string const& device) {
    if (device == "cuda") return quell::bench::cuda_families();
    if (device == "cpu") return quell::bench::families();
    throw quell::Error("--device", "there is no '" + device + "'", "choose one of: cpu, cuda");
}
/// @throws quell::Error for a preset that isn't measured
void check_summary(std::string const& preset) {
    std::vector<std::string> names;
    for (auto const& family : quell::bench::families()) {
        if (preset.empty() || family.preset == preset) return;
        names.push_back(family.preset);
    }
    throw quell::Error("--summary", "there is no preset '" + preset + "'", fmt::format("choose one of: {}", fmt::join(names, ", ")));
}

} // namespace

int main(int count, char** arguments) {
    using namespace quell::bench;
    if (std::any_of(arguments + 1, arguments + count, [](char const* word) { return std::string_view(word) == "--help"; }))
        std::puts("quell-bench [--summary[=PRESET]]   tables that compare executors in turn, in place of single benchmarks\n"
                  "            [--rounds=N]           how often they measure (5)\n"
                  "            [--device=DEVICE]      cpu, or cuda: whole frames on an NVIDIA GPU, where it was built for it (cpu)\n"
                  "Names of benchmarks are PRESET/SIZE/STORAGE/EXECUTOR. All other flags are Google Benchmark's:\n");
    auto const summary = take_flag(count, arguments, "--summary");
    auto const rounds = take_flag(count, arguments, "--rounds");
    auto const device = take_flag(count, arguments, "--device").value_or("cpu");
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
    try {
        auto const measured = families_on(device);
        if (summary) {
            if (device != "cpu") throw quell::Error("--summary", "it compares executors of a CPU", "leave --device out");
            check_summary(*summary);
            print_summary(*summary, rounds ? rounds_in(*rounds) : 5);
            return 0;
        }
        register_benchmarks(measured);
        benchmark::RunSpecifiedBenchmarks(); // which throw where there is no GPU
    } catch (quell::Error const& error) {
        std::fprintf(stderr, "quell-bench: %s\n", error.what());
        return 2;
    }
    benchmark::Shutdown();
    return 0;
}
