#include "quell/core/error.hpp"
#include "sample_report.hpp"
#include "written_page.hpp"

#include <doctest/doctest.h>

using namespace quell::examples;

TEST_CASE("writing leaves the page and nothing else, also over an older page") {
    Folder const folder;
    std::filesystem::path const file = folder.path / "index.html";
    write_report(sample::make_report(8, 8, 1), file);
    write_report(sample::make_bare_report(), file);
    CHECK(data_of(bytes_of(file))["title"] == "One picture");
    CHECK(folder.files() == 1);
}

TEST_CASE("a path that can't be written throws an error that names it") {
    Folder const folder;
    std::filesystem::path file = folder.path / "missing" / "index.html";
    SUBCASE("its folder is missing") {}
    SUBCASE("it is a folder itself") {
        file = folder.path / "taken";
        std::filesystem::create_directories(file / "full");
    }
    try {
        write_report(sample::make_bare_report(), file);
        FAIL("nothing was thrown");
    } catch (quell::Error const& error) {
        CHECK(error.subject == file.string());
        CHECK_FALSE(error.found.empty());
        CHECK_FALSE(error.remedy.empty());
    }
}

TEST_CASE("a report that contradicts itself leaves an older page as it was") {
    Folder const folder;
    std::filesystem::path const file = folder.path / "index.html";
    write_report(sample::make_bare_report(), file);
    Report report = sample::make_bare_report();
    report.kinds.clear();
    CHECK_THROWS_AS(write_report(report, file), quell::Error);
    CHECK(data_of(bytes_of(file))["title"] == "One picture");
    CHECK(folder.files() == 1);
}
