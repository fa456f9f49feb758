#include "arbitrary_frames.hpp"

#include <quell/presets/published.hpp>

using namespace quell;
using namespace quell::fuzz;

// blur along paths of other kinds, of other footprints, and in other steps.
static Known const all[] = {
    known("blur_straight", presets::blur<StraightTrajectories>(radiance)),
    known("blur_bent", presets::blur<BentTrajectories>(radiance)),
    known("blur_adaptive", presets::blur<RotatingTrajectories, AdaptiveFootprint>(radiance)),
    known("blur_wavelet", presets::blur_wavelet(radiance)),
    known("blur_no_pre_filter", presets::blur_no_pre_filter(radiance)),
    known("blur_split", presets::blur_split()),
};
