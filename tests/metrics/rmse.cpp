#include "pictures.hpp"

#include <quell/metrics/rmse.hpp>

using namespace pictures;
using quell::metrics::rmse;

TEST_CASE("rmse: known values") {
    auto const grey = constant({7, 5}, glm::vec3(0.25f));
    CHECK(rmse(grey, grey) == 0.);
    CHECK(rmse(grey, constant({7, 5}, glm::vec3(0.75f))) == doctest::Approx(0.5));
    CHECK(rmse(grey, constant({7, 5}, {0.25f, 0.25f, 0.75f})) == doctest::Approx(0.5 / std::sqrt(3.)));
    CHECK(rmse(constant({1, 1}, glm::vec3(0.f)), constant({1, 1}, glm::vec3(1.f))) == doctest::Approx(1.));
}

TEST_CASE("rmse: symmetric, and more for more noise") {
    auto const a = scene({30, 20}), b = disturbed(a, 0.1f, 3), c = disturbed(a, 0.3f, 3);
    CHECK(rmse(a, b) == doctest::Approx(rmse(b, a)).epsilon(1e-12));
    CHECK(rmse(a, b) < rmse(a, c));
}

TEST_CASE("rmse: only what the mask selects counts") {
    Extent const size{8, 5};
    auto const a = constant(size, glm::vec3(0.2f)), b = halves(constant(size, glm::vec3(0.6f)), a);
    auto mask = left_half(size);
    CHECK(rmse(a, b, mask) == doctest::Approx(0.4));
    CHECK(rmse(a, b) == doctest::Approx(0.4 / std::sqrt(2.)));
    for (auto& entry : mask) entry = entry == 0 ? 255 : 0;
    CHECK(rmse(a, b, mask) == 0.);
}

TEST_CASE("rmse: refuses broken input") {
    refuses_broken_input([](auto const& a, auto const& b, auto const& mask) { return rmse(a, b, mask); });
}
