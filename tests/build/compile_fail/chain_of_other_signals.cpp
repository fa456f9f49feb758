// error: Chain{first, links...}: the first is a Pipeline or a Composite, each of the others a Pipeline{quell::denoised, ...}
#include <quell/pipeline/chain.hpp>
#include <quell/quell.hpp>

#ifdef CORRECT
constexpr auto behind = quell::Pipeline{quell::denoised};
#else
constexpr auto behind = quell::Pipeline{quell::radiance};
#endif
constexpr auto denoise = quell::Chain{quell::Pipeline{quell::radiance}, behind};

int main() { return denoise.needs_camera ? 1 : 0; }
