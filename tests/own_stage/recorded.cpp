// A stage of a host's own as shaders.
#include "own_stage.hpp"

#include <doctest/doctest.h>

#include <library/recorded_presets.hpp>
#include <quell/pipeline/plan.hpp>

TEST_CASE("a stage of one's own is recorded with the others") {
    auto const all = quell::shaders::recorded_stages();
    CHECK(all.front().name == "light");
    REQUIRE(all.size() > 2);
    CHECK(all.back().name == "resolve");
    auto const& own = all[all.size() - 2];
    REQUIRE(own.name == "half");
    auto const plan = own.record({}, 1.f);
    CHECK(plan.name == "half");
    CHECK(plan.passes.size() == plan_of(std::get<0>(own_stages).make({})).passes.size());
}
