// error: ForgetBiased{inner}: `inner` must keep the history's length, as RunningMean does
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr quell::ForgetBiased blending{quell::RunningMean{}};
#else
constexpr quell::ForgetBiased blending{quell::Exponential{}};
#endif
