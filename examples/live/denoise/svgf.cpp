#include "denoiser_of.hpp"

namespace quell::live {

std::unique_ptr<Denoiser> make_svgf(Extent size) { return make_denoiser(presets::svgf(radiance, Demodulate{}), size); }

} // namespace quell::live
