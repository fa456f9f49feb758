// error: Bilateral{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::Bilateral<quell::NormalEdge> blur{};
#else
constexpr quell::Bilateral<quell::RunningMean> blur{};
#endif
