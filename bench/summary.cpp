#include "summary.hpp"

#include "allocations.hpp"
#include "family.hpp"

#include <algorithm>
#include <cstdio>

namespace quell::bench {
namespace {

constexpr Extent size{1920, 1080};
constexpr auto reference_storage = "planar-float";

double median(std::vector<double> values) {
    if (values.empty()) return 0.;
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The frames of one executor: seconds of each, seconds of each pass in each, what was allocated.
struct Series {
    How how;
    std::vector<double> wall;
    std::vector<double> processor;
    std::vector<std::vector<double>> passes;
    long long allocated = 0;

    void add(Workload& work) {
        auto const before = allocations();
        auto const frame = work.next(how);
        allocated += allocations() - before;
        wall.push_back(frame.wall);
        processor.push_back(frame.processor);
        passes.resize(work.passes().size());
        for (std::size_t i = 0; i < passes.size(); ++i) passes[i].push_back(work.passes()[i].processor);
    }
};

/// Median over the rounds of how many times longer `slow` took than `fast`.
double ratio(std::vector<double> const& slow, std::vector<double> const& fast) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < slow.size() && i < fast.size(); ++i) ratios.push_back(slow[i] / fast[i]);
    return median(ratios);
}

std::vector<Series> alternate(Family const& family, std::vector<How> const& executors, int rounds) {
    auto& work = workload(family, size);
    std::vector<Series> all;
    for (auto const how : executors) all.push_back({how, {}, {}, {}, 0});
    // The first round settles what is cached and which threads exist.
    for (auto const& series : all)
        if (series.how.kind != How::Kind::serial) work.next(series.how);
    for (int i = 0; i < rounds; ++i)
        for (auto& series : all) series.add(work);
    return all;
}

void print_machine() {
    std::printf("## Machine\n| threads | GFLOP/s | GB/s |\n| --- | --- | --- |\n");
    for (int const threads : {1, most_threads()}) {
        auto const& m = machine(threads);
        std::printf("| %d | %.1f | %.1f |\n", threads, 1e-9 * m.operations_per_second, 1e-9 * m.bytes_per_second);
        if (most_threads() == 1) break;
    }
}

void print_preset(Family const& family, std::vector<Series> const& s, double bytes) {
    auto const& serial = s[0];
    auto const& simd = s[1];
    auto const& one = s[2];
    auto const& many = s[3];
    auto const ms = [](Series const& series) { return 1e3 * median(series.wall); };
    std::printf("| %s | %.1f | %.2f | %.2f | %.2f | %.2f | %.2f | %.1f | %.2f | %.2f | %.2f | %.2f | %.1f | %lld |\n",
                family.preset.c_str(), ms(serial), ms(simd), 1e3 * median(simd.processor), ms(one), ms(many),
                1e3 * *std::ranges::min_element(many.wall), ratio(serial.processor, simd.processor), ratio(one.wall, many.wall),
                many.how.threads * ratio(one.processor, many.processor), family.bound(size, 1) / median(simd.processor),
                family.bound(size, many.how.threads) / median(many.wall), bytes, simd.allocated);
}

void print_passes(Family const& family, Series const& simd) {
    for (std::size_t i = 0; i < family.passes.size(); ++i) {
        double const seconds = median(simd.passes[i]), bound = family.bound(i, size, 1);
        auto const cost = family.cost(i);
        auto const pixels = static_cast<double>(size.pixels());
        std::printf("| %s | %s | %.2f | %.2f | %.2f | %.0f | %.0f | %.1f | %.1f |\n", family.preset.c_str(), family.passes[i].c_str(),
                    1e3 * seconds, 1e3 * bound, bound / seconds, cost.operations, cost.bytes(family.stored_size),
                    1e-9 * cost.operations * pixels / seconds, 1e-9 * cost.bytes(family.stored_size) * pixels / seconds);
    }
}

struct Measured {
    Family family;
    std::vector<Series> series;
    double bytes;
};

std::vector<Measured> measure(std::string_view wanted, int rounds) {
    std::vector<Measured> all;
    int const most = most_threads();
    for (auto const& family : families()) {
        if (!wanted.empty() && family.preset != wanted) continue;
        std::vector<How> const executors =
            family.has_serial
                ? std::vector<How>{{How::Kind::serial, 1}, {How::Kind::simd, 1}, {How::Kind::threads, 1}, {How::Kind::threads, most}}
                : std::vector<How>{{How::Kind::simd, 1}, {How::Kind::threads, most}};
        std::fprintf(stderr, "measuring %s %s\n", family.preset.c_str(), family.storage.c_str());
        auto series = alternate(family, executors, rounds);
        all.push_back({family, std::move(series), workload(family, size).bytes_per_pixel()});
    }
    return all;
}

void print_storages(std::vector<Measured> const& all) {
    std::printf("\n## Storages, %s\n| preset | storage | simd ms | threads:%d ms | bytes/pixel | allocations |\n| --- | --- | --- | --- "
                "| --- | --- |\n",
                to_string(size).c_str(), most_threads());
    for (auto const& m : all) {
        auto const& simd = m.series[m.family.has_serial ? 1 : 0];
        std::printf("| %s | %s | %.2f | %.2f | %.1f | %lld |\n", m.family.preset.c_str(), m.family.storage.c_str(),
                    1e3 * median(simd.processor), 1e3 * median(m.series.back().wall), m.bytes, simd.allocated);
    }
}

} // namespace

void print_summary(std::string_view wanted, int rounds) {
    print_machine();
    auto const all = measure(wanted, rounds);
    std::printf("\n## Presets, %s, %s, medians of %d; cpu: processor time, which others on the machine hardly lengthen\n",
                to_string(size).c_str(), reference_storage, rounds);
    std::printf(
        "| preset | serial ms | simd ms | simd cpu ms | threads:1 ms | threads:%d ms | best | serial/simd | threads 1/%d | the same by cpu "
        "| of bound, simd "
        "| of "
        "bound, threads | bytes/pixel | allocations (simd) |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- "
        "| --- |\n",
        most_threads(), most_threads());
    for (auto const& m : all)
        if (m.family.has_serial) print_preset(m.family, m.series, m.bytes);
    std::printf(
        "\n## Passes, simd, %s, processor time\n| preset | pass | ms | bound ms | of bound | flop/pixel | bytes/pixel | GFLOP/s | GB/s "
        "|\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        reference_storage);
    for (auto const& m : all)
        if (m.family.has_serial) print_passes(m.family, m.series[1]);
    print_storages(all);
}

} // namespace quell::bench
