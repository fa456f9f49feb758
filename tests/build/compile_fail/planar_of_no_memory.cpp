// error: Planar<Format, Memory>: `Memory` must have allocate(bytes) and release(memory), see quell/image/memory.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
using Storage = quell::Planar<quell::Float32, quell::HostMemory>;
#else
struct NoMemory {};
using Storage = quell::Planar<quell::Float32, NoMemory>;
#endif

Storage::Image<3> image(quell::Extent{4, 4});
