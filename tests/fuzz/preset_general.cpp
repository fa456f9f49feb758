#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("general", presets::general(radiance, Demodulate{}, KnownSamples{})),
                            known("final-frame", presets::final_frame(radiance, Demodulate{}))};
