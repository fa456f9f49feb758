#include <quell/execute/threads.hpp>

#include <tbb/version.h>

/// Something of oneTBB's own, so that its library has to be linked.
int threads_of_the_library() { return TBB_runtime_interface_version(); }
