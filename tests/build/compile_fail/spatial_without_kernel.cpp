// error: Spatial{kernel}: `kernel` must have filter(px) or for_each_pass(pass), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Spatial smooth{quell::Atrous{}};
#else
constexpr quell::Spatial smooth{quell::RunningMean{}};
#endif
