#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("shadow", presets::shadow(visibility)), known("shadow_paper", presets::shadow_paper(visibility))};
