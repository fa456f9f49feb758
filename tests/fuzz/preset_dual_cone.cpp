#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("dual_cone", presets::dual_cone(indirect))};
