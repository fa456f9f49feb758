#pragma once

#include <cstddef>
#include <string>
#include <vector>

// What main.cpp asks of each preset; presets.cu answers, in files that are compiled side by side. Without headers of quell, which take long
// to compile.
namespace quell::bench {

/// How far Cuda's pictures are from those of Serial, over all frames.
struct Agreement {
    double worst = 0;         ///< greatest difference, relative to max(1, value)
    double apart = 0;         ///< part of the components that differ by more than `allowed`
    bool counts_equal = true; ///< of missing samples and repaired guides
    static constexpr double allowed = 1e-3, allowed_apart = 1e-3;

    [[nodiscard]] bool good() const { return counts_equal && apart <= allowed_apart; }
};

/// A pass on the device.
struct PassCost {
    std::string name;
    double milliseconds = 0; ///< of the device
    int registers = 0;
    std::size_t local_bytes = 0; ///< per thread
};
struct Cost {
    double milliseconds = 0;                                           ///< by the host's clock, which waits for each frame
    double host_milliseconds = 0;                                      ///< until run() returns
    double milliseconds_in_row = 0;                                    ///< a frame of many that are enqueued one behind the other
    double graph_host_milliseconds = 0, graph_milliseconds_in_row = 0; ///< the same with CudaGraphs
    std::vector<PassCost> passes;
};

struct Measured {
    std::string name;
    std::size_t order; ///< among all_presets
    Agreement (*agreement)(int width, int height, int frames);
    Cost (*cost)(int width, int height, int frames);
};
/// Filled by the files of presets.cu before main().
inline std::vector<Measured>& measured_presets() {
    static std::vector<Measured> all;
    return all;
}

} // namespace quell::bench
