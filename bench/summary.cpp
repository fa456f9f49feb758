#include "summary.hpp"

#include "allocations.hpp"
#include "family.hpp"

#include <fmt/format.h>
#include <support/median.hpp>

#include <algorithm>
#include <cmath>

namespace quell::bench {
namespace {

constexpr Extent size{1920, 1080};

using examples::median;

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
    for (auto const& series : all) work.next(series.how);
    for (int i = 0; i < rounds; ++i)
        for (auto& series : all) series.add(work);
    return all;
}

/// A preset, and the frames of each executor.
struct Measured {
    Family family;
    std::vector<Series> series;
    double bytes;

    [[nodiscard]] Series const& series_of(How how) const {
        return *std::ranges::find_if(series, [&](auto const& each) { return each.how.name() == how.name(); });
    }
};

/// A row of a table in Markdown.
void print_row(std::initializer_list<std::string> cells) { fmt::print("| {} |\n", fmt::join(cells, " | ")); }
void print_head(std::initializer_list<std::string> cells) {
    print_row(cells);
    fmt::print("|{}\n", fmt::join(std::vector<std::string>(cells.size(), " --- |"), ""));
}
std::string number(double value, int digits) { return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-"; }

void print_presets_head(int rounds) {
    auto const most = std::to_string(max_threads());
    fmt::print("\n## Presets, {}, {}, medians of {}; cpu: processor time, which others on the machine hardly lengthen\n", to_string(size),
               usual_storage, rounds);
    print_head({"preset", "simd ms", "simd cpu ms", "threads:1 ms", "threads:" + most + " ms", "best", "threads:1/simd",
                "threads 1/" + most, "the same by cpu", "bytes/pixel", "allocations (simd)"});
}

void print_preset(Measured const& m) {
    auto const &simd = m.series_of({How::Kind::simd, 1}), &one = m.series_of({How::Kind::threads, 1}), &many = m.series.back();
    auto const ms = [](std::vector<double> const& seconds) { return number(1e3 * median(seconds), 2); };
    print_row({m.family.preset, ms(simd.wall), ms(simd.processor), ms(one.wall), ms(many.wall),
               number(1e3 * *std::ranges::min_element(many.wall), 2), number(ratio(one.processor, simd.processor), 3),
               number(ratio(one.wall, many.wall), 2), number(many.how.threads * ratio(one.processor, many.processor), 2),
               number(m.bytes, 1), std::to_string(simd.allocated)});
}

void print_passes_head() {
    fmt::print("\n## Passes, simd, {}, processor time\n", usual_storage);
    print_head({"preset", "pass", "ms"});
}

void print_passes(Family const& family, Series const& simd) {
    for (std::size_t i = 0; i < family.passes.size(); ++i)
        print_row({family.preset, family.passes[i], number(1e3 * median(simd.passes[i]), 2)});
}

std::vector<Measured> measure(std::string_view wanted, int rounds) {
    std::vector<Measured> all;
    int const most = max_threads();
    for (auto const& family : families()) {
        if (!wanted.empty() && family.preset != wanted) continue;
        fmt::print(stderr, "measuring {}\n", family.preset);
        auto series = alternate(family, {{How::Kind::simd, 1}, {How::Kind::threads, 1}, {How::Kind::threads, most}}, rounds);
        all.push_back({family, std::move(series), workload(family, size).bytes_per_pixel()});
    }
    return all;
}

} // namespace

void print_summary(std::string_view wanted, int rounds) {
    auto const all = measure(wanted, rounds);
    print_presets_head(rounds);
    for (auto const& m : all) print_preset(m);
    print_passes_head();
    for (auto const& m : all) print_passes(m.family, m.series_of({How::Kind::simd, 1}));
}

} // namespace quell::bench
