#pragma once

// oneTBB is a library, which cross builds lack: there, what tests check of Threads is left out. quell_test_threads of CMakeLists.txt says.
#if defined(QUELL_TEST_THREADS)
#include <quell/execute/threads.hpp>
#endif
