#pragma once

namespace quell::bench {

/// How often operator new was called so far, by anything in this process. oneTBB's own memory mostly comes from elsewhere, so what quell
/// itself allocates shows in a frame under the Simd executor.
long long allocations();

} // namespace quell::bench
