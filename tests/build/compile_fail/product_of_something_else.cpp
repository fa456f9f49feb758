// error: Product{edges...}: each must have around(px), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Product edges{quell::NormalEdge{}, quell::DepthEdge{}};
#else
constexpr quell::Product edges{quell::NormalEdge{}, quell::RunningMean{}};
#endif
