#pragma once

#include <quell/image/extent.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace quell_library {
struct Way;
}

namespace quell::bench {

/// What families on a GPU have in a storage's place.
inline constexpr auto cuda_storage = "cuda";
/// The storage of the history of all others.
inline constexpr auto usual_storage = "planar-float";

/// Threads that this process can run at once.
inline int max_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

/// Which executor runs a frame.
struct How {
    enum class Kind { simd, threads } kind = Kind::simd;
    int threads = 1;

    [[nodiscard]] std::string name() const { return kind == Kind::simd ? "simd" : "threads:" + std::to_string(threads); }
};

/// Seconds: by the clock on the wall, and of processor time over all threads, which other programs on the machine don't lengthen.
struct Seconds {
    double wall = 0., processor = 0.;

    static Seconds now();
    friend Seconds operator-(Seconds a, Seconds b) { return {a.wall - b.wall, a.processor - b.processor}; }
};

/// A compiled preset, and where it runs.
struct Family {
    std::string preset;
    std::string storage;
    std::vector<std::string> passes; ///< no spaces, and several of one name numbered
    quell_library::Way const* way;   ///< lives as long as the program
};
std::vector<Family> families();
/// Those that run on a GPU. Their storage is called cuda.
/// @throws Error where the program was built without CUDA
std::vector<Family> cuda_families();

/// A preset with a history of its own, ready to run frame after frame.
class Workload {
public:
    virtual ~Workload() = default;
    /// The next frame of the sequence. Returns the whole frame's time.
    virtual Seconds next(How how) = 0;
    /// What the passes of the last frame took.
    [[nodiscard]] virtual std::vector<Seconds> const& passes() const = 0;
    [[nodiscard]] virtual double bytes_per_pixel() const = 0;
};
/// A warm workload. Only the last one asked for is kept: at 1920x1080 they are large.
Workload& workload(Family const& family, Extent size);

} // namespace quell::bench
