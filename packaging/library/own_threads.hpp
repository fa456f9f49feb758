#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace quell_library {

/// Threads of the library's own (oneTBB).
class OwnThreads {
    std::optional<oneapi::tbb::task_arena> arena;

public:
    static constexpr int max_count = 1024;

    /// @param count 0: those of the calling arena
    explicit OwnThreads(int count) {
        if (count > 0) arena.emplace(std::clamp(count, 1, std::min(max_count, oneapi::tbb::this_task_arena::max_concurrency())));
    }
    [[nodiscard]] int count() const { return arena ? arena->max_concurrency() : oneapi::tbb::this_task_arena::max_concurrency(); }
    /// @param threads an OwnThreads
    static void run(void* threads, std::int32_t count, void (*task)(void* context, std::int32_t index), void* context) {
        auto const work = [&] { oneapi::tbb::parallel_for(std::int32_t{0}, count, [&](std::int32_t i) { task(context, i); }); };
        auto& its_arena = static_cast<OwnThreads*>(threads)->arena;
        its_arena ? its_arena->execute(work) : work();
    }
};

} // namespace quell_library
