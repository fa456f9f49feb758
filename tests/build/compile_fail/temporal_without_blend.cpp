// error: Temporal{motion, blend}: `blend` must have blend(px, past), see quell/blend/blend_policy.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Temporal accumulate{quell::SurfaceMotion{}, quell::RunningMean{}};
#else
constexpr quell::Temporal accumulate{quell::SurfaceMotion{}, quell::Atrous{}};
#endif
