// error: WithVariance{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::WithVariance blending{quell::RunningMean{}};
#else
constexpr quell::WithVariance blending{quell::SurfaceMotion{}};
#endif
