#include "chart/cases.hpp"
#include "chart/errors.hpp"
#include "chart/external.hpp"
#include "made_up_rows.hpp"

#include <quell/core/error.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace quell::bench;

namespace {

Row point(std::string method, double ms, double rmse, bool competes = true) {
    Row row{.scene = "s", .effect = "e", .method = std::move(method), .size = {2, 1}};
    row.ms_per_frame = ms, row.errors["rmse"] = rmse, row.competes = competes;
    return row;
}

std::string front(std::vector<Row> rows) {
    mark_pareto_front(rows);
    std::string names;
    for (auto const& row : rows)
        if (row.pareto) names += row.method;
    return names;
}

ChartOptions options_of(std::vector<char const*> words) {
    words.insert(words.begin(), "quell-chart");
    return chart_options(static_cast<int>(words.size()), words.data());
}

} // namespace

TEST_CASE("on the front is what nothing else is both faster and more accurate than") {
    CHECK(front({point("a", 1, 0.9), point("b", 2, 0.5), point("c", 3, 0.6), point("d", 4, 0.1)}) == "abd");
    CHECK(front({point("a", 1, 0.5), point("b", 1, 0.6)}) == "ab"); // as fast is not faster
    CHECK(front({point("a", 1, 0.5), point("b", 2, 0.5)}) == "ab"); // as accurate is not more accurate
    CHECK(front({point("a", 2, 0.5), point("b", 1, 0.4)}) == "b");
    CHECK(front({point("a", 2, 0.5), point("input", 1, 0.1, false)}) == "a"); // more samples don't compete
    CHECK(front({point("a", 1, Row::unknown), point("b", 2, 0.5)}) == "b");   // nor is what nobody measured
    CHECK(front({}).empty());
}

TEST_CASE("a row has the columns that other tools rely on, and nothing where nothing is known") {
    auto const of_metrics = [](auto&& cell) {
        std::string cells;
        for (auto const& metric : quell::metrics::all_metrics) (cells += ",") += cell(std::string(metric.name));
        return cells;
    };
    auto const none = of_metrics([](auto const&) { return ""; });
    CHECK(csv_header() == "scene,effect,method,width,height,frames,threads,ms_per_frame" +
                              of_metrics([](auto const& name) { return name; }) + ",flip_median" +
                              of_metrics([](auto const& name) { return "mask_" + name; }) + ",flicker,bytes_per_pixel,pareto");
    auto row = point("svgf", 12.3456, 0.0123456789);
    row.frames = 41, row.threads = 2, row.pareto = true, row.bytes_per_pixel = 68.55;
    CHECK(csv_line(row) == "s,e,svgf,2,1,41,2,12.346" + of_metrics([](auto const& name) { return name == "rmse" ? "0.012346" : ""; }) +
                               "," + none + ",,68.5,1");
    row.scene = "a,\"b\"";
    row.method = "b,c";
    CHECK(csv_line(row).starts_with("\"a,\"\"b\"\"\",e,\"b,c\",2,"));
}

TEST_CASE("flicker is measured by four frames that follow each other") {
    auto const marked = [](std::vector<long long> const& frames) {
        std::vector<Wanted> wanted;
        for (auto const frame : frames) wanted.push_back({frame, {}, {}});
        mark_flicker(wanted);
        std::vector<long long> found;
        for (auto const& one : wanted)
            if (one.shows_flicker) found.push_back(one.frame);
        return found;
    };
    CHECK(marked({24, 28, 31, 32, 33, 34, 36, 40}) == std::vector<long long>{31, 32, 33, 34});
    CHECK(marked({41, 42, 43, 44, 45, 46, 47, 48}) == std::vector<long long>{45, 46, 47, 48});
    CHECK(marked({24, 28, 31, 32}) == std::vector<long long>{31, 32});
    CHECK(marked({-1, 0, 1, 5, 6}) == std::vector<long long>{-1, 0, 1});
    CHECK(marked({24, 32, 40}).size() == 1); // of which nothing is known
    CHECK(marked({}).empty());
}

TEST_CASE("cases are the effects that the scenes were made for, or those that were asked for") {
    auto const named = [](std::vector<std::string> const& scenes, std::vector<std::string> const& effects) {
        std::string text;
        for (auto const& what : cases_of(scenes, effects)) text += what.scene + ":" + what.effect + " ";
        return text;
    };
    CHECK(named({"fence", "temple"}, {}) == "fence:shadow temple:glossy ");
    CHECK(named({"fence"}, {"composite"}) == "fence:composite ");
    CHECK(named({"cut", "lightswitch", "pan", "reverse"}, {}) ==
          "cut:composite lightswitch:composite lightswitch:indirect pan:indirect reverse:blur ");
    CHECK(named({"all"}, {"indirect"}).find("boxes:indirect disk:indirect ") != std::string::npos);
    CHECK(named({"all"}, {"indirect"}).find("fence") == std::string::npos);
    CHECK(named({"fence", "fence"}, {}) == "fence:shadow ");
    CHECK(named({"fence"}, {"shadow", "composite", "shadow"}) == "fence:shadow fence:composite ");
    CHECK(named({"some/file.glb"}, {}) == "some/file.glb:composite ");
    CHECK_THROWS_AS(static_cast<void>(cases_of({"fence"}, {"shine"})), quell::Error);
}

TEST_CASE("the command line is refused where it can't be used") {
    CHECK(options_of({"--scene", "fence", "--threads", "3"}).threads == 3);
    CHECK(options_of({"--scene", "fence"}).threads >= 1);
    CHECK(options_of({"--scene", "fence"}).scored_frames() == std::vector{24, 28, 31, 32, 33, 34, 36, 40});
    CHECK(options_of({"--scene", "fence", "--frames", "33"}).scored_frames() == std::vector{24, 28, 31, 32});
    CHECK(options_of({"--scene", "fence", "--scene", "temple", "--few"}).cases.size() == 2);
    CHECK(options_of({"--scene", "fence", "--frames", "9", "--times"}).scored_frames().empty());
    for (auto const& words : std::vector<std::vector<char const*>>{{"--size", "12"},
                                                                   {"--size", "0x9"},
                                                                   {"--frames", "24"},
                                                                   {"--frames", "8", "--times"},
                                                                   {"--effect", "shine"},
                                                                   {"--external", "name"},
                                                                   {"--external", "=x {in} {out}"},
                                                                   {"--external", "a=x {in}"},
                                                                   {"--external", "a/b=x {in} {out}"},
                                                                   {"--external", "..=x {in} {out}"},
                                                                   {"--external", ".a=x {in} {out}"},
                                                                   {"--external", "reference=x {in} {out}"},
                                                                   {"--external", "a=x {in} {out}", "--external", "a=y {in} {out}"}})
        CHECK_THROWS_AS(options_of(words), quell::Error);
}

TEST_CASE("paths take their places in a command, quoted where the shell would take them apart") {
    CHECK(filled_in("run {in} -o {out} {in}", "/tmp/a.%04d.exr", "/tmp/b.%04d.exr") ==
          "run /tmp/a.%04d.exr -o /tmp/b.%04d.exr /tmp/a.%04d.exr");
    CHECK(filled_in("run {in}", "/my files/it's.exr", "") == "run '/my files/it'\\''s.exr'");
}
