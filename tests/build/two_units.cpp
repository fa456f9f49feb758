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

#if defined(QUELL_TEST_OLDER_UNIT)
// Variables and functions of one name would be the linker's choice: the machine may lack the instructions, and packs are of another width.
TEST_CASE("a unit for another instruction set has code and variables of its own, and computes the same") {
    auto const here = seen_here(), older = seen_by_older_unit();
    CHECK(here.channel != older.channel);
    CHECK(here.table != older.table);
    CHECK(older.width == 9);
    CHECK(older.pixel == doctest::Approx(here.pixel).epsilon(2e-5));
}
#endif
