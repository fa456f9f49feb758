// error: Temporal{motion, blend}: `motion` must have previous(px), see quell/motion/motion_source.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Temporal accumulate{quell::SurfaceMotion{}, quell::RunningMean{}};
#else
constexpr quell::Temporal accumulate{quell::Exponential{}, quell::RunningMean{}};
#endif
