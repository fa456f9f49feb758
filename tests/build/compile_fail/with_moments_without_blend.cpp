// error: WithMoments{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::WithMoments blending{quell::RunningMean{}};
#else
constexpr quell::WithMoments blending{quell::SurfaceMotion{}};
#endif
