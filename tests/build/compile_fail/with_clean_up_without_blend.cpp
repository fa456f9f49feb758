// error: WithCleanUp{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::WithCleanUp blending{quell::RunningMean{}};
#else
constexpr quell::WithCleanUp blending{quell::SurfaceMotion{}};
#endif
