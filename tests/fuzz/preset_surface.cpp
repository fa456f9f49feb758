#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("none", presets::none(radiance)), known("surface", presets::surface(radiance)),
                            known("surface_clamp", presets::surface_clamp(radiance, Demodulate{}, SuppressFireflies{})),
                            known("atrous", presets::atrous(radiance, Demodulate{}))};
