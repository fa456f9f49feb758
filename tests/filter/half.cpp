#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{48, 32};

/// The error that a variance-guided filter leaves of noise around a mean, as a part of the mean.
template <ImageStorage Storage> double relative_error(Storage storage, float mean) {
    constexpr auto denoise = presets::svgf(radiance);
    Frame frame{size, denoise};
    History history{size, denoise, storage};
    tests::fill_still(frame);
    std::mt19937 random(3);
    std::exponential_distribution<float> noise(1.f);
    std::vector<float> out;
    for (int i = 0; i < 12; ++i) {
        tests::fill(frame[radiance], [&](int, int) { return glm::vec3(mean * std::min(noise(random), 15.f)); });
        out = tests::copy_of(run(denoise, frame, history));
    }
    return tests::root_mean_square(out, std::vector<float>(out.size(), mean)) / static_cast<double>(mean);
}
} // namespace

TEST_CASE("a history in half denoises bright and dark scenes as one in float does") {
    for (float const mean : {0.01f, 1.f, 1000.f, 4000.f})
        CHECK(relative_error(Planar<Float16>{}, mean) == doctest::Approx(relative_error(Planar<>{}, mean)).epsilon(0.02));
}
