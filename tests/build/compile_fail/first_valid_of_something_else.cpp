// error: FirstValid{sources...}: each must have previous(px), see quell/motion/motion_source.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::FirstValid either{quell::SurfaceMotion{}, quell::StillMotion{}};
#else
constexpr quell::FirstValid either{quell::SurfaceMotion{}, quell::RunningMean{}};
#endif
