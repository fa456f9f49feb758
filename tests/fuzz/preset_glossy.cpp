#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("glossy", presets::glossy(quell::glossy))};
