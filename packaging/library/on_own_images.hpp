#pragma once

#include "for_each_strip.hpp"

#include <quell/execute/outlined.hpp>

namespace quell_library {

/// Runs kernels on images of quell's own, by the caller's threads.
struct OnOwnImages {
    Parallel parallel;

    /// See quell::Executor.
    void for_each_pixel(quell::Region region, auto const& job) const {
        for_each_strip(parallel, region.y1 - region.y0, [&](int y0, int y1) {
            quell::Outlined<>{}.for_each_pixel({region.x0, region.y0 + y0, region.x1, region.y0 + y1}, job);
        });
        if (parallel.pass_done != nullptr) parallel.pass_done(parallel.user);
    }
};

} // namespace quell_library
