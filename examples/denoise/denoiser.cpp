#include <denoise/denoiser.hpp>

#include <quell/io/frame_image.hpp>

#include <array>

namespace quell::examples {

std::function<float(int c, int x, int y)> Denoiser::factor_in(io::ExrImage const& image) const {
    if (factor.empty()) return {};
    auto const values = std::make_shared<std::array<std::vector<float>, 3>>();
    for (std::size_t c = 0; c < 3; ++c) (*values)[c] = io::component_of(image, factor[c]);
    return [values, width = static_cast<std::size_t>(image.size.width)](int c, int x, int y) {
        return (*values)[static_cast<std::size_t>(c)][static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    };
}

} // namespace quell::examples
