#pragma once

// oneTBB is a library, which cross builds lack: there, what tests check of Threads is left out.
#if __has_include(<oneapi/tbb/parallel_for.h>)
#include <quell/execute/threads.hpp>
#define QUELL_TEST_THREADS
#endif
