#pragma once

namespace quell::bench {

/// Registers `preset/size/storage/executor` for whole frames, `pass/preset/pass/size/storage/executor` for single passes, and
/// `smoke/preset` (a tiny frame, once) with Google Benchmark.
void register_benchmarks();

} // namespace quell::bench
