#include "pictures.hpp"

#include <quell/image/planar.hpp>

using namespace pictures;
using namespace quell::metrics;

TEST_CASE("displayed: clamps, then encodes as sRGB") {
    auto const shown = displayed({{2, 2}, {{0.f, 0.5f, 1.f}, {-3.f, 7.f, 0.001f}, {0.18f, 0.0031308f, 1e30f}, {1.f, 1.f, 1.f}}});
    CHECK(shown.size == Extent{2, 2});
    CHECK(shown.pixels[0].x == 0.f);
    CHECK(shown.pixels[0].y == doctest::Approx(0.735357).epsilon(1e-5));
    CHECK(shown.pixels[0].z == 1.f);
    CHECK(shown.pixels[1].x == 0.f);
    CHECK(shown.pixels[1].y == 1.f);
    CHECK(shown.pixels[1].z == doctest::Approx(0.01292).epsilon(1e-5));
    CHECK(shown.pixels[2].x == doctest::Approx(0.461356).epsilon(1e-5));
    CHECK(shown.pixels[2].z == 1.f);
}

TEST_CASE("picture_of: colours as they are, row by row, and grey for one component") {
    quell::Planar<>::Image<3> colours(Extent{3, 2});
    quell::Planar<>::Image<1> shadow(Extent{3, 2});
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            auto const a = static_cast<float>(y * 3 + x);
            colours.set(x, y, {a, a + 10.f, a + 20.f});
            shadow.set(x, y, a);
        }
    auto const coloured = picture_of(colours.view()), grey = picture_of(shadow.view());
    REQUIRE(coloured.size == Extent{3, 2});
    REQUIRE(coloured.pixels.size() == 6);
    CHECK(coloured.pixels[4] == glm::vec3(4, 14, 24));
    CHECK(grey.pixels[4] == glm::vec3(4));
}

TEST_CASE("sRGB: decoding undoes encoding, and the two pieces of the curve meet") {
    for (int i = 0; i <= 1000; ++i) {
        auto const a = static_cast<float>(i) / 1000.f;
        CHECK(std::abs(linear_from_srgb(srgb_from_linear(a)) - a) < 1e-6f);
    }
    CHECK(std::abs(srgb_from_linear(0.0031309f) - srgb_from_linear(0.0031308f)) < 1e-5f);
}

TEST_CASE("displayed: refuses what isn't finite, and names pixel and value") {
    auto linear = constant({3, 2}, {0.25f, 0.5f, 0.75f});
    linear.pixels[5].z = std::numeric_limits<float>::quiet_NaN();
    CHECK(refuses([&] { (void)displayed(linear); }, {"(2, 1)", "0.25", "nan"}));
    linear.pixels[5].z = -std::numeric_limits<float>::infinity();
    CHECK(refuses([&] { (void)displayed(linear); }, {"(2, 1)", "-inf"}));
    CHECK(refuses([&] { (void)displayed({{-1, 2}, {}}); }, {"-1x2", "1x1"}));
    CHECK(refuses([&] { (void)displayed({{3, 2}, {}}); }, {"3x2", "0 pixels", "6"}));
}

TEST_CASE("filters: at every width, rows and columns of the transpose agree") {
    detail::Taps<float> const taps{0.1f, -0.4f, 0.8f, 0.3f, 0.2f};
    for (int width = 1; width < 70; ++width) {
        auto const picture = noise({width, 3}, 7);
        Plane<float> plane{picture.size, {}};
        for (auto const& p : picture.pixels) plane.values.push_back(p.x);
        Plane<float> transposed{{3, width}, plane.values};
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < width; ++x) transposed.row(x)[y] = plane.row(y)[x];
        auto const rows = detail::along_rows(plane, taps), columns = detail::along_columns(transposed, taps);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < width; ++x) {
                float expected = 0.f;
                for (int t = 0; t < 5; ++t)
                    expected += taps[static_cast<std::size_t>(t)] * plane.row(y)[std::clamp(x + t - 2, 0, width - 1)];
                CHECK(std::abs(rows.row(y)[x] - expected) < 1e-6f);
                CHECK(std::abs(columns.row(x)[y] - expected) < 1e-6f);
            }
    }
}
