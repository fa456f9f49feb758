#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("dual_cone_paper", presets::dual_cone_paper(indirect)),
                            known("dual_color", presets::dual_color(indirect))};
