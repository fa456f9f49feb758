#include <denoise/denoised_frame.hpp>

#include <quell/core/real.hpp>

namespace quell::examples {

void DenoisedFrame::added_at(std::size_t pixel, int component, std::vector<float>& values) const {
    values.clear();
    bool finite = true;
    for (auto const& planes : added)
        for (auto const& plane : planes) finite = finite && is_finite((*plane.values)[pixel]);
    for (auto const& plane : added[static_cast<std::size_t>(component)])
        if (finite) values.push_back((*plane.values)[pixel] * plane.scale + plane.offset);
}

} // namespace quell::examples
