#pragma once

#include <quell/execute/executor.hpp>

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace quell {

/// Tiles of an image on several threads (oneTBB), each run by another executor. Every pixel is computed by the same instructions whichever
/// tile it falls in, so the image does not depend on the number of threads or the tile's size. Called inside the host's own task arena with
/// `count` 0, it uses that arena's threads.
/// @tparam Each the executor of one tile
template <class Each = Simd> struct Threads {
    static constexpr int most = 1024; ///< threads: oneTBB takes memory for each that it is asked for, and crashes without

    int count = 0;           ///< threads, of which more than `most` count as that; 0: as many as the calling arena has
    Extent tile = {256, 32}; ///< pixels; with the rows that a 5x5 kernel at step 16 reaches, 256 columns fit a 512 KB L2
    Each each{};

    void for_each_pixel(Region r, auto const& job) const {
        // oneTBB halves ranges. A range of pixels would end in tiles of any width, which packs don't fit in; one of tiles does not.
        auto const work = [&] {
            using Range = oneapi::tbb::blocked_range2d<int>;
            int const width = std::clamp(tile.width, 1, std::max(r.x1 - r.x0, 1)),
                      height = std::clamp(tile.height, 1, std::max(r.y1 - r.y0, 1));
            oneapi::tbb::parallel_for(
                Range(0, (r.y1 - r.y0 + height - 1) / height, 0, (r.x1 - r.x0 + width - 1) / width),
                [&](Range const& part) {
                    int const x = r.x0 + part.cols().begin() * width, y = r.y0 + part.rows().begin() * height;
                    each.for_each_pixel({x, y, std::min(x + width, r.x1), std::min(y + height, r.y1)}, job);
                },
                oneapi::tbb::simple_partitioner{});
        };
        if (count == 0) return work();
        oneapi::tbb::task_arena arena(std::clamp(count, 1, most));
        arena.execute(work);
    }
};

} // namespace quell
