// error: Pipeline{channel, parts...}: a stage reads what none of them makes
#include <quell/quell.hpp>

using quell::RunningMean;
constexpr quell::Spatial clean_up{quell::CleanUp<>{}};
#ifdef CORRECT
constexpr quell::Pipeline denoise{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, quell::WithCleanUp{RunningMean{}}}, clean_up};
#else
constexpr quell::Pipeline denoise{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, RunningMean{}}, clean_up};
#endif
