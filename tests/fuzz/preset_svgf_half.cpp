#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

// Half precision has a largest number of its own.
static Known const all[] = {known<Planar<Float16>>("svgf half", presets::svgf(radiance, Demodulate{}, SuppressFireflies{}))};
