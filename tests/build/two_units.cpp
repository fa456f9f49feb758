#include "two_units.hpp"

#include <doctest/doctest.h>

// A function that is not inline would not link; a variable that is not inline would have two addresses.
TEST_CASE("two translation units with all headers link and agree") {
    auto const here = seen_here(), there = seen_by_other_unit();
    CHECK(here.channel == there.channel);
    CHECK(here.table == there.table);
    CHECK(here.pixel == there.pixel);
    CHECK(here.pixel == doctest::Approx(7 * 0.125f));
}
