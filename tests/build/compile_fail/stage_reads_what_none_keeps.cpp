// error: a stage looks at what no blend policy keeps
#include <quell/quell.hpp>
using namespace quell;

#ifdef CORRECT
constexpr Pipeline denoise{radiance, Spatial{BiasEstimate<>{}}, Temporal{SurfaceMotion{}, WithVariance{RunningMean{}}}};
#else
constexpr Pipeline denoise{radiance, Spatial{BiasEstimate<>{}}, Temporal{SurfaceMotion{}, RunningMean{}}};
#endif
