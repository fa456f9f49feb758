// error: what several frames have in common counts as several samples
#include <quell/pipeline/two_sided.hpp>
#include <quell/quell.hpp>
using namespace quell;

#ifdef CORRECT
constexpr auto denoise = presets::general(radiance, KnownSamples{});
#else
constexpr auto denoise = presets::general(radiance);
#endif
void host() { TwoSidedHistory history{Extent{4, 4}, denoise}; }
