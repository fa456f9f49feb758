// error: CleanUp{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::CleanUp<quell::NormalEdge> clean_up{};
#else
constexpr quell::CleanUp<quell::RunningMean> clean_up{};
#endif
