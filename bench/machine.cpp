#include "machine.hpp"

#include <quell/core/real.hpp>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <ctime>
#include <map>
#include <thread>
#include <vector>

namespace quell::bench {
namespace {

/// Of this thread alone: other programs that share the machine do not count.
double processor_time() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// How often a second `work(thread)` is done by so many threads together: the sum of each thread's best try.
template <class Work> double rate(int threads, int tries, Work const& work) {
    std::barrier together(threads);
    std::vector<double> best(static_cast<std::size_t>(threads), 1e30);
    auto const body = [&](int thread) {
        for (int i = 0; i < tries; ++i) {
            together.arrive_and_wait();
            auto const before = processor_time();
            work(thread);
            auto& mine = best[static_cast<std::size_t>(thread)];
            mine = std::min(mine, processor_time() - before);
        }
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < threads; ++i) others.emplace_back(body, i);
        body(0);
    }
    double sum = 0.;
    for (double const seconds : best) sum += 1. / seconds;
    return sum;
}

// Enough chains to hide an addition's latency on every multiplier there is (5 cycles x 2), few enough for 16 registers: more would spill.
constexpr int chains = 12, turns = 2'000'000;

/// The chains must live in registers: they are parameters of a fold, never an array that is indexed at run time.
float multiply_and_add(float start) {
    Pack chain[chains], factor(0.999f), term(0.001f);
    auto const all = [&]<std::size_t... i>(std::index_sequence<i...>, int count) QUELL_INLINED {
        ((chain[i] = Pack(start + static_cast<float>(i))), ...);
        for (int turn = 0; turn < count; ++turn) ((chain[i] = fma(chain[i], factor, term)), ...);
        return (chain[i] + ...);
    };
    return lane(all(std::make_index_sequence<chains>{}, turns), 0);
}

double measure_operations(int threads) {
    std::atomic<float> sink = 0.f; // somebody must want the result
    return 2. * chains * turns * width_of<Pack> * rate(threads, 12, [&](int) { sink = multiply_and_add(sink * 1e-6f); });
}

/// Triad: a = b + s c. Each thread has its own arrays, placed by the thread that uses them.
double measure_bandwidth(int threads) {
    constexpr std::size_t total = std::size_t{24} << 20; // floats an array, all threads together: 288 MB in all
    std::size_t const count = total / static_cast<std::size_t>(threads);
    struct Arrays {
        std::vector<float> a, b, c;
    };
    std::vector<Arrays> arrays(static_cast<std::size_t>(threads));
    double const passes = rate(threads, 8, [&](int thread) {
        auto& mine = arrays[static_cast<std::size_t>(thread)];
        if (mine.a.empty()) mine = {std::vector<float>(count), std::vector<float>(count, 1.f), std::vector<float>(count, 2.f)};
        auto* const a = mine.a.data();
        auto const *const b = mine.b.data(), *const c = mine.c.data();
        for (std::size_t i = 0; i + width_of<Pack> <= count; i += width_of<Pack>)
            fma(Pack::load_unaligned(c + i), Pack(0.5f), Pack::load_unaligned(b + i)).store_unaligned(a + i);
    });
    return 3. * sizeof(float) * static_cast<double>(count) * passes;
}

} // namespace

int max_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

Machine const& machine(int threads) {
    static std::map<int, Machine> measured;
    auto& m = measured[threads];
    if (m.operations_per_second == 0.) m = {measure_operations(threads), measure_bandwidth(threads)};
    return m;
}

} // namespace quell::bench
