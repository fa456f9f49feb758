// error: Pipeline{channel, parts...}: one Temporal at most, since there is one history; use FirstValid to combine motion sources
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Pipeline denoise{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, quell::Exponential{}}};
#else
constexpr quell::Pipeline denoise{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, quell::Exponential{}},
                                  quell::Temporal{quell::StillMotion{}, quell::Exponential{}}};
#endif
