#include "arbitrary_frames.hpp"

// What no preset has by itself: known numbers of samples, suppressed fireflies, and half precision, which has a largest number of its own.
using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("general, known samples", presets::general(radiance, Demodulate{}, KnownSamples{})),
                            known<Planar<Float16>>("svgf, half", presets::svgf(radiance, Demodulate{}, SuppressFireflies{}))};
