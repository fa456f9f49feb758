#include "report/base64.hpp"
#include "sample_report.hpp"
#include "written_page.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <regex>

using namespace quell::examples;
using nlohmann::json;

TEST_CASE("text arrives unchanged, whatever it would mean in HTML or in JSON") {
    std::string const nasty = "</script><!-- \"quoted\" & 'single' \\ back\n{{data}} ünïcödé 雪 \xf0\x9f\x8c\x8d";
    Report report = sample::make_bare_report();
    report.title = report.subtitle = nasty;
    report.notes = {{nasty, nasty, true}};
    report.tables = {{nasty, {nasty}, {{nasty}}}};
    json const data = data_of(write_and_read(report));
    CHECK(data["title"] == nasty);
    CHECK(data["subtitle"] == nasty);
    CHECK(data["notes"][0]["text"] == nasty);
    CHECK(data["tables"][0]["rows"][0][0] == nasty);
}

TEST_CASE("a title can't end the title element") {
    Report report = sample::make_bare_report();
    report.title = "a < b & c </title><script>";
    CHECK(write_and_read(report).find("<title>a &lt; b &amp; c &lt;/title&gt;&lt;script&gt;</title>") != std::string::npos);
}

TEST_CASE("bytes that aren't UTF-8 don't keep a report from being written") {
    Report report = sample::make_bare_report();
    report.title = "file \xff.exr";
    CHECK(data_of(write_and_read(report))["title"] == "file \xef\xbf\xbd.exr");
}

TEST_CASE("pictures are embedded whole, and those that a frame lacks are null") {
    Report const report = sample::make_report(8, 6, 2);
    std::string const page = write_and_read(report);
    json const frames = data_of(page)["frames"];
    CHECK(frames[0]["pictures"] == json::array({0, 1, 2, 3}));
    CHECK(frames[1]["pictures"] == json::array({4, 5, nullptr, nullptr}));
    CHECK(element_text(page, "picture-5") == "data:image/png;base64," + encode_base64(report.frames[1].pictures.at("denoised")));
    CHECK(data_of(page)["size"] == json({{"width", 8}, {"height", 6}}));
}

TEST_CASE("pictures that equal one another are embedded once") {
    Report report = sample::make_bare_report();
    report.frames.push_back({8, report.frames[0].pictures});
    std::string const page = write_and_read(report);
    CHECK(data_of(page)["frames"][1]["pictures"] == json::array({0}));
    CHECK(page.find("id=\"picture-1\"") == std::string::npos);
}

TEST_CASE("values come by metric and series; those that aren't finite are gaps") {
    Report report;
    report.add_value("FLIP", "noisy", 0, 0.5);
    report.add_value("FLIP", "denoised", 0, 0.25);
    report.add_value("FLIP", "noisy", 3, std::numeric_limits<double>::quiet_NaN());
    report.add_value("time", "denoised", 0, 4);
    json const metrics = data_of(write_and_read(report))["metrics"];
    REQUIRE(metrics.size() == 2);
    CHECK(metrics[0]["series"][0]["points"] == json::array({{0, 0.5}, {3, nullptr}}));
    CHECK(metrics[0]["series"][1]["name"] == "denoised");
    CHECK(metrics[1]["name"] == "time");
}

TEST_CASE("the page is sound without frames, kinds or metrics") {
    json const data = data_of(write_and_read({.title = "Nothing"}));
    CHECK(data["frames"].empty());
    CHECK(data["kinds"].empty());
    CHECK(data["metrics"].empty());
}

TEST_CASE("the page refers to nothing outside itself") {
    std::string const page = write_and_read(sample::make_report(8, 8, 2));
    CHECK(page.find("http://") == std::string::npos);
    CHECK(page.find("https://") == std::string::npos);
    CHECK_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:)")));
    CHECK_FALSE(std::regex_search(page, std::regex("@import|url\\(|import\\(|fetch\\(")));
    CHECK(page.find("{{") == std::string::npos);
}
