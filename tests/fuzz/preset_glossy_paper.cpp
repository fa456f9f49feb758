#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("glossy_paper", presets::glossy_paper(quell::glossy)),
                            known("mirror_clamp", presets::mirror_clamp(quell::glossy))};
