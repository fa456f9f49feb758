#include "arbitrary_frames.hpp"

using namespace quell;
using namespace quell::fuzz;

static Known const all[] = {known("trmv_paper", presets::trmv_paper())};
