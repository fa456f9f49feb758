#include "flickering.hpp"

#include "fit/survey.hpp"

#include <doctest/doctest.h>

using namespace quell::bench;
using quell::tests::FlickeringWall;

TEST_CASE("a survey sees what is there and what of it moves") {
    FlickeringWall wall;
    Survey const still(wall);
    CHECK(still[Part::shadow].present);
    CHECK_FALSE(still[Part::shadow].moves);
    CHECK_FALSE(still[Part::glossy].present);
    CHECK(still[Part::indirect].present);
    CHECK_FALSE(still[Part::indirect].moves);
    wall.blocker_moves = true;
    CHECK(Survey(wall)[Part::shadow].moves);
}

TEST_CASE("effects whose channels are missing can't be split off") {
    Traces const everything{0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
    auto const verdicts = detail::verdicts_on(everything, {"radiance", "direct", "visibility", "albedo"});
    CHECK(verdicts[0].present);
    CHECK_FALSE(verdicts[1].present);
    CHECK(verdicts[1].evidence.find("'glossy'") != std::string::npos);
    CHECK_FALSE(verdicts[2].present);
    CHECK(verdicts[2].evidence.find("'indirect'") != std::string::npos);
}

TEST_CASE("motion blur is there where something sweeps, and nothing is split off then") {
    FlickeringWall wall;
    Survey const still(wall);
    CHECK_FALSE(still.blur().present);
    CHECK(still[Part::shadow].splits);
    wall.sweeps = 3;
    Survey const swept(wall);
    CHECK(swept.blur().present);
    CHECK(swept[Part::shadow].present);
    CHECK_FALSE(swept[Part::shadow].splits);
    wall.channels.erase("time");
    CHECK_FALSE(Survey(wall).blur().present);
    CHECK(Survey(wall)[Part::shadow].splits);
}

TEST_CASE("less than a thousandth of the pixels is nothing") {
    std::set<std::string> const all{"visibility", "direct", "glossy", "indirect", "albedo"};
    CHECK_FALSE(detail::verdicts_on({.shadowed = 0.0009}, all)[0].present);
    CHECK(detail::verdicts_on({.shadowed = 0.0011}, all)[0].present);
    CHECK_FALSE(detail::verdicts_on({.reflecting = 0.2, .reflection_moves = 0.0009}, all)[1].moves);
    CHECK(detail::verdicts_on({.reflecting = 0.2, .reflection_moves = 0.0011}, all)[1].moves);
}
