// error: Planar<Format>: `Format` must be Float32, Float16 or another format, see quell/image/format.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
using Storage = quell::Planar<quell::Float16>;
#else
using Storage = quell::Planar<double>;
#endif

Storage::Image<3> image(quell::Extent{4, 4});
