#pragma once

#include "family.hpp"

namespace quell::bench {

/// Registers `preset/size/storage/executor` for whole frames, `pass/preset/pass/size/storage/executor` for single passes, and
/// `smoke/preset` (a tiny frame, once) with Google Benchmark.
void register_benchmarks(std::vector<Family> const& families);

} // namespace quell::bench
