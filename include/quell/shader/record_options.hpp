#pragma once

#include <quell/core/instruction_set.hpp>
#include <quell/image/extent.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What record() adds to a pipeline's passes: parts of run() that only some hosts need.
struct RecordOptions {
    /// Whether guides that no scene has are repaired (docs/channels.md), by a pass at the front. It takes scratch for copies.
    bool repair_guides = false;
    /// Passes behind the ingest that give missing samples without a usable neighbour what stands 2, 4, 8, ... pixels away: with n of them,
    /// up to 2^(n + 1) - 1 pixels in all. run() takes as many as a frame needs.
    int fill_holes = 0;
    static constexpr int most_fill_holes = 16; ///< which is more than any image needs
    /// Whether missing samples, impossible guides and suppressed light are counted: see ShaderPlan::counts.
    bool counts = false;
    /// Whether history and scratch are kept as a History of Planar<Float16> keeps them: what tolerates it is rounded to 16-bit floats, two
    /// of a pixel to a word where that is possible. The device needs no 16-bit types for it.
    bool half_precision = false;
    /// Slots of a buffer at most: what has more lies in several. 0: there is no limit.
    int most_slots = 0;
    /// Whether GLSL loads planes by texelFetch, of views of the buffers: a device that is a CPU does that several times as fast. WGSL has
    /// no such views.
    bool texel_loads = false;
    /// Threads of a workgroup along each axis.
    Extent workgroup{8, 8};
    static constexpr int most_threads = 128; ///< of a workgroup in all, which every device has
    /// Whether every device has workgroups of so many threads.
    [[nodiscard]] static constexpr bool is_workgroup(Extent threads) {
        auto const fits = [](int side) { return side >= 1 && side <= most_threads; };
        return fits(threads.width) && fits(threads.height) && threads.pixels() <= most_threads;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
