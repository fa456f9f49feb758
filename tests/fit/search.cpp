#include "flickering.hpp"
#include "small_contenders.hpp"

#include "fit/fit.hpp"

#include <quell/core/error.hpp>

#include <doctest/doctest.h>

#include <sstream>

using namespace quell::bench;
using quell::tests::FlickeringWall;

namespace {

struct Run {
    std::string said;
    Fitted fitted;
};

Run run(FlickeringWall& wall, Bounds const& bounds) {
    static auto const contenders = small_contenders();
    FitOptions options;
    options.bounds = bounds, options.threads = 1, options.quiet = true;
    std::ostringstream said;
    auto fitted = fit(wall, contenders, options, said);
    return {said.str(), std::move(fitted)};
}

bool says(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("a loose bound needs nothing, and the effects stay in the picture") {
    FlickeringWall wall;
    auto const [said, fitted] = run(wall, {.rmse = 0.9, .flip = {}, .ms = {}});
    CHECK(to_string(fitted.composition) == "rest by none");
    CHECK(fitted.composition.figures.ms == 1);
    CHECK(channels_of(fitted.composition) == std::vector<std::string>{"radiance"});
    CHECK(says(said, "left out: shadow"));
    CHECK_FALSE(says(said, "split off:")); // once something fits, nothing larger is looked at
}

TEST_CASE("a tight bound splits off what it takes, and says what the sequence lacks") {
    FlickeringWall wall;
    auto const found = run(wall, {.rmse = 0.08, .flip = {}, .ms = {}});
    INFO(found.said);
    auto const& [said, fitted] = found;
    CHECK(has(fitted.composition.split, Part::shadow));
    CHECK(fitted.composition.split.count() == 1);
    CHECK(fitted.composition.figures.rmse <= 0.08);
    CHECK(to_string(fitted.composition) == "shadow by short, rest by none"); // the cheaper of what leaves little of the shadow's noise
    CHECK(fitted.composition.figures.ms == 64 + 1);
    CHECK(says(said, "left out: glossy: no pixel reflects"));
    auto const channels = channels_of(fitted.composition);
    CHECK(std::ranges::count(channels, "visibility") == 1);
    CHECK(std::ranges::count(channels, "glossy") == 0);
}

TEST_CASE("memory is of halves where they do") {
    FlickeringWall wall;
    auto const found = run(wall, {.rmse = 0.08, .flip = {}, .ms = {}});
    CHECK(found.fitted.composition.memory() == Precision::half);
    CHECK(says(found.said, "memory: halves do: "));

    auto const with = [](double rmse, double bytes) {
        return Composition{.split = {}, .parts = {}, .figures = {.ms = 1, .rmse = rmse, .bytes_per_pixel = bytes}};
    };
    auto const floats = with(0.05, 60);
    Bounds const error{.rmse = 0.06, .flip = {}, .ms = {}}, time{.rmse = {}, .flip = {}, .ms = 2};
    CHECK(stands_in_for(with(0.059, 30), floats, error));
    CHECK_FALSE(stands_in_for(with(0.061, 30), floats, error));
    CHECK(stands_in_for(with(0.0505, 30), floats, time));
    CHECK_FALSE(stands_in_for(with(0.059, 30), floats, time)); // time is left, so error counts
    CHECK_FALSE(stands_in_for(with(0.05, 60), floats, error)); // nothing is gained
}

TEST_CASE("what follows an effect is tried only where it moves") {
    FlickeringWall wall;
    CHECK_FALSE(says(run(wall, {.rmse = 0.08, .flip = {}, .ms = {}}).said, "follower"));
    wall.blocker_moves = true;
    CHECK(says(run(wall, {.rmse = 0.08, .flip = {}, .ms = {}}).said, "follower"));
}

TEST_CASE("where something sweeps, motion blur is tried, and nothing is split off") {
    FlickeringWall wall;
    auto const still = run(wall, {.rmse = 0.9, .flip = {}, .ms = {}});
    CHECK_FALSE(says(still.said, "blurred"));
    CHECK(says(still.said, "left out: blur: nothing moves"));
    wall.sweeps = 2;
    auto const swept = run(wall, {.rmse = 0.9, .flip = {}, .ms = {}});
    CHECK(says(swept.said, "All as one colour: 3 compositions"));
    CHECK(swept.fitted.composition.split.none());
    CHECK_THROWS_AS(run(wall, {.rmse = 0.08, .flip = {}, .ms = {}}), OutOfReach);
}

TEST_CASE("what isn't there is never split off") {
    FlickeringWall wall;
    wall.in_shadow = false;
    wall.converged.resize(1);
    wall.converged[0].displayed = quell::metrics::displayed(wall.clean(24));
    auto const [said, fitted] = run(wall, {.rmse = 0.001, .flip = {}, .ms = {}});
    CHECK(to_string(fitted.composition) == "rest by none");
    CHECK(says(said, "left out: shadow: no pixel is in shadow"));
}

TEST_CASE("FLIP bounds as RMSE does") {
    FlickeringWall wall;
    auto const rough = run(wall, {.rmse = {}, .flip = 0.9, .ms = {}}).fitted.composition;
    auto const fine = run(wall, {.rmse = {}, .flip = 0.08, .ms = {}}).fitted.composition;
    CHECK(rough.split.none());
    CHECK(has(fine.split, Part::shadow));
    CHECK(*fine.figures.flip <= 0.08);
}

TEST_CASE("with all the time that there is, the result is as accurate as any") {
    FlickeringWall wall;
    auto const best = run(wall, {.rmse = {}, .flip = {}, .ms = 1e6}).fitted.composition;
    CHECK(has(best.split, Part::shadow));
    auto const in = [&](double ms) { return run(wall, {.rmse = {}, .flip = {}, .ms = ms}).fitted.composition; };
    CHECK(to_string(in(best.figures.ms)) == to_string(best));
    CHECK(in(best.figures.ms - 0.5).figures.rmse > best.figures.rmse); // anything cheaper is worse
    CHECK(in(best.figures.ms - 0.5).figures.ms < best.figures.ms);
    CHECK(to_string(in(1)) == "rest by none");
    CHECK_THROWS_AS(run(wall, {.rmse = 0.98 * best.figures.rmse, .flip = {}, .ms = {}}), OutOfReach);
}

TEST_CASE("what can't be reached is said with the best that there is") {
    FlickeringWall wall;
    try {
        run(wall, {.rmse = 1e-6, .flip = {}, .ms = {}});
        FAIL("nothing was thrown");
    } catch (OutOfReach const& error) {
        INFO(error.what());
        CHECK(says(error.what(), "RMSE 1e-06"));
        CHECK(says(error.what(), "the most accurate is shadow by"));
    }
    try {
        run(wall, {.rmse = {}, .flip = {}, .ms = 1e-9});
        FAIL("nothing was thrown");
    } catch (OutOfReach const& error) {
        CHECK(says(error.what(), "the fastest is rest by none: 1.00 ms"));
    }
}

TEST_CASE("a sequence without what the rest reads is refused") {
    FlickeringWall wall;
    wall.channels.erase("radiance");
    CHECK_THROWS_AS(run(wall, {.rmse = 0.9, .flip = {}, .ms = {}}), quell::Error);
}
