// error: Clamped{inner, range}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Clamped blending{quell::RunningMean{}};
#else
constexpr quell::Clamped blending{quell::SurfaceMotion{}};
#endif
