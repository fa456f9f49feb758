#pragma once

#include <quell/execute/executor.hpp>

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace quell {

/// Tiles of an image on several threads (oneTBB), each run by another executor. Every pixel is computed by the same instructions whichever
/// tile it falls in, so the image does not depend on the number of threads or the tile's size. Called inside the host's own task arena with
/// `count` 0, it uses that arena's threads.
/// @tparam Each the executor of one tile
template <class Each = Simd> struct Threads {
    int count = 0;           ///< threads; 0: as many as the calling arena has
    Extent tile = {256, 32}; ///< pixels; with the rows that a 5x5 kernel at step 16 reaches, 256 columns fit a 512 KB L2
    Each each{};

    void for_each_pixel(Region r, auto const& job) const {
        auto const work = [&] {
            using Range = oneapi::tbb::blocked_range2d<int>;
            auto const rows = static_cast<std::size_t>(tile.height), columns = static_cast<std::size_t>(tile.width);
            oneapi::tbb::parallel_for(
                Range(r.y0, r.y1, rows, r.x0, r.x1, columns),
                [&](Range const& part) {
                    each.for_each_pixel({part.cols().begin(), part.rows().begin(), part.cols().end(), part.rows().end()}, job);
                },
                oneapi::tbb::simple_partitioner{});
        };
        if (count == 0) return work();
        oneapi::tbb::task_arena arena(count);
        arena.execute(work);
    }
};

} // namespace quell
