#include "denoiser_of.hpp"

namespace quell::live {

std::unique_ptr<Denoiser> make_general(Extent size) { return make_denoiser(presets::general(radiance, Demodulate{}), size); }

} // namespace quell::live
