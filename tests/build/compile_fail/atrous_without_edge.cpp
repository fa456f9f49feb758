// error: Atrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Atrous wavelet{quell::NormalEdge{}};
#else
constexpr quell::Atrous wavelet{quell::RunningMean{}};
#endif
