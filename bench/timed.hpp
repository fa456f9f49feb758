#pragma once

#include <quell/execute/outlined.hpp>
#include <quell/execute/threads.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

namespace quell::bench {

/// Threads that this process can run at once.
inline int max_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

/// Which executor runs a frame.
struct How {
    enum class Kind { serial, simd, threads } kind = Kind::simd;
    int threads = 1;

    [[nodiscard]] std::string name() const {
        return kind == Kind::serial ? "serial" : kind == Kind::simd ? "simd" : "threads:" + std::to_string(threads);
    }
};

/// Seconds: by the clock on the wall, and of processor time over all threads, which other programs on the machine don't lengthen.
struct Seconds {
    double wall = 0., processor = 0.;

    static Seconds now() {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
                static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec)};
    }
    friend Seconds operator-(Seconds a, Seconds b) { return {a.wall - b.wall, a.processor - b.processor}; }
    Seconds& operator+=(Seconds b) { return wall += b.wall, processor += b.processor, *this; }
};

/// The executor that another one is asked for at run time, so that a kernel is compiled once and both run the very same instructions:
/// comparing Simd with Threads then compares nothing else.
struct Chosen {
    How how;

    void for_each_pixel(Region r, auto const& job) const {
        if (how.kind == How::Kind::threads)
            Threads<Outlined<>>{.count = how.threads}.for_each_pixel(r, job);
        else
            Outlined<>{}.for_each_pixel(r, job);
    }
};

/// Writes down how long each pass takes under another executor.
template <class Each> struct Timed {
    Each each;
    std::vector<Seconds>* passes;

    void for_each_pixel(Region r, auto const& job) const {
        auto const before = Seconds::now();
        each.for_each_pixel(r, job);
        passes->push_back(Seconds::now() - before);
    }
};

} // namespace quell::bench
