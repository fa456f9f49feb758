#pragma once

#include <quell/execute/executor.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Runs another executor in a function that is not inlined. Executors that share an Outlined, such as Outlined<> and Threads<Outlined<>>,
/// share the code of each job: it is compiled once, and they run the very same instructions.
/// @tparam Each the other executor
template <class Each = Simd> struct Outlined {
    Each each{}; ///< the other executor

    /// See Executor.
    QUELL_NOINLINE void for_each_pixel(Region region, auto const& job) const { each.for_each_pixel(region, job); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
