#include "pictures.hpp"

#include <quell/metrics/error_map.hpp>

using namespace pictures;
using namespace quell::metrics;

TEST_CASE("error_map: dark for none, bright for the largest, ever brighter between") {
    Flip errors{{256, 1}, {}};
    for (int i = 0; i < 256; ++i) errors.error.push_back(static_cast<float>(i) / 255.f);
    auto const map = error_map(errors);
    CHECK(map.size == errors.size);
    detail::check_displayed("map", map);
    CHECK(map.pixels.front().x < 0.01f);
    CHECK(map.pixels.back().y > 0.98f);
    auto const luminance = [](glm::vec3 const& p) { return 0.2126f * p.x + 0.7152f * p.y + 0.0722f * p.z; };
    for (std::size_t i = 1; i < 256; ++i) CHECK(luminance(map.pixels[i]) > luminance(map.pixels[i - 1]));
}

TEST_CASE("error_map: refuses what isn't an error") {
    CHECK(refuses([] { (void)error_map({{2, 1}, {0.5f, std::numeric_limits<float>::quiet_NaN()}}); }, {"nan", "[0, 1]"}));
    CHECK(refuses([] { (void)error_map({{2, 1}, {0.5f}}); }, {"2x1", "1 pixels"}));
}
