#pragma once

#include <quell/execute/executor.hpp>

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Runs tiles of the image on several threads (oneTBB). The result depends neither on the number of threads nor on the tile size. With
/// `count` 0 it uses the threads of the task arena that it is called in.
/// @tparam Each the executor of one tile
template <class Each = Simd> struct Threads {
    static constexpr int max_count = 1024; ///< limit of `count`: oneTBB allocates memory for each thread and crashes where that fails

    /// Threads: at most as many as oneTBB allows, which are the machine's or those of the host's global_control, and at most `max_count`.
    /// 0: those of the calling arena.
    int count = 0;
    Extent tile = {}; ///< pixels; width 0: whole rows, height 0: 16 rows, or fewer where threads would have less than four tiles each
    Each each{};      ///< executor of one tile

    /// See Executor.
    void for_each_pixel(Region r, auto const& job) const {
        // oneTBB halves ranges. Ranges of pixels would give tiles of widths that are no multiple of a pack, so the range counts tiles.
        auto const work = [&] {
            using Range = oneapi::tbb::blocked_range2d<int>;
            auto const size = tile_in({r.x1 - r.x0, r.y1 - r.y0});
            oneapi::tbb::parallel_for(
                Range(0, (r.y1 - r.y0 + size.height - 1) / size.height, 0, (r.x1 - r.x0 + size.width - 1) / size.width),
                [&](Range const& part) {
                    int const x = r.x0 + part.cols().begin() * size.width, y = r.y0 + part.rows().begin() * size.height;
                    each.for_each_pixel({x, y, std::min(x + size.width, r.x1), std::min(y + size.height, r.y1)}, job);
                },
                oneapi::tbb::simple_partitioner{});
        };
        if (count == 0) return work();
        oneapi::tbb::task_arena arena(std::clamp(count, 1, most_threads()));
        arena.execute(work);
    }

private:
    /// oneTBB prints a warning where an arena asks for more.
    static int most_threads() {
        using oneapi::tbb::global_control;
        auto const allowed = global_control::active_value(global_control::max_allowed_parallelism);
        return static_cast<int>(std::min(allowed, static_cast<std::size_t>(max_count)));
    }
    /// The tile for a region. Whole rows are what prefetchers and address translation do best.
    Extent tile_in(Extent region) const {
        constexpr int usual_height = 16, tiles_per_thread = 4;
        int const threads = oneapi::tbb::this_task_arena::max_concurrency();
        int const fair = region.height / (tiles_per_thread * threads);
        int const width = tile.width > 0 ? tile.width : region.width, height = tile.height > 0 ? tile.height : std::min(fair, usual_height);
        return {std::clamp(width, 1, std::max(region.width, 1)), std::clamp(height, 1, std::max(region.height, 1))};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
