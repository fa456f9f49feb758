// error: ConservingAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::ConservingAtrous wavelet{quell::NormalEdge{}};
#else
constexpr quell::ConservingAtrous wavelet{quell::RunningMean{}};
#endif
