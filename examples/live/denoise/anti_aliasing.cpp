#include "denoiser_of.hpp"

#include <quell/presets/resolve.hpp>

namespace quell::live {

std::unique_ptr<Denoiser> make_anti_aliasing(Extent size) { return make_denoiser(presets::resolve(presets::none(radiance)), size); }

} // namespace quell::live
