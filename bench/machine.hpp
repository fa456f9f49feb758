#pragma once

namespace quell::bench {

/// What this machine can do at most with so many threads at once.
struct Machine {
    double operations_per_second = 0.; ///< floating-point, a fused multiply-add being two
    double bytes_per_second = 0.;      ///< read and written, from memory larger than the caches
};

/// Measured at the first call for a number of threads: best of several tries by processor time, since a shared machine can only make them
/// worse.
Machine const& machine(int threads);

/// Threads that this process can run at once.
int max_threads();

} // namespace quell::bench
