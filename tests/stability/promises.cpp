#include "../io/files.hpp"

#include <stability/judge.hpp>
#include <stability/known_limits.hpp>
#include <stability/results.hpp>
#include <stability/watch.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <sstream>

using namespace quell;
using namespace quell::stability;

TEST_CASE("a promise holds up to its limit, and never with a value that is no number") {
    CHECK(Promise{"case", "method", "metric", 1, 1}.held());
    CHECK(!Promise{"case", "method", "metric", 1.01, 1}.held());
    CHECK(Promise{"case", "method", "metric", 0.9, 0.9, true}.held());
    CHECK(!Promise{"case", "method", "metric", 0.89, 0.9, true}.held());
    auto const not_a_number = std::numeric_limits<double>::quiet_NaN();
    CHECK(!Promise{"case", "method", "metric", not_a_number, 1}.held());
    CHECK(!Promise{"case", "method", "metric", not_a_number, 1, true}.held());
}

TEST_CASE("a broken promise counts unless it is a known limit") {
    Results results;
    std::ostringstream out;
    results.promises = {{"case", "method", "kept", 0, 1}, {"case", "method", "broken", 2, 1}};
    CHECK(judge(results, out) == 1);
    CHECK(out.str() == "broken: case method broken 2, limit 1\n1 of 2 promises hold\n");
    REQUIRE(!known_limits().empty());
    auto const& known = known_limits().front();
    results.promises = {{known.subject, known.method, known.metric, 2, 1}};
    CHECK(judge(results, out) == 0);
    // It may hold by now: that is said, and no failure.
    results.promises.front().value = 0;
    out.str("");
    CHECK(judge(results, out) == 0);
    CHECK(out.str().find("holds, though a known limit") == 0);
}

TEST_CASE("tables have the columns of SCENES.md") {
    tests::Folder const folder;
    Results results;
    results.promises = {{"cut", "svgf", "metric", 0.5, 1}, {"cut", "none", "other", 0.5, 0.9, true}};
    results.frames = {{"cut", "svgf", 24, 0.125, 0.25}};
    write_tables(results, folder.path);
    CHECK(tests::bytes_of(folder / "stability.csv") ==
          "case,method,metric,value,limit,held\ncut,svgf,metric,0.5,1,1\ncut,none,other,0.5,0.9,0\n");
    CHECK(tests::bytes_of(folder / "frames.csv") == "case,method,frame,rmse,flip\ncut,svgf,24,0.125,0.25\n");
}

TEST_CASE("ratios are of one frame, and of means") {
    Errors const a{{24, 25}, {0.2, 0.1}, {0, 0}}, b{{24, 25}, {0.1, 0.2}, {0, 0}};
    CHECK(worst_ratio(a, b) == doctest::Approx(2));
    CHECK(worst_ratio(a, b, 25) == doctest::Approx(0.5));
    CHECK(mean_ratio(a, b) == doctest::Approx(1));
}

TEST_CASE("history is cut by numbers that don't follow each other") {
    Memory const all, none{Memory::Kind::none}, since{Memory::Kind::since, 5};
    for (int i = 1; i < 9; ++i) {
        CHECK(all.number(i) == all.number(i - 1) + 1);
        CHECK(none.number(i) != none.number(i - 1) + 1);
        CHECK((since.number(i) == since.number(i - 1) + 1) == (i != 5));
    }
}
