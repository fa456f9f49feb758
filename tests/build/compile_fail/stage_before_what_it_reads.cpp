// error: Pipeline{channel, parts...}: a stage reads what only a later one makes
#include <quell/quell.hpp>

constexpr quell::Temporal accumulate{quell::SurfaceMotion{}, quell::WithMoments{quell::RunningMean{}}};
constexpr quell::Spatial filter{quell::VarianceGuidedAtrous<>{}};
#ifdef CORRECT
constexpr quell::Pipeline denoise{quell::radiance, accumulate, filter};
#else
constexpr quell::Pipeline denoise{quell::radiance, filter, accumulate};
#endif
