#include "../io/files.hpp"

#include <stability/cases.hpp>
#include <stability/known_limits.hpp>
#include <stability/options.hpp>
#include <stability/results.hpp>
#include <stability/watch.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

using namespace quell;
using namespace quell::stability;

namespace {
StabilityOptions options_of(std::vector<char const*> words) {
    words.insert(words.begin(), "quell-stability");
    return stability_options(static_cast<int>(words.size()), words.data()).value();
}
FrameError frame_error(std::string subject, std::string method, int frame, double rmse) {
    FrameError error{std::move(subject), std::move(method), frame};
    error.errors["rmse"] = rmse, error.errors["flip"] = 2 * rmse;
    return error;
}
} // namespace

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

TEST_CASE("tables have the columns that other tools rely on") {
    tests::Folder const folder;
    Results results;
    results.promises = {{"cut", "svgf", "metric", 0.5, 1}, {"cut", "none", "other", 0.5, 0.9, true}};
    results.frames = {frame_error("cut", "svgf", 24, 0.125)};
    write_tables(results, folder.path);
    CHECK(tests::bytes_of(folder / "stability.csv") ==
          "case,method,metric,value,limit,held\ncut,svgf,metric,0.5,1,1\ncut,none,other,0.5,0.9,0\n");
    CHECK(tests::bytes_of(folder / "frames.csv") == "case,method,frame,rmse,flip\ncut,svgf,24,0.125,0.25\n");
    results.frames.front().subject = "a,b.glb";
    write_tables(results, folder.path);
    CHECK(tests::bytes_of(folder / "frames.csv") == "case,method,frame,rmse,flip\n\"a,b.glb\",svgf,24,0.125,0.25\n");
}

TEST_CASE("ratios are of one frame, and of means") {
    FrameErrors const a{frame_error("", "", 24, 0.2), frame_error("", "", 25, 0.1)};
    FrameErrors const b{frame_error("", "", 24, 0.1), frame_error("", "", 25, 0.2)};
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

TEST_CASE("the command line says which cases, of what noise and how long") {
    auto const usual = options_of({});
    CHECK(usual.cases.empty());
    CHECK(usual.making.seed == 0);
    CHECK(usual.making.long_run == 10000);
    CHECK(options_of({"--case", "all", "--case", "cut"}).cases.empty());
    CHECK(options_of({"--case", "cut", "--case", "pan"}).cases == std::vector<std::string>{"cut", "pan"});
    auto const other = options_of({"--seed", "5", "--frames", "2000"});
    CHECK(other.making.seed == 5);
    CHECK(other.making.long_run == 2000);
    CHECK_THROWS_AS(options_of({"--frames", "100"}), Error);
}

TEST_CASE("another seed is another noise, held against the same truth") {
    Shot const shot{.scene = "fence", .scored_from = 0, .last = 0};
    Making const making{.size = {24, 16}, .threads = 1, .tolerance = 1, .max_samples = 4};
    auto reseeded = making;
    reseeded.seed = 5;
    auto const one = traced(shot, making), other = traced(shot, reseeded), again = traced(shot, making);
    CHECK(one.frame(0)["R"].values == again.frame(0)["R"].values);
    CHECK(one.frame(0)["R"].values != other.frame(0)["R"].values);
    CHECK(one.reference(0).pixels == other.reference(0).pixels);
}

TEST_CASE("cases whose truth is known have an error over time") {
    Making const making{.size = {24, 16}, .threads = 1, .long_run = 1200};
    for (std::string const name : {"firefly", "variance", "broken-input", "drift"}) {
        INFO(name);
        Results results;
        case_of(name).run(name, making, results);
        std::map<std::string, int> frames;
        for (auto const& each : results.frames) {
            CHECK(each.subject == name);
            CHECK(each.errors["rmse"] >= 0);
            ++frames[each.method];
        }
        for (auto const& promise : results.promises) CHECK(frames[promise.method] >= 10);
        if (name != "firefly") continue;
        auto const of = [&](std::string const& method, int frame) {
            auto const same = [&](FrameError const& each) { return each.method == method && each.frame == frame; };
            return std::ranges::find_if(results.frames, same)->errors["rmse"];
        };
        CHECK(of("surface", 11) < 1e-3);
        CHECK(of("surface", 12) > 1e-2);
        CHECK(of("svgf-suppress-fireflies", 12) < of("svgf", 12));
    }
}
