#include "../frames.hpp"

using namespace quell;

TEST_CASE("random numbers are normally distributed: mean 0, deviation 1, independent, in every direction") {
    double sum = 0, squares = 0, fourth = 0, products = 0, along_row = 0, along_column = 0, over_time = 0;
    int const side = 200;
    int beyond = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            auto const at = [](int i, int j, int frame) { return normal_pair(static_cast<float>(i), static_cast<float>(j), frame); };
            auto const [a, b] = at(x, y, 7);
            sum += a, squares += a * a, fourth += a * a * a * a, products += a * b;
            along_row += a * at(x + 1, y, 7).first, along_column += a * at(x, y + 1, 7).first, over_time += a * at(x, y, 8).first;
            beyond += std::abs(a) > 2;
            REQUIRE(std::abs(a) < 3.5f);
        }
    // 40,000 numbers: a mean of products of independent ones has a deviation of 0.005.
    double const n = side * side;
    CHECK(std::abs(sum / n) < 0.02);
    CHECK(squares / n == doctest::Approx(1).epsilon(0.03));
    CHECK(fourth / n > 2.5);
    CHECK(fourth / n < 3.1);
    CHECK(beyond / n == doctest::Approx(0.0455).epsilon(0.1));
    for (double const a : {products, along_row, along_column, over_time}) CHECK(std::abs(a / n) < 0.02);
}

TEST_CASE("one number and a pack of numbers agree to the last bit, and come again") {
    for (std::int32_t const frame : {0, 1, 1000000, -3})
        for (int y = 0; y < 40; ++y) {
            auto const pack = normal_pair(Pack(float(5 * y)) + lanes<Pack>(), Pack(static_cast<float>(y)), frame);
            for (int i = 0; i < width_of<Pack>; ++i) {
                auto const one = normal_pair(static_cast<float>(5 * y + i), static_cast<float>(y), frame);
                CHECK(lane(pack.first, i) == one.first);
                CHECK(lane(pack.second, i) == one.second);
            }
        }
    CHECK(normal_pair(3.f, 4.f, 5) == normal_pair(3.f, 4.f, 5));
    CHECK(normal_pair(3.f, 4.f, 5) != normal_pair(4.f, 3.f, 5));
    CHECK(normal_pair(3.f, 4.f, 5) != normal_pair(3.f, 4.f, 6));
}

TEST_CASE("uniform numbers fill [0, 1) evenly, and a pack has the same") {
    int const side = 200, parts = 10;
    int count[parts] = {};
    double products = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            auto const [a, b] = uniform_pair(static_cast<float>(x), static_cast<float>(y), 3);
            REQUIRE((a >= 0 && a < 1 && b >= 0 && b < 1));
            ++count[static_cast<int>(a * parts)];
            products += (a - 0.5) * (b - 0.5);
        }
    // 4,000 in each part: a deviation of 60. A product has a deviation of 1/12.
    for (int const n : count) CHECK(std::abs(n - side * side / parts) < 240);
    CHECK(std::abs(products / (side * side)) < 0.002);
    auto const pack = uniform_pair(Pack(7.f) + lanes<Pack>(), Pack(9.f), 5);
    for (int i = 0; i < width_of<Pack>; ++i) {
        auto const one = uniform_pair(static_cast<float>(7 + i), 9.f, 5);
        CHECK(lane(pack.first, i) == one.first);
        CHECK(lane(pack.second, i) == one.second);
    }
}
