// error: VarianceGuidedAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::VarianceGuidedAtrous wavelet{quell::NormalEdge{}};
#else
constexpr quell::VarianceGuidedAtrous wavelet{quell::RunningMean{}};
#endif
