#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("asvgf", presets::asvgf(radiance, Demodulate{}))};
