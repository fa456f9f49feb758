#include <doctest/doctest.h>
#include <quell/core/logarithm.hpp>

#include <algorithm>
#include <cmath>

using namespace quell;

TEST_CASE("a logarithm is that of the standard library, for packs too") {
    for (float const a : {1e-30f, 3e-7f, .5f, .70710677f, .70710678f, .99999f, 1.f, 1.00001f, 1.41421f, 1.41422f, 2.f, 123.f, 1e30f}) {
        CAPTURE(a);
        float const right = std::log(a);
        CHECK(std::abs(detail::logarithm(a) - right) <= 2e-7f * std::max(std::abs(right), 1.f));
        CHECK(lane(detail::logarithm(Pack(a)), 0) == doctest::Approx(right).epsilon(1e-6));
    }
}
