#include "report/check.hpp"
#include "quell/core/error.hpp"
#include "sample_report.hpp"

#include <doctest/doctest.h>

using namespace quell::examples;

namespace {

std::string complaint_about(Report const& report) {
    try {
        check_report(report);
    } catch (quell::Error const& error) {
        return error.what();
    }
    return "";
}

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("reports without contradictions pass") {
    CHECK(complaint_about({}) == "");
    CHECK(complaint_about(sample::make_bare_report()) == "");
    CHECK(complaint_about(sample::make_report(8, 8, 3)) == "");
}

TEST_CASE("a picture of a kind that the report doesn't list is refused by name") {
    Report report = sample::make_bare_report();
    report.frames[0].pictures["nosiy"] = report.frames[0].pictures["noisy"];
    CHECK(contains(complaint_about(report), "frame 7: has a picture of the unknown kind \"nosiy\""));
}

TEST_CASE("bytes that aren't a PNG file are refused") {
    Report report = sample::make_bare_report();
    std::vector<unsigned char>& bytes = report.frames[0].pictures["noisy"];
    SUBCASE("none at all") { bytes.clear(); }
    SUBCASE("cut off inside the header") { bytes.resize(20); }
    SUBCASE("another signature") { bytes[1] = 'J'; }
    SUBCASE("no width") { std::fill_n(bytes.begin() + 16, 4, static_cast<unsigned char>(0)); }
    CHECK(contains(complaint_about(report), "picture \"noisy\" of frame 7: is"));
}

TEST_CASE("frames have to ascend") {
    Report report = sample::make_report(8, 8, 2);
    SUBCASE("the same number twice") { report.frames[1].number = 0; }
    SUBCASE("backwards") { report.frames[1].number = -1; }
    CHECK(contains(complaint_about(report), "comes after frame 0"));
}

TEST_CASE("kinds need names of their own and scales need two colors") {
    Report report;
    report.kinds = {{"noisy"}, {"noisy"}};
    CHECK(contains(complaint_about(report), "is listed twice"));
    report.kinds = {{"error", "", ColorScale{"FLIP", 0, 1, {"#000000"}}}};
    CHECK(contains(complaint_about(report), "fewer than two colors"));
}

TEST_CASE("a table's rows have as many cells as it has columns") {
    Report report;
    report.tables = {{"times", {"step", "ms"}, {{"blend", "1.2"}, {"filter"}}}};
    CHECK(contains(complaint_about(report), "table \"times\": has a row of 1 cells under 2 columns"));
}

TEST_CASE("the size of a picture is read from its header") {
    PictureSize const size = png_size(sample::make_bare_report().frames[0].pictures["noisy"], "picture");
    CHECK(size.width == 64);
    CHECK(size.height == 48);
}
