// error: Pipeline{channel, parts...}: each part must be Temporal{...}, Spatial{...}, Demodulate{}, Cones{}, SuppressFireflies{},
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Pipeline denoise{quell::radiance, quell::Spatial{quell::Atrous{}}};
#else
constexpr quell::Pipeline denoise{quell::radiance, quell::Atrous{}};
#endif
