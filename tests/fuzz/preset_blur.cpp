#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("blur", presets::blur(radiance)), known("blur_fixed_step", presets::blur_fixed_step(radiance)),
                            known("blur_one_step", presets::blur_one_step(radiance)), known("blur_paper", presets::blur_paper(radiance))};
