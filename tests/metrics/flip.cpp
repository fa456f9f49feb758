#include "../shared_data.hpp"
#include "pictures.hpp"
#include "read_png.hpp"

#include <quell/metrics/flip.hpp>

using namespace pictures;
using quell::metrics::flip;
using quell::metrics::Flip;

TEST_CASE("flip: agrees with the reference implementation" * doctest::test_suite("shared data")) {
    auto const folder = quell::tests::shared("data/flip");
    if (folder.empty()) return;
    struct Expected {
        char const* name;
        double mean, weighted_median;
    };
    // From data/flip/README.md.
    for (auto const& expected : {Expected{"a", 0.210938, 0.241502}, Expected{"b", 0.056022, 0.088366}, Expected{"c", 0.239831, 0.335224}}) {
        auto const read = [&](char const* end) { return read_png(folder / (std::string(expected.name) + end)); };
        auto const result = flip(read("_ref.png"), read("_test.png"));
        INFO("pair " << expected.name);
        INFO("mean " << result.mean() << ", weighted median " << result.weighted_median());
        CHECK(std::abs(result.mean() - expected.mean) < 1e-4);
        CHECK(std::abs(result.weighted_median() - expected.weighted_median) < 1e-3);
    }
}

TEST_CASE("flip: 0 for equal pictures") {
    for (auto const& picture : {scene({41, 27}), noise({41, 27}, 2), constant({1, 1}, {1.f, 0.f, 0.f})}) {
        auto const result = flip(picture, picture);
        CHECK(result.mean() == 0.);
        CHECK(result.weighted_median() == 0.);
        CHECK(result.size == picture.size);
    }
}

TEST_CASE("flip: symmetric, in [0, 1], more for more noise, less from farther away") {
    auto const a = scene({50, 30}), b = disturbed(a, 0.1f, 3), c = disturbed(a, 0.4f, 3);
    CHECK(flip(a, b).mean() == doctest::Approx(flip(b, a).mean()).epsilon(1e-6));
    CHECK(flip(a, b).mean() < flip(a, c).mean());
    CHECK(flip(a, c, 134.f).mean() < flip(a, c).mean());
    for (auto const error : flip(noise({50, 30}, 1), noise({50, 30}, 2)).error) CHECK((error >= 0.f && error <= 1.f));
}

TEST_CASE("flip: pure green against pure blue is the largest colour error") {
    auto const green = constant({16, 16}, {0.f, 1.f, 0.f}), blue = constant({16, 16}, {0.f, 0.f, 1.f});
    CHECK(flip(green, blue).mean() == doctest::Approx(1.).epsilon(1e-4));
}

TEST_CASE("flip: works at any size and at the ends of its range of distances") {
    for (auto const size : {Extent{1, 1}, Extent{2, 31}, Extent{33, 1}, Extent{5, 5}})
        for (auto const pixels_per_degree : {1.f, 2.f, 67.f, 300.f})
            for (auto const error : flip(noise(size, 1), noise(size, 2), pixels_per_degree).error)
                CHECK((quell::metrics::detail::is_finite(error) && error >= 0.f && error <= 1.f));
}

TEST_CASE("flip: pooling") {
    Flip const result{{5, 1}, {0.5f, 0.f, 0.125f, 0.25f, 0.125f}};
    CHECK(result.mean() == doctest::Approx(0.2));
    CHECK(result.weighted_median() == doctest::Approx(0.5)); // 0 + 0.125 + 0.125 + 0.25 make up just half of 1
    CHECK(result.mean({0, 0, 1, 1, 1}) == doctest::Approx(0.5 / 3.));
    CHECK(result.weighted_median({0, 7, 1, 1, 1}) == doctest::Approx(0.25));
    CHECK(result.weighted_median({0, 1, 0, 0, 0}) == 0.);
    CHECK(refuses([&] { (void)result.mean(Mask(6, 1)); }, {"mask", "6 entries", "5x1"}));
    CHECK(refuses([&] { (void)result.weighted_median(Mask(5, 0)); }, {"mask", "0 of the 5"}));
    CHECK(refuses([&] { (void)Flip{}.mean(); }, {"0x0", "1x1"}));
}

TEST_CASE("flip: refuses broken input") {
    refuses_broken_input([](auto const& a, auto const& b, auto const& mask) { return flip(a, b).mean(mask); });
    auto const a = noise({3, 3}, 1);
    for (auto const bad : {0.f, -67.f, 0.99f, 1e9f, std::numeric_limits<float>::quiet_NaN()})
        CHECK(refuses([&] { (void)flip(a, a, bad); }, {std::to_string(bad) + " pixels per degree", "1 to 10000"}));
}
