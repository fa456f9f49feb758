#include "denoiser_of.hpp"

namespace quell::live {

std::unique_ptr<Denoiser> make_surface_clamp(Extent size) { return make_denoiser(presets::surface_clamp(radiance, Demodulate{}), size); }

} // namespace quell::live
