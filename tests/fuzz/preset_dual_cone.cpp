#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

// And as a part of a picture, which multiplies it by the host's albedo.
static Known const all[] = {known("dual_cone", presets::dual_cone(indirect)), known("composite", Composite{presets::dual_cone(indirect)})};
