#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("gather_blur", presets::gather_blur(radiance)), known("tilemax_blur", presets::tilemax_blur(radiance))};
