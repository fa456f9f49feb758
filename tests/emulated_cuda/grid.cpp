#include "grid.hpp"

#include <ucontext.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <thread>

thread_local uint3 threadIdx, blockIdx;
thread_local dim3 blockDim, gridDim;

namespace emulated_cuda {
namespace {

constexpr unsigned warp = 32;

unsigned count_of(dim3 size) { return size.x * size.y * size.z; }
uint3 place_of(unsigned number, dim3 size) { return {number % size.x, number / size.x % size.y, number / (size.x * size.y)}; }

std::vector<unsigned> shuffled(unsigned first, unsigned count, std::mt19937& random) {
    std::vector<unsigned> all(count);
    std::iota(all.begin(), all.end(), first);
    std::shuffle(all.begin(), all.end(), random);
    return all;
}
/// The threads of a block in the order in which they run.
std::vector<unsigned> order_of_threads(unsigned count, std::mt19937& random) {
    std::vector<unsigned> order;
    for (unsigned const each : shuffled(0, (count + warp - 1) / warp, random))
        for (unsigned const thread : shuffled(each * warp, std::min(warp, count - each * warp), random)) order.push_back(thread);
    return order;
}

/// A block whose threads all exist at once, in one thread of the host: each runs up to a barrier, then another has its turn.
class BlockAtOnce {
    struct Thread {
        ucontext_t context;
        std::unique_ptr<char[]> stack;
        bool done = false;
    };
    std::vector<Thread> threads;
    std::function<void()> work;
    ucontext_t scheduler;
    Thread* running = nullptr;
    static thread_local BlockAtOnce* current;

    static void begin() {
        current->work();
        current->running->done = true;
    }

public:
    BlockAtOnce(unsigned count, std::function<void()> work_) : threads(count), work(std::move(work_)) {
        constexpr std::size_t stack_bytes = 128 * 1024;
        for (auto& each : threads) {
            each.stack = std::make_unique_for_overwrite<char[]>(stack_bytes);
            getcontext(&each.context);
            each.context.uc_stack.ss_sp = each.stack.get(), each.context.uc_stack.ss_size = stack_bytes;
            each.context.uc_link = &scheduler;
            makecontext(&each.context, begin, 0);
        }
    }
    void run(std::mt19937& random) {
        current = this;
        auto const count = static_cast<unsigned>(threads.size());
        for (std::size_t done = 0; done < threads.size();) {
            done = 0;
            for (unsigned const number : order_of_threads(count, random)) {
                running = &threads[number];
                threadIdx = place_of(number, blockDim);
                swapcontext(&scheduler, &running->context);
                done += running->done;
            }
            if (done > 0 && done < threads.size()) stop("threads of a block wait at a barrier that others have not come to");
        }
        current = nullptr;
    }
    static void meet() {
        if (!current) stop("a barrier in a kernel that was not launched as a cooperative one");
        auto& self = *current->running;
        swapcontext(&self.context, &current->scheduler);
    }
    [[noreturn]] static void stop(char const* reason) {
        std::fprintf(stderr, "emulated CUDA: %s\n", reason);
        std::abort();
    }
};
thread_local BlockAtOnce* BlockAtOnce::current = nullptr;

} // namespace

void run_grid(Launch const& launch, std::mt19937& random) {
    std::vector<void const*> arguments;
    for (auto const& each : launch.arguments) arguments.push_back(each.data());
    auto const blocks = shuffled(0, count_of(launch.grid), random);
    auto const run_block = [&](unsigned block, std::mt19937::result_type seed) {
        std::mt19937 own(seed);
        gridDim = launch.grid, blockDim = launch.block;
        blockIdx = place_of(block, launch.grid);
        auto const count = count_of(launch.block);
        if (launch.cooperative) return BlockAtOnce(count, [&] { launch.kernel->run(arguments); }).run(own);
        for (unsigned const thread : order_of_threads(count, own)) {
            threadIdx = place_of(thread, launch.block);
            launch.kernel->run(arguments);
        }
    };
    if (!launch.cooperative) {
        for (unsigned const block : blocks) run_block(block, random());
        return;
    }
    std::vector<std::jthread> at_once;
    for (unsigned const block : blocks) at_once.emplace_back(run_block, block, random());
}

} // namespace emulated_cuda

void __syncthreads() { emulated_cuda::BlockAtOnce::meet(); }
