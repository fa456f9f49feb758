// error: Chain{first, links...}: the first is a Pipeline, a Composite, a ByEvidence or a TwoSided, each of the others a
#include <quell/pipeline/chain.hpp>
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr auto behind = quell::Pipeline{quell::denoised};
#else
constexpr auto behind = quell::Pipeline{quell::radiance};
#endif
constexpr auto denoise = quell::Chain{quell::Pipeline{quell::radiance}, behind};

int main() { return denoise.needs_camera ? 1 : 0; }
